// Texture images from the frame buffer: CopyTexImage, CopyTexSubImage (GL 1.5 §3.8.2).
//
// Texels whose pixels lie outside the window are undefined by the specification: here they are 0 in a new
// image and stay as they were in an old one.
#include <algorithm>
#include <new>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/mipmap.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "gl/read_source.h"
#include "gl/texel_row.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

// Copies the depths from window position (x, y) on, in the image's number of bits.
void copy_depths(const PixelState& state, const ReadSource& source, const ReadRect& read, GLint left,
                 GLint bottom, const TexelFormat& format, raster::TextureImage& image) {
    const unsigned from = source.format().depth_bits, to = format.bits[0];
    const double scale = 1.0 / static_cast<double>((uint64_t{1} << from) - 1);
    for (int i = 0; i < read.height; ++i) {
        for (int j = 0; j < read.width; j += kPixelChunk) {
            const int count = std::min(kPixelChunk, read.width - j);
            uint32_t* const depths = image.depths(left + j, bottom + i);
            source.read_depths(read.x + j, read.y + i, count, depths);
            if (!changes_depths(state)) {
                for (int k = 0; k < count; ++k) depths[k] = resize_depth(depths[k], from, to);
                continue;
            }
            float values[kPixelChunk];
            for (int k = 0; k < count; ++k) values[k] = static_cast<float>(depths[k] * scale);
            transfer_depths(state, values, count);
            for (int k = 0; k < count; ++k) depths[k] = depth_integer(values[k], static_cast<int>(to));
        }
    }
}

// The same of stencil values, for an image that keeps them.
void copy_stencils(const PixelState& state, const ReadSource& source, const ReadRect& read, GLint left,
                   GLint bottom, raster::TextureImage& image) {
    for (int i = 0; i < read.height; ++i) {
        for (int j = 0; j < read.width; j += kPixelChunk) {
            const int count = std::min(kPixelChunk, read.width - j);
            uint8_t* const stencils = image.stencils(left + j, bottom + i);
            source.read_stencils(read.x + j, read.y + i, count, stencils);
            if (!changes_stencils(state)) continue;
            uint32_t indices[kPixelChunk];
            std::copy_n(stencils, count, indices);
            transfer_stencils(state, indices, count);
            for (int k = 0; k < count; ++k) stencils[k] = static_cast<uint8_t>(indices[k]);
        }
    }
}

// Copies the pixels from window position (x, y) on into `box` of the image, whose depth is 1.
void copy_pixels(const PixelState& state, const ReadSource& source, GLint x, GLint y, const LevelBox& box,
                 const TexelFormat& format, raster::TextureImage& image) {
    const ReadRect read = source.clip(x, y, box.width, box.height);
    const GLint left = box.x + read.skipped_columns, bottom = box.y + read.skipped_rows;
    if (format.base == GL_DEPTH_COMPONENT) {
        copy_depths(state, source, read, left, bottom, format, image);
        if (image.has_stencils()) copy_stencils(state, source, read, left, bottom, image);
        return;
    }
    const bool bytes = source.has_bytes(state);
    const bool direct = bytes && stores_groups(format, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int i = 0; i < read.height; ++i) {
        for (int j = 0; j < read.width; j += kPixelChunk) {
            const int count = std::min(kPixelChunk, read.width - j);
            if (direct) {
                source.read(read.x + j, read.y + i, count, image.rgba8(left + j, bottom + i, box.z));
            } else if (bytes) {
                uint8_t rgba[4 * kPixelChunk];
                source.read(read.x + j, read.y + i, count, rgba);
                store_texels(format, rgba, Rounding::kAsDrawn, count, image, left + j, bottom + i, box.z);
            } else {
                float rgba[4 * kPixelChunk];
                source.read(read.x + j, read.y + i, count, state, rgba);
                store_texels(format, rgba, Rounding::kOnce, count, image, left + j, bottom + i, box.z);
            }
        }
    }
}

Rule check_source(const Context& ctx, const TexelFormat& format, GLint internal_format) {
    const auto source = read_target(ctx);
    if (!source) return {GL_INVALID_FRAMEBUFFER_OPERATION, "there is no buffer to read from"};
    if (format.base == GL_DEPTH_COMPONENT && source->format().depth_bits == 0)
        return {GL_INVALID_OPERATION, "there is no depth buffer"};
    if (has_stencil(internal_format) && source->format().stencil_bits == 0)
        return {GL_INVALID_OPERATION, "there is no stencil buffer"};
    if (format.base != GL_DEPTH_COMPONENT && !has_read_colors(ctx))
        return {GL_INVALID_OPERATION, "there is no colour buffer"};
    return {};
}

