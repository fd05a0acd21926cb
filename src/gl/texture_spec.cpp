// Common ground of glTexImage, glTexSubImage and glCopyTex(Sub)Image.
#include "gl/texture_spec.h"

#include <algorithm>
#include <new>

#include "gl/block_compression.h"
#include "gl/context.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "gl/texel_row.h"

namespace terrazzo::gl {
namespace {

// As much as the reference gives one image: 16384 x 16384 of 8 bits a component.
constexpr size_t kMaxImageBytes = size_t{1} << 30;

// Of the largest level.
GLsizei largest_size(const LevelSpec& spec, bool is_cube) {
    return is_cube ? kMaxCubeTextureSize : spec.dimensions == 3 ? kMax3dTextureSize : kMaxTextureSize;
}

bool is_supported_extent(GLsizei size, GLint border, GLint level, GLsizei largest) {
    return size >= 2 * border && size <= (largest >> level) + 2 * border;
}

// Whether pixels become texels by way of bytes. Bytes carry everything then; where both ways would do, the
// choice is the reference's, which shows in the rounding to 10 bits.
bool goes_through_bytes(const PixelState& state, const ClientImage& client, const TexelFormat& format) {
    if (!is_color_format(client.format) || !has_8_bit_components(client.type) || changes_colors(state))
        return false;
    if (format.storage == raster::TexelStorage::kRgba8) return true;
    return client.format == GL_RGBA &&
           (client.type == GL_UNSIGNED_BYTE || client.type == GL_UNSIGNED_INT_8_8_8_8_REV);
}

// Converts pixels of one row, `count` <= kPixelChunk, and stores them from (x, y) on.
class RowUploader {
  public:
    RowUploader(const PixelState& state, const ClientImage& client, const TexelFormat& format,
                raster::TextureImage& image)
        : m_state(state),
          m_client(client),
          m_format(format),
          m_image(image),
          m_bytes(goes_through_bytes(state, client, format)),
          m_direct(m_bytes && stores_groups(format, client.format, client.type)),
          m_exact(holds_all_values(format, client.type)),
          m_transfer(changes_colors(state)),
          m_exact_rgba(m_exact && !m_transfer && format.base == GL_RGBA && client.format != GL_COLOR_INDEX) {}

    void store(const uint8_t* source, int first_bit, int count, int x, int y, int z) const {
        const bool swap_bytes = m_state.unpack.swap_bytes;
        if (m_client.format == GL_DEPTH_STENCIL) return store_depths_and_stencils(source, count, x, y);
        if (m_format.base == GL_DEPTH_COMPONENT) {
            return store_depths(m_state, m_client.type, m_format.bits[0], source, count,
                                m_image.depths(x, y));
        }
        if (m_direct) {
            uint8_t* texels = m_image.rgba8(x, y, z);
            return unpack_rgba8(m_client.format, m_client.type, swap_bytes, source, count, texels);
        }
        if (m_bytes) {
            uint8_t rgba[4 * kPixelChunk];
            unpack_rgba8(m_client.format, m_client.type, swap_bytes, source, count, rgba);
            return store_texels(m_format, rgba, Rounding::kThroughBytes, count, m_image, x, y, z);
        }
        if (m_exact_rgba) {
            return unpack_rgba_float(m_client.format, m_client.type, swap_bytes, source, count,
                                     m_image.rgba32f(x, y, z));
        }
        float rgba[4 * kPixelChunk];
        Rounding rounding = Rounding::kThroughBytes;
        if (m_client.format == GL_COLOR_INDEX) {
            uint32_t indices[kPixelChunk];
            unpack_indices(m_client.type, swap_bytes, m_state.unpack.lsb_first, source, first_bit, count,
                           indices);
            transfer_indices_to_colors(m_state, indices, count, rgba);
        } else {
            unpack_rgba_float(m_client.format, m_client.type, swap_bytes, source, count, rgba);
            if (m_transfer) transfer_colors(m_state, rgba, count);
            if (m_transfer || (m_client.format == GL_RGBA && m_client.type == GL_FLOAT)) {
                rounding = Rounding::kOnce;
            } else if (m_exact) {
                rounding = Rounding::kNone;
            }
        }
        store_texels(m_format, rgba, rounding, count, m_image, x, y, z);
    }

