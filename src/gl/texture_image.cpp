// Texture images from client memory: TexImage, TexSubImage (GL 1.5 §3.8.1, §3.8.2).
//
// A new image is made and filled aside and then put into the level, so that a failure leaves everything as it
// was and queued draws keep the image they refer to.
#include <new>
#include <utility>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/mipmap.h"
#include "gl/pixel_buffers.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

// GL 1.5 §3.8.11: a proxy holds the state of the image that would be made, or nothing where none could.
void specify_proxy(const ImageTarget& target, const LevelSpec& spec, const TexelFormat& format) {
    TextureLevel& level = target.level(spec.level);
    level = {};
    if (!is_supported_size(spec, target.is_cube()) || !is_supported_memory(spec, format)) return;
    level = {spec.width,           spec.height, spec.depth, spec.border,
             spec.internal_format, &format,     nullptr,    nullptr};
}

// Whether the level's image can be filled anew instead of being replaced. Then nothing is allocated and
// nothing can fail: programs that stream pictures through glTexImage save the page faults.
bool can_refill(Context& ctx, const TextureLevel& level, const LevelSpec& spec, const TexelFormat& format) {
    ctx.drawing.state.fragment.reset();  // stale now, and it would count as a reference to the image
    return level.format == &format &&
           has_stencil(level.internal_format) == has_stencil(spec.internal_format) &&
           level.width == spec.width && level.height == spec.height && level.depth == spec.depth &&
           level.border == spec.border && level.image && !level.image.in_use() && !level.blocks &&
           !find_block_format(static_cast<GLenum>(spec.internal_format));
}

void specify_image(Context& ctx, const ImageTarget& target, const LevelSpec& spec, const TexelFormat& format,
                   const ClientImage& client) {
    if (!is_supported_size(spec, target.is_cube()))
        return record_error(ctx, GL_INVALID_VALUE, "the size is not supported");
    if (!is_supported_memory(spec, format)) throw std::bad_alloc();
    const LevelBox all{-spec.border, -spec.border_y(), -spec.border_z(), spec.width, spec.height, spec.depth};
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = target.level(spec.level);
    const bool brings_stencil = client.format == GL_DEPTH_STENCIL && has_stencil(spec.internal_format);
    if (client.pixels && can_refill(ctx, level, spec, format)) {
        if (brings_stencil) level.image->make_stencils();
        const GLint format_before = std::exchange(level.internal_format, spec.internal_format);
        try {
            DerivedLevels derived(target, spec.level, level);
            level.image->content_changes();
            upload(ctx.pixels, client, format, all, spec.dimensions, *level.image);
            derived.store();
        } catch (...) {
            level.internal_format = format_before;
            throw;
        }
        return;
    }
    TextureLevel made = make_level(spec, format);
    if (brings_stencil && made.image) made.image->make_stencils();
    if (client.pixels && made.image) upload(ctx.pixels, client, format, all, spec.dimensions, *made.image);
    if (!client.pixels && made.image) clear_texels(*made.image);
    compress_level(made);
    DerivedLevels derived(target, spec.level, made);
    level = std::move(made);
    derived.store();
}

// Depth textures have one or two dimensions, or are cube maps as in the reference and since GL 3.0; GL 1.5
// §3.8.1 has none of these yet.
Rule check_depth_target(const ImageTarget& target, const TexelFormat& format) {
    if (format.base != GL_DEPTH_COMPONENT || target.dimensions < 3) return {};
    return {GL_INVALID_OPERATION, "there are no depth textures of this target"};
}

void tex_image(Context& ctx, GLenum target_name, LevelSpec spec, const ClientImage& client) {
    if (const Rule rule = check_compression(spec); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    spec.internal_format = without_compression(spec.internal_format);
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.dimensions != spec.dimensions)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    Rule rule = check_level_spec(spec, target.is_cube());
    if (rule.code == GL_NO_ERROR) rule = check_texture_pixels(client.format, client.type);
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    const TexelFormat* format =
        choose_texel_format(spec.internal_format, client.format, client.type, ctx.pixels.unpack.swap_bytes);
    if (!format) return record_error(ctx, GL_INVALID_VALUE, "unknown internal format");
    rule = check_pixels_fit(client.format, *format);
    if (rule.code == GL_NO_ERROR) rule = check_depth_target(target, *format);
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    if (target.is_proxy) return specify_proxy(target, spec, *format);
    const PixelMemory memory =
        find_image(ctx, ctx.pixels.unpack, {spec.width, spec.height, spec.depth, spec.dimensions},
                   client.format, client.type, client.pixels);
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    specify_image(ctx, target, spec, *format, {client.format, client.type, memory.data});
}

void tex_sub_image(Context& ctx, GLenum target_name, GLint level_number, const LevelBox& box, int dimensions,
                   const ClientImage& client) {
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy || target.dimensions != dimensions)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    if (box.width < 0 || box.height < 0 || box.depth < 0)
        return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    if (const Rule rule = check_texture_pixels(client.format, client.type); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    settle_framebuffers(ctx);
    const PixelMemory memory =
        find_image(ctx, ctx.pixels.unpack, {box.width, box.height, box.depth, dimensions}, client.format,
                   client.type, client.pixels);
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = target.level(level_number);
    if (!level.format) return record_error(ctx, GL_INVALID_OPERATION, "the level has no image");
    if (const Rule rule = check_pixels_fit(client.format, *level.format); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    if (!contains(level, box)) return record_error(ctx, GL_INVALID_VALUE, "the rectangle leaves the image");
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    if (const Rule rule = check_blocks(level, box); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    if (!memory.data || !level.image || box.is_empty()) return;
    const auto blocks = level.blocks ? std::make_shared<CompressedBlocks>(*level.blocks) : nullptr;
    raster::TextureImage& image = writable_image(ctx, level);
    if (client.format == GL_DEPTH_STENCIL && has_stencil(level.internal_format)) image.make_stencils();
    DerivedLevels derived(target, level_number, level);
    upload(ctx.pixels, {client.format, client.type, memory.data}, *level.format, box, dimensions, image);
    if (blocks) recompress(image, box.x, box.y, box.width, box.height, *blocks);
    level.blocks = blocks;
    derived.store();
}

}  // namespace

void tex_image_1d(Context& ctx, GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border,
                  GLenum format, GLenum type, const void* pixels) {
    tex_image(ctx, target, {level, internalformat, width, 1, 1, border, 1}, {format, type, pixels});
}

void tex_image_2d(Context& ctx, GLenum target, GLint level, GLint internalformat, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    tex_image(ctx, target, {level, internalformat, width, height, 1, border, 2}, {format, type, pixels});
}

void tex_image_3d(Context& ctx, GLenum target, GLint level, GLint internalformat, GLsizei width,
                  GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                  const void* pixels) {
    tex_image(ctx, target, {level, internalformat, width, height, depth, border, 3}, {format, type, pixels});
}

void tex_sub_image_1d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                      GLenum type, const void* pixels) {
    tex_sub_image(ctx, target, level, {xoffset, 0, 0, width, 1, 1}, 1, {format, type, pixels});
}

void tex_sub_image_2d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                      GLsizei height, GLenum format, GLenum type, const void* pixels) {
    tex_sub_image(ctx, target, level, {xoffset, yoffset, 0, width, height, 1}, 2, {format, type, pixels});
}

void tex_sub_image_3d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                      GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                      const void* pixels) {
    tex_sub_image(ctx, target, level, {xoffset, yoffset, zoffset, width, height, depth}, 3,
                  {format, type, pixels});
}

}  // namespace terrazzo::gl
