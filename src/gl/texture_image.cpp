// Texture images from client memory: TexImage, TexSubImage (GL 1.5 §3.8.1, §3.8.2).
//
// A new image is made and filled aside and then put into the level, so that a failure leaves everything as it
// was and queued draws keep the image they refer to.
#include <new>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

// The proxy that `target` names; null when it names none of this dimension.
TextureObject* find_proxy(Context& ctx, GLenum target, bool is_1d) {
    if (target != (is_1d ? GL_PROXY_TEXTURE_1D : GL_PROXY_TEXTURE_2D)) return nullptr;
    return &ctx.texture.proxies[is_1d ? kTexture1D : kTexture2D];
}

// GL 1.5 §3.8.11: a proxy holds the state of the image that would be made, or nothing where none could.
void specify_proxy(TextureObject& proxy, const LevelSpec& spec, const TexelFormat& format) {
    TextureLevel& level = proxy.levels[static_cast<size_t>(spec.level)];
    level = {};
    if (!is_supported_size(spec) || !is_supported_memory(spec, format)) return;
    level = {spec.width, spec.height, spec.border, spec.internal_format, &format, nullptr};
}

// Whether the level's image can be filled anew instead of being replaced. Then nothing is allocated and
// nothing can fail: programs that stream pictures through glTexImage save the page faults.
bool can_refill(Context& ctx, const TextureLevel& level, const LevelSpec& spec, const TexelFormat& format) {
    ctx.drawing.state.fragment.reset();  // stale now, and it would count as a reference to the image
    return level.format == &format && level.width == spec.width && level.height == spec.height &&
           level.border == spec.border && level.image && !level.image.in_use();
}

void specify_image(Context& ctx, TextureObject& object, const LevelSpec& spec, const TexelFormat& format,
                   const ClientImage& client) {
    if (!is_supported_size(spec)) return record_error(ctx, GL_INVALID_VALUE, "the size is not supported");
    if (!is_supported_memory(spec, format)) throw std::bad_alloc();
    const LevelRect all{-spec.border, -spec.border_y(), spec.width, spec.height};
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = object.levels[static_cast<size_t>(spec.level)];
    if (client.pixels && can_refill(ctx, level, spec, format)) {
        upload(ctx.pixels, client, format, all, *level.image);
        level.internal_format = spec.internal_format;
        return;
    }
    TextureLevel made = make_level(spec, format);
    if (client.pixels && made.image) upload(ctx.pixels, client, format, all, *made.image);
    level = std::move(made);
}

void tex_image(Context& ctx, GLenum target, const LevelSpec& spec, const ClientImage& client) {
    TextureObject* proxy = find_proxy(ctx, target, spec.is_1d);
    const bool is_texture = target == (spec.is_1d ? GL_TEXTURE_1D : GL_TEXTURE_2D);
    if (!proxy && !is_texture) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    Rule rule = check_level_spec(spec);
    if (rule.code == GL_NO_ERROR) rule = check_texture_pixels(client.format, client.type);
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    const TexelFormat* format =
        choose_texel_format(spec.internal_format, client.format, client.type, ctx.pixels.unpack.swap_bytes);
    if (!format) return record_error(ctx, GL_INVALID_VALUE, "unknown internal format");
    if (proxy) return specify_proxy(*proxy, spec, *format);
    specify_image(ctx, *bound_texture(ctx, target), spec, *format, client);
}

void tex_sub_image(Context& ctx, GLenum target, GLint level_number, const LevelRect& rect,
                   const ClientImage& client) {
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    if (rect.width < 0 || rect.height < 0) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    if (const Rule rule = check_texture_pixels(client.format, client.type); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = bound_texture(ctx, target)->levels[static_cast<size_t>(level_number)];
    if (!level.format) return record_error(ctx, GL_INVALID_OPERATION, "the level has no image");
    if (!contains(level, rect)) return record_error(ctx, GL_INVALID_VALUE, "the rectangle leaves the image");
    if (!client.pixels || !level.image || rect.width == 0 || rect.height == 0) return;
    upload(ctx.pixels, client, *level.format, rect, writable_image(ctx, level));
}

}  // namespace

void tex_image_1d(Context& ctx, GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border,
                  GLenum format, GLenum type, const void* pixels) {
    tex_image(ctx, target, {level, internalformat, width, 1, border, true}, {format, type, pixels});
}

void tex_image_2d(Context& ctx, GLenum target, GLint level, GLint internalformat, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    tex_image(ctx, target, {level, internalformat, width, height, border, false}, {format, type, pixels});
}

void tex_sub_image_1d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                      GLenum type, const void* pixels) {
    if (target != GL_TEXTURE_1D) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    tex_sub_image(ctx, target, level, {xoffset, 0, width, 1}, {format, type, pixels});
}

void tex_sub_image_2d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                      GLsizei height, GLenum format, GLenum type, const void* pixels) {
    if (target != GL_TEXTURE_2D) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    tex_sub_image(ctx, target, level, {xoffset, yoffset, width, height}, {format, type, pixels});
}

}  // namespace terrazzo::gl
