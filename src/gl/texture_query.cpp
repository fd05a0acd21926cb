// What a program can ask back about texture images: GetTexLevelParameter (GL 1.5 §6.1.3), GetTexImage
// (§6.1.4).
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "gl/texel_row.h"
#include "gl/texture_spec.h"

namespace terrazzo::gl {
namespace {

// Bits of channel `channel` if the format's base has it under this name.
GLint component_size(const TextureLevel& level, size_t channel, std::initializer_list<GLenum> bases) {
    if (!level.format) return 0;
    const bool named = std::find(bases.begin(), bases.end(), level.format->base) != bases.end();
    if (!named) return 0;
    // About what a block holds of each, as the reference puts it.
    return level.blocks ? 4 : level.format->bits[channel];
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
            value = level.depth;
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
        case GL_TEXTURE_COMPRESSED:
            value = find_block_format(static_cast<GLenum>(level.internal_format)) &&
                    (level.blocks || !level.image);
            return true;
        case GL_TEXTURE_DEPTH_SIZE:
            value = component_size(level, 0, {GL_DEPTH_COMPONENT});
            return true;
        case GL_TEXTURE_STENCIL_SIZE:
            value = level.format && has_stencil(level.internal_format) ? 8 : 0;
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
    if (texel.storage != raster::TexelStorage::kRgba8) return false;
    if (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA) return false;
    if (has_8_bit_components(type)) return true;
    return keeps_all_bits(texel) && (!find_packed_type(type) || texel.base == GL_RGBA);
}

void pack_depth_texels(const PixelState& state, const TextureLevel& level, int x, int y, int count,
                       GLenum type, uint8_t* destination) {
    const uint32_t* const integers = level.image->depths(x, y);
    const int bits = level.format->bits[0];
    const bool changes = changes_depths(state);
    if (bits == 32 && type == GL_UNSIGNED_INT && !state.pack.swap_bytes && !changes) {
        std::memcpy(destination, integers, static_cast<size_t>(count) * sizeof *integers);
        return;
    }
    // Of 16 bits in single precision, as in the reference.
    const double scale = bits == 16 ? static_cast<double>(1.0f / 65535.0f)
                                    : 1.0 / static_cast<double>((uint64_t{1} << bits) - 1);
    float depths[kPixelChunk];
    for (int i = 0; i < count; ++i) depths[i] = static_cast<float>(integers[i] * scale);
    if (changes) transfer_depths(state, depths, count);
    pack_depths(type, state.pack.swap_bytes, depths, count, destination);
}

void pack_depth_stencil_texels(const PixelState& state, const raster::TextureImage& image, int x, int y,
                               int count, uint8_t* destination) {
    uint32_t depths[kPixelChunk], stencils[kPixelChunk] = {};
    std::copy_n(image.depths(x, y), count, depths);
    transfer_packed_depths(state, depths, count, 24);
    if (const uint8_t* const known = image.stencils(x, y)) std::copy_n(known, count, stencils);
    if (changes_stencils(state)) transfer_stencils(state, stencils, count);
    pack_depths_and_stencils(state.pack.swap_bytes, depths, stencils, count, destination);
}

void pack_texels(const PixelState& state, const TextureLevel& level, int x, int y, int z, int count,
                 GLenum format, GLenum type, uint8_t* destination) {
    const PixelStore& pack = state.pack;
    if (format == GL_DEPTH_STENCIL)
        return pack_depth_stencil_texels(state, *level.image, x, y, count, destination);
    if (level.format->base == GL_DEPTH_COMPONENT)
        return pack_depth_texels(state, level, x, y, count, type, destination);
    uint8_t bytes[4 * kPixelChunk];
    if (goes_through_bytes(*level.format, format, type)) {
        load_texels(*level.format, *level.image, x, y, z, count, bytes);
        return pack_rgba8(format, type, pack.swap_bytes, bytes, count, destination);
    }
    float rgba[4 * kPixelChunk];
    load_texels(*level.format, *level.image, x, y, z, count, rgba);
    if (!has_8_bit_components(type)) {
        return pack_rgba_float(format, type, pack.swap_bytes, rgba, count, destination);
    }
    // Sizes below 8 bits are reached by way of 8 bits.
    bytes_from_floats(rgba, 4 * count, bytes);
    pack_rgba8(format, type, pack.swap_bytes, bytes, count, destination);
}

}  // namespace

void get_tex_level_parameterfv(Context& ctx, GLenum target_name, GLint level, GLenum pname, GLfloat* params) {
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object) return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    const auto lock = lock_textures(ctx);
    GLint value = 0;
    if (pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE) {
        const auto& blocks = target.level(level).blocks;
        if (!blocks) return record_error(ctx, GL_INVALID_OPERATION, "the level's image is not compressed");
        *params = static_cast<GLfloat>(blocks->bytes.size());
        return;
    }
    if (!query_level(target.level(level), pname, value)) {
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture level parameter");
    }
    *params = static_cast<GLfloat>(value);
}

void get_tex_image(Context& ctx, GLenum target_name, GLint level_number, GLenum format, GLenum type,
                   void* pixels) {
    const ImageTarget target = find_image_target(ctx, target_name);
    if (!target.object || target.is_proxy)
        return record_error(ctx, GL_INVALID_ENUM, "unknown texture target");
    if (!is_level(level_number)) return record_error(ctx, GL_INVALID_VALUE, "no such mipmap level");
    Rule rule = check_texture_pixels(format, type);
    if (format == GL_COLOR_INDEX) rule = {GL_INVALID_ENUM, "textures give no such pixels"};
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    settle_framebuffers(ctx);
    const PixelStore& pack = ctx.pixels.pack;
    PixelMemory memory = find_pixel_memory(ctx, pack, pixels, element_size(type));
    const auto lock = lock_textures(ctx);
    const TextureLevel& level = target.level(level_number);
    if (level.format) rule = check_pixels_fit(format, *level.format);
    if (level.format && format == GL_DEPTH_STENCIL && !has_stencil(level.internal_format))
        rule = {GL_INVALID_OPERATION, "the texture has no stencil values"};
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    if (!level.image) return;
    if (pack.buffer)
        memory.require(
            image_end(pack, {level.width, level.height, level.depth, target.dimensions}, format, type));
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    if (!memory.data) return;
    const raster::TextureImage& image = *level.image;
    const ImageLayout layout = image_layout(pack, level.width, level.height, target.dimensions, format, type);
    const size_t pixel_size = bytes_per_pixel(format, type);
    auto* first = reinterpret_cast<uint8_t*>(memory.data) + layout.offset;
    for (GLsizei z = 0; z < level.depth; ++z, first += layout.image_stride) {
        uint8_t* row = first;
        for (GLsizei y = 0; y < level.height; ++y, row += layout.row_stride) {
            for (GLsizei x = 0; x < level.width; x += kPixelChunk) {
                const int count = std::min(kPixelChunk, level.width - x);
                pack_texels(ctx.pixels, level, x - image.border_x, y - image.border_y, z - image.border_z,
                            count, format, type, row + static_cast<size_t>(x) * pixel_size);
            }
        }
    }
}

}  // namespace terrazzo::gl