void copy_tex_image(Context& ctx, GLenum target_name, LevelSpec spec, GLint x, GLint y) {
    if (const Rule rule = check_compression(spec); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    spec.internal_format = without_compression(spec.internal_format);
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy || target.dimensions != spec.dimensions)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (const Rule rule = check_level_spec(spec, target.is_cube()); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    // GL 1.5 §3.8.2: the component counts 1 to 4 are no formats here.
    const TexelFormat* format = choose_texel_format(spec.internal_format, GL_RGBA, GL_UNSIGNED_BYTE, false);
    if (!format || spec.internal_format <= 4)
        return record_error(ctx, GL_INVALID_ENUM, "unknown internal format");
    if (!is_supported_size(spec, target.is_cube()))
        return record_error(ctx, GL_INVALID_VALUE, "the size is not supported");
    if (!is_supported_memory(spec, *format)) throw std::bad_alloc();
    if (!check_readable_framebuffer(ctx)) return;
    if (const Rule rule = check_source(ctx, *format, spec.internal_format); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    TextureLevel level = make_level(spec, *format);
    const ReadSource source(ctx);
    if (level.image) {
        if (has_stencil(spec.internal_format)) level.image->make_stencils();
        const LevelBox all{-spec.border, -spec.border_y(), 0, spec.width, spec.height, 1};
        const ReadRect seen = source.clip(x, y, spec.width, spec.height);
        if (seen.width != spec.width || seen.height != spec.height) clear_texels(*level.image);
        copy_pixels(ctx.pixels, source, x, y, all, *format, *level.image);
        compress_level(level);
    }
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    DerivedLevels derived(target, spec.level, level);
    target.level(spec.level) = std::move(level);
    derived.store();
}

void copy_tex_sub_image(Context& ctx, GLenum target_name, GLint level_number, const LevelBox& box,
                        int dimensions, GLint x, GLint y) {
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy || target.dimensions != dimensions)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    if (box.width < 0 || box.height < 0) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    begin_change(ctx, Dirty::kTexture);
    const TexelFormat* format = nullptr;
    GLint internal_format = 0;
    {
        const auto lock = lock_textures(ctx);
        format = target.level(level_number).format;
        internal_format = target.level(level_number).internal_format;
    }
    if (!format) return record_error(ctx, GL_INVALID_OPERATION, "the level has no image");
    if (!check_readable_framebuffer(ctx)) return;
    if (const Rule rule = check_source(ctx, *format, internal_format); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    settle_framebuffers(ctx);
    const ReadSource source(ctx);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = target.level(level_number);
    if (level.format != format || level.internal_format != internal_format)
        return record_error(ctx, GL_INVALID_OPERATION, "the level has changed");
    if (!contains(level, box)) return record_error(ctx, GL_INVALID_VALUE, "the rectangle leaves the image");
    if (const Rule rule = check_blocks(level, box); rule.code != GL_NO_ERROR)
        return record_error(ctx, rule.code, rule.words);
    if (!level.image || box.is_empty()) return;
    const auto blocks = level.blocks ? std::make_shared<CompressedBlocks>(*level.blocks) : nullptr;
    raster::TextureImage& image = writable_image(ctx, level);
    if (has_stencil(internal_format)) image.make_stencils();
    DerivedLevels derived(target, level_number, level);
    copy_pixels(ctx.pixels, source, x, y, box, *level.format, image);
    if (blocks) recompress(image, box.x, box.y, box.width, box.height, *blocks);
    level.blocks = blocks;
    derived.store();
}

}  // namespace

void copy_tex_image_1d(Context& ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                       GLsizei width, GLint border) {
    copy_tex_image(ctx, target, {level, static_cast<GLint>(internalformat), width, 1, 1, border, 1}, x, y);
}

void copy_tex_image_2d(Context& ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                       GLsizei width, GLsizei height, GLint border) {
    copy_tex_image(ctx, target, {level, static_cast<GLint>(internalformat), width, height, 1, border, 2}, x,
                   y);
}

void copy_tex_sub_image_1d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                           GLsizei width) {
    copy_tex_sub_image(ctx, target, level, {xoffset, 0, 0, width, 1, 1}, 1, x, y);
}

void copy_tex_sub_image_2d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                           GLint y, GLsizei width, GLsizei height) {
    copy_tex_sub_image(ctx, target, level, {xoffset, yoffset, 0, width, height, 1}, 2, x, y);
}

void copy_tex_sub_image_3d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                           GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    copy_tex_sub_image(ctx, target, level, {xoffset, yoffset, zoffset, width, height, 1}, 3, x, y);
}

}  // namespace terrazzo::gl