  private:
    void store_depths_and_stencils(const uint8_t* source, int count, int x, int y) const {
        uint32_t stencils[kPixelChunk], *const depths = m_image.depths(x, y);
        unpack_depths_and_stencils(m_state.unpack.swap_bytes, source, count, depths, stencils);
        transfer_packed_depths(m_state, depths, count, m_format.bits[0]);
        uint8_t* const kept = m_image.stencils(x, y);
        if (!kept) return;
        if (changes_stencils(m_state)) transfer_stencils(m_state, stencils, count);
        for (int i = 0; i < count; ++i) kept[i] = static_cast<uint8_t>(stencils[i]);
    }

    const PixelState& m_state;
    const ClientImage& m_client;
    const TexelFormat& m_format;
    raster::TextureImage& m_image;
    bool m_bytes;
    bool m_direct;  // bytes are texels
    bool m_exact;   // floats need no rounding
    bool m_transfer;
    bool m_exact_rgba;  // floats are texels
};

}  // namespace

bool is_level(GLint level) {
    return level >= 0 && level < kMaxTextureLevels;
}

Rule check_level_spec(const LevelSpec& spec, bool is_cube) {
    if (!is_level(spec.level) || largest_size(spec, is_cube) >> spec.level == 0)
        return {GL_INVALID_VALUE, "no such mipmap level"};
    if (spec.width < 0 || spec.height < 0 || spec.depth < 0)
        return {GL_INVALID_VALUE, "the size is negative"};
    if (spec.border != 0 && spec.border != 1) return {GL_INVALID_VALUE, "the border is neither 0 nor 1"};
    if (is_cube && spec.width != spec.height) return {GL_INVALID_VALUE, "a face of a cube map is square"};
    return {};
}

bool is_supported_size(const LevelSpec& spec, bool is_cube) {
    const GLsizei largest = largest_size(spec, is_cube);
    return is_supported_extent(spec.width, spec.border, spec.level, largest) &&
           (spec.dimensions < 2 || is_supported_extent(spec.height, spec.border, spec.level, largest)) &&
           (spec.dimensions < 3 || is_supported_extent(spec.depth, spec.border, spec.level, largest));
}

bool is_supported_memory(const LevelSpec& spec, const TexelFormat& format) {
    // The border may go on top of the limit.
    const auto texels = static_cast<size_t>(spec.width - 2 * spec.border) *
                        static_cast<size_t>(spec.height - 2 * spec.border_y()) *
                        static_cast<size_t>(spec.depth - 2 * spec.border_z());
    return texels <= kMaxImageBytes / raster::bytes_per_texel(format.storage);
}

Rule check_texture_pixels(GLenum format, GLenum type) {
    if (const Rule rule = check_client_pixel(format, type); rule.code != GL_NO_ERROR) return rule;
    if (format == GL_STENCIL_INDEX) return {GL_INVALID_ENUM, "stencil indices are no texels"};
    return {};
}

Rule check_pixels_fit(GLenum client_format, const TexelFormat& format) {
    if ((client_format == GL_DEPTH_COMPONENT || client_format == GL_DEPTH_STENCIL) ==
        (format.base == GL_DEPTH_COMPONENT))
        return {};
    return {GL_INVALID_OPERATION, "depth pixels belong to depth textures, and no others do"};
}

Rule check_compression(const LevelSpec& spec) {
    if (!find_block_format(static_cast<GLenum>(spec.internal_format))) return {};
    if (spec.dimensions != 2)
        return {GL_INVALID_ENUM, "no compressed format of images of so many dimensions"};
    if (spec.border == 1) return {GL_INVALID_OPERATION, "compressed images have no border"};
    return {};
}

Rule check_blocks(const TextureLevel& level, const LevelBox& box) {
    const bool whole = !level.blocks || (is_whole_blocks(box.x, box.width, level.width) &&
                                         is_whole_blocks(box.y, box.height, level.height));
    if (whole) return {};
    return {GL_INVALID_OPERATION, "the rectangle does not end with blocks"};
}

void compress_level(TextureLevel& level) {
    if (const BlockFormat* const format = find_block_format(static_cast<GLenum>(level.internal_format));
        format && level.image)
        level.blocks = compress(*format, *level.image);
}

TextureLevel make_level(const LevelSpec& spec, const TexelFormat& format) {
    TextureLevel level{spec.width,           spec.height, spec.depth, spec.border,
                       spec.internal_format, &format,     nullptr,    nullptr};
    const raster::TextureImage::Size size{spec.width - 2 * spec.border,
                                          spec.height - 2 * spec.border_y(),
                                          spec.depth - 2 * spec.border_z(),
                                          spec.border,
                                          spec.border_y(),
                                          spec.border_z()};
    if (size.width == 0 || size.height == 0 || size.depth == 0) return level;
    level.image = raster::TextureImage::create(size, format.storage, format.base_format);
    if (!level.image) throw std::bad_alloc();
    return level;
}

void clear_texels(raster::TextureImage& image) {
    if (image.base_format != raster::BaseFormat::kLuminance && image.base_format != raster::BaseFormat::kRgb)
        return;
    for (int z = -image.border_z; z < image.depth + image.border_z; ++z) {
        for (int y = -image.border_y; y < image.height + image.border_y; ++y) {
            for (int x = -image.border_x; x < image.width + image.border_x; ++x) {
                if (image.storage == raster::TexelStorage::kRgba8)
                    image.rgba8(x, y, z)[3] = 255;
                else
                    image.rgba32f(x, y, z)[3] = 1;
            }
        }
    }
}

bool contains(const TextureLevel& level, const LevelBox& box) {
    const int64_t border_x = level.border;
    const int64_t border_y = level.image ? level.image->border_y : level.border;
    const int64_t border_z = level.image ? level.image->border_z : level.border;
    return box.x >= -border_x && int64_t{box.x} + box.width <= level.width - border_x && box.y >= -border_y &&
           int64_t{box.y} + box.height <= level.height - border_y && box.z >= -border_z &&
           int64_t{box.z} + box.depth <= level.depth - border_z;
}

raster::TextureImage& writable_image(Context& ctx, TextureLevel& level) {
    // What the last draw derived is stale and would count as a reference to the image.
    ctx.drawing.state.fragment.reset();
    raster::TextureImage* image = level.image.writable();
    if (!image) throw std::bad_alloc();
    return *image;
}

void upload(const PixelState& state, const ClientImage& client, const TexelFormat& format,
            const LevelBox& box, int dimensions, raster::TextureImage& image) {
    const ImageLayout layout =
        image_layout(state.unpack, box.width, box.height, dimensions, client.format, client.type);
    const size_t pixel_size = bytes_per_pixel(client.format, client.type);
    const RowUploader uploader(state, client, format, image);
    const auto* first = static_cast<const uint8_t*>(client.pixels) + layout.offset;
    for (GLsizei z = 0; z < box.depth; ++z, first += layout.image_stride) {
        const uint8_t* row = first;
        for (GLsizei y = 0; y < box.height; ++y, row += layout.row_stride) {
            for (GLsizei x = 0; x < box.width; x += kPixelChunk) {
                const uint8_t* source = row + static_cast<size_t>(x) * pixel_size;
                const int first_bit = client.type == GL_BITMAP ? layout.first_bit + x : 0;
                uploader.store(source, first_bit, std::min(kPixelChunk, box.width - x), box.x + x, box.y + y,
                               box.z + z);
            }
        }
    }
}

}  // namespace terrazzo::gl
