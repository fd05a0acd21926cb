// Common ground of glTexImage, glTexSubImage and glCopyTex(Sub)Image.
#include "gl/texture_spec.h"

#include <algorithm>
#include <new>

#include "gl/context.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "gl/texel_row.h"

namespace terrazzo::gl {
namespace {

// As much as the reference gives one image: 16384 x 16384 of 8 bits a component.
constexpr size_t kMaxImageBytes = size_t{1} << 30;

bool is_supported_extent(GLsizei size, GLint border, GLint level) {
    return size >= 2 * border && size <= (kMaxTextureSize >> level) + 2 * border;
}

// Whether pixels become texels by way of bytes. Bytes carry everything then; where both ways would do, the
// choice is the reference's, which shows in the rounding to 10 bits.
bool goes_through_bytes(const PixelState& state, const ClientImage& client, const TexelFormat& format) {
    if (!is_color_format(client.format) || !has_8_bit_components(client.type) || changes_colors(state))
        return false;
    if (format.storage == pipeline::TexelStorage::kRgba8) return true;
    return client.format == GL_RGBA &&
           (client.type == GL_UNSIGNED_BYTE || client.type == GL_UNSIGNED_INT_8_8_8_8_REV);
}

// Converts pixels of one row, `count` <= kPixelChunk, and stores them from (x, y) on.
class RowUploader {
  public:
    RowUploader(const PixelState& state, const ClientImage& client, const TexelFormat& format,
                pipeline::TextureImage& image)
        : m_state(state),
          m_client(client),
          m_format(format),
          m_image(image),
          m_bytes(goes_through_bytes(state, client, format)),
          m_direct(m_bytes && stores_groups(format, client.format, client.type)),
          m_exact(holds_all_values(format, client.type)),
          m_transfer(changes_colors(state)) {}

    void store(const uint8_t* source, int first_bit, int count, int x, int y) const {
        const bool swap_bytes = m_state.unpack.swap_bytes;
        if (m_direct) {
            uint8_t* texels = m_image.rgba8(x, y);
            return unpack_rgba8(m_client.format, m_client.type, swap_bytes, source, count, texels);
        }
        if (m_bytes) {
            uint8_t rgba[4 * kPixelChunk];
            unpack_rgba8(m_client.format, m_client.type, swap_bytes, source, count, rgba);
            return store_texels(m_format, rgba, Rounding::kThroughBytes, count, m_image, x, y);
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
        store_texels(m_format, rgba, rounding, count, m_image, x, y);
    }

  private:
    const PixelState& m_state;
    const ClientImage& m_client;
    const TexelFormat& m_format;
    pipeline::TextureImage& m_image;
    bool m_bytes;
    bool m_direct;  // bytes are texels
    bool m_exact;   // floats need no rounding
    bool m_transfer;
};

}  // namespace

bool is_level(GLint level) {
    return level >= 0 && level < kMaxTextureLevels;
}

Rule check_level_spec(const LevelSpec& spec) {
    if (!is_level(spec.level)) return {GL_INVALID_VALUE, "no such mipmap level"};
    if (spec.width < 0 || spec.height < 0) return {GL_INVALID_VALUE, "the size is negative"};
    if (spec.border != 0 && spec.border != 1) return {GL_INVALID_VALUE, "the border is neither 0 nor 1"};
    return {};
}

bool is_supported_size(const LevelSpec& spec) {
    return is_supported_extent(spec.width, spec.border, spec.level) &&
           (spec.is_1d || is_supported_extent(spec.height, spec.border, spec.level));
}

bool is_supported_memory(const LevelSpec& spec, const TexelFormat& format) {
    // The border may go on top of the limit.
    const auto texels = static_cast<size_t>(spec.width - 2 * spec.border) *
                        static_cast<size_t>(spec.height - 2 * spec.border_y());
    return texels <= kMaxImageBytes / pipeline::bytes_per_texel(format.storage);
}

Rule check_texture_pixels(GLenum format, GLenum type) {
    if (const Rule rule = check_client_pixel(format, type); rule.code != GL_NO_ERROR) return rule;
    if (format == GL_STENCIL_INDEX) return {GL_INVALID_ENUM, "stencil indices are no texels"};
    if (format == GL_DEPTH_COMPONENT) {
        return {GL_INVALID_OPERATION, "depth pixels need a depth texture"};
    }
    return {};
}

TextureLevel make_level(const LevelSpec& spec, const TexelFormat& format) {
    TextureLevel level{spec.width, spec.height, spec.border, spec.internal_format, &format, nullptr};
    const GLsizei width = spec.width - 2 * spec.border;
    const GLsizei height = spec.height - 2 * spec.border_y();
    if (width == 0 || height == 0) return level;
    level.image = pipeline::TextureImage::create(width, height, spec.border, spec.border_y(), format.storage,
                                                 format.base_format);
    if (!level.image) throw std::bad_alloc();
    return level;
}

bool contains(const TextureLevel& level, const LevelRect& rect) {
    const int64_t border_x = level.border;
    const int64_t border_y = level.image ? level.image->border_y : level.border;
    return rect.x >= -border_x && int64_t{rect.x} + rect.width <= level.width - border_x &&
           rect.y >= -border_y && int64_t{rect.y} + rect.height <= level.height - border_y;
}

pipeline::TextureImage& writable_image(Context& ctx, TextureLevel& level) {
    // What the last draw derived is stale and would count as a reference to the image.
    ctx.drawing.state.fragment.reset();
    pipeline::TextureImage* image = level.image.writable();
    if (!image) throw std::bad_alloc();
    return *image;
}

void upload(const PixelState& state, const ClientImage& client, const TexelFormat& format,
            const LevelRect& rect, pipeline::TextureImage& image) {
    const ImageLayout layout = image_layout(state.unpack, rect.width, client.format, client.type);
    const size_t pixel_size = bytes_per_pixel(client.format, client.type);
    const RowUploader uploader(state, client, format, image);
    const auto* row = static_cast<const uint8_t*>(client.pixels) + layout.offset;
    for (GLsizei y = 0; y < rect.height; ++y, row += layout.row_stride) {
        for (GLsizei x = 0; x < rect.width; x += kPixelChunk) {
            const uint8_t* source = row + static_cast<size_t>(x) * pixel_size;
            const int first_bit = client.type == GL_BITMAP ? layout.first_bit + x : 0;
            uploader.store(source, first_bit, std::min(kPixelChunk, rect.width - x), rect.x + x, rect.y + y);
        }
    }
}

}  // namespace terrazzo::gl
