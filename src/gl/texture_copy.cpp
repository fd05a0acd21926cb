// Texture images from the frame buffer: CopyTexImage, CopyTexSubImage (GL 1.5 §3.8.2).
//
// Texels whose pixels lie outside the window are undefined by the specification: here they are 0 in a new
// image and stay as they were in an old one.
#include <new>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "gl/read_source.h"
#include "gl/texel_row.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

constexpr const char* kNoSource = "there is no buffer to read from";

// Copies the pixels from window position (x, y) on into `rect` of the image.
void copy_pixels(const PixelState& state, const ReadSource& source, GLint x, GLint y, const LevelRect& rect,
                 const TexelFormat& format, pipeline::TextureImage& image) {
    const ReadRect read = source.clip(x, y, rect.width, rect.height);
    const GLint left = rect.x + read.skipped_columns, bottom = rect.y + read.skipped_rows;
    const bool bytes = source.has_bytes(state);
    const bool direct = bytes && stores_groups(format, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int i = 0; i < read.height; ++i) {
        for (int j = 0; j < read.width; j += kPixelChunk) {
            const int count = std::min(kPixelChunk, read.width - j);
            if (direct) {
                source.read(read.x + j, read.y + i, count, image.rgba8(left + j, bottom + i));
            } else if (bytes) {
                uint8_t rgba[4 * kPixelChunk];
                source.read(read.x + j, read.y + i, count, rgba);
                store_texels(format, rgba, Rounding::kAsDrawn, count, image, left + j, bottom + i);
            } else {
                float rgba[4 * kPixelChunk];
                source.read(read.x + j, read.y + i, count, state, rgba);
                store_texels(format, rgba, Rounding::kOnce, count, image, left + j, bottom + i);
            }
        }
    }
}

void copy_tex_image(Context& ctx, GLenum target, const LevelSpec& spec, GLint x, GLint y) {
    if (target != (spec.is_1d ? GL_TEXTURE_1D : GL_TEXTURE_2D)) {
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    }
    if (const Rule rule = check_level_spec(spec); rule.code != GL_NO_ERROR) {
        return record_error(ctx, rule.code, rule.words);
    }
    // GL 1.5 §3.8.2: the component counts 1 to 4 are no formats here.
    const TexelFormat* format = choose_texel_format(spec.internal_format, GL_RGBA, GL_UNSIGNED_BYTE, false);
    if (!format || spec.internal_format <= 4)
        return record_error(ctx, GL_INVALID_ENUM, "unknown internal format");
    if (!is_supported_size(spec)) return record_error(ctx, GL_INVALID_VALUE, "the size is not supported");
    if (!is_supported_memory(spec, *format)) throw std::bad_alloc();
    if (!has_read_source(ctx)) return record_error(ctx, GL_INVALID_FRAMEBUFFER_OPERATION, kNoSource);
    TextureLevel level = make_level(spec, *format);
    const ReadSource source(ctx);
    if (level.image) {
        const LevelRect all{-spec.border, -spec.border_y(), spec.width, spec.height};
        copy_pixels(ctx.pixels, source, x, y, all, *format, *level.image);
    }
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    bound_texture(ctx, target)->levels[static_cast<size_t>(spec.level)] = std::move(level);
}

void copy_tex_sub_image(Context& ctx, GLenum target, GLint level_number, const LevelRect& rect, GLint x,
                        GLint y) {
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    if (rect.width < 0 || rect.height < 0) return record_error(ctx, GL_INVALID_VALUE, "the size is negative");
    if (!has_read_source(ctx)) return record_error(ctx, GL_INVALID_FRAMEBUFFER_OPERATION, kNoSource);
    const ReadSource source(ctx);
    begin_change(ctx, Dirty::kTexture);
    const auto lock = lock_textures(ctx);
    TextureLevel& level = bound_texture(ctx, target)->levels[static_cast<size_t>(level_number)];
    if (!level.format) return record_error(ctx, GL_INVALID_OPERATION, "the level has no image");
    if (!contains(level, rect)) return record_error(ctx, GL_INVALID_VALUE, "the rectangle leaves the image");
    if (!level.image || rect.width == 0 || rect.height == 0) return;
    copy_pixels(ctx.pixels, source, x, y, rect, *level.format, writable_image(ctx, level));
}

}  // namespace

void copy_tex_image_1d(Context& ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                       GLsizei width, GLint border) {
    copy_tex_image(ctx, target, {level, static_cast<GLint>(internalformat), width, 1, border, true}, x, y);
}

void copy_tex_image_2d(Context& ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                       GLsizei width, GLsizei height, GLint border) {
    copy_tex_image(ctx, target, {level, static_cast<GLint>(internalformat), width, height, border, false}, x,
                   y);
}

void copy_tex_sub_image_1d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                           GLsizei width) {
    if (target != GL_TEXTURE_1D) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    copy_tex_sub_image(ctx, target, level, {xoffset, 0, width, 1}, x, y);
}

void copy_tex_sub_image_2d(Context& ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                           GLint y, GLsizei width, GLsizei height) {
    if (target != GL_TEXTURE_2D) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    copy_tex_sub_image(ctx, target, level, {xoffset, yoffset, width, height}, x, y);
}

}  // namespace terrazzo::gl
