// What a program can ask back about texture images: GetTexLevelParameter (GL 1.5 §6.1.3), GetTexImage
// (§6.1.4).
#include <algorithm>
#include <array>
#include <cstdint>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "gl/texel_row.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

const TextureObject* object_or_proxy(Context& ctx, GLenum target) {
    switch (target) {
        case GL_PROXY_TEXTURE_1D:
            return &ctx.texture.proxies[kTexture1D];
        case GL_PROXY_TEXTURE_2D:
            return &ctx.texture.proxies[kTexture2D];
        default:
            return bound_texture(ctx, target);
    }
}

// Bits of channel `channel` if the format's base has it under this name.
GLint component_size(const TextureLevel& level, size_t channel, std::initializer_list<GLenum> bases) {
    if (!level.format) return 0;
    const bool named = std::find(bases.begin(), bases.end(), level.format->base) != bases.end();
    return named ? level.format->bits[channel] : 0;
}

// Whether `pname` is known; its value then is in `value`.
bool query_level(const TextureLevel& level, GLenum pname, GLint& value) {
    switch (pname) {
        case GL_TEXTURE_WIDTH:
            value = level.width;
            return true;
        case GL_TEXTURE_HEIGHT:
            value = level.height;
            return true;
        case GL_TEXTURE_DEPTH:
            value = level.format ? 1 : 0;
            return true;
        case GL_TEXTURE_BORDER:
            value = level.border;
            return true;
        case GL_TEXTURE_INTERNAL_FORMAT:
            value = level.internal_format;
            return true;
        case GL_TEXTURE_RED_SIZE:
            value = component_size(level, 0, {GL_RGB, GL_RGBA});
            return true;
        case GL_TEXTURE_GREEN_SIZE:
            value = component_size(level, 1, {GL_RGB, GL_RGBA});
            return true;
        case GL_TEXTURE_BLUE_SIZE:
            value = component_size(level, 2, {GL_RGB, GL_RGBA});
            return true;
        case GL_TEXTURE_ALPHA_SIZE:
            value = component_size(level, 3, {GL_RGBA, GL_ALPHA, GL_LUMINANCE_ALPHA});
            return true;
        case GL_TEXTURE_LUMINANCE_SIZE:
            value = component_size(level, 0, {GL_LUMINANCE, GL_LUMINANCE_ALPHA});
            return true;
        case GL_TEXTURE_INTENSITY_SIZE:
            value = component_size(level, 0, {GL_INTENSITY});
            return true;
        default:
            return false;
    }
}

bool keeps_all_bits(const TexelFormat& format) {
    return std::all_of(format.bits.begin(), format.bits.end(),
                       [](unsigned char bits) { return bits == 0 || bits == 8; });
}

// Whether texels go to the client by way of bytes. Bytes carry everything then; where both ways would do, the
// choice is the reference's, which shows in the rounding.
bool goes_through_bytes(const TexelFormat& texel, GLenum format, GLenum type) {
    if (texel.storage != pipeline::TexelStorage::kRgba8) return false;
    if (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA) return false;
    if (has_8_bit_components(type)) return true;
    return keeps_all_bits(texel) && (!find_packed_type(type) || texel.base == GL_RGBA);
}

void pack_texels(const PixelStore& pack, const TextureLevel& level, int x, int y, int count, GLenum format,
                 GLenum type, uint8_t* destination) {
    uint8_t bytes[4 * kPixelChunk];
    if (goes_through_bytes(*level.format, format, type)) {
        load_texels(*level.format, *level.image, x, y, count, bytes);
        return pack_rgba8(format, type, pack.swap_bytes, bytes, count, destination);
    }
    float rgba[4 * kPixelChunk];
    load_texels(*level.format, *level.image, x, y, count, rgba);
    if (!has_8_bit_components(type)) {
        return pack_rgba_float(format, type, pack.swap_bytes, rgba, count, destination);
    }
    // Sizes below 8 bits are reached by way of 8 bits.
    bytes_from_floats(rgba, 4 * count, bytes);
    pack_rgba8(format, type, pack.swap_bytes, bytes, count, destination);
}

}  // namespace

void get_tex_level_parameterfv(Context& ctx, GLenum target, GLint level, GLenum pname, GLfloat* params) {
    const TextureObject* object = object_or_proxy(ctx, target);
    if (!object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    const auto lock = lock_textures(ctx);
    GLint value = 0;
    if (!query_level(object->levels[static_cast<size_t>(level)], pname, value)) {
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture level parameter");
    }
    *params = static_cast<GLfloat>(value);
}

void get_tex_image(Context& ctx, GLenum target, GLint level_number, GLenum format, GLenum type,
                   void* pixels) {
    TextureObject* object = bound_texture(ctx, target);
    if (!object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    Rule rule = check_texture_pixels(format, type);
    if (format == GL_COLOR_INDEX) rule = {GL_INVALID_ENUM, "textures hold no colour indices"};
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    const auto lock = lock_textures(ctx);
    const TextureLevel& level = object->levels[static_cast<size_t>(level_number)];
    if (!level.image || !pixels) return;
    const PixelStore& pack = ctx.pixels.pack;
    const ImageLayout layout = image_layout(pack, level.width, format, type);
    const size_t pixel_size = bytes_per_pixel(format, type);
    auto* row = static_cast<uint8_t*>(pixels) + layout.offset;
    for (GLsizei y = 0; y < level.height; ++y, row += layout.row_stride) {
        for (GLsizei x = 0; x < level.width; x += kPixelChunk) {
            const int count = std::min(kPixelChunk, level.width - x);
            pack_texels(pack, level, x - level.image->border_x, y - level.image->border_y, count, format,
                        type, row + static_cast<size_t>(x) * pixel_size);
        }
    }
}

}  // namespace terrazzo::gl
