// Copies images out of client memory for display lists; addresses as GL 1.5 §3.6.4 and, for bitmaps, §3.7
// give them.
//
// The copy is in the layout of default pixel store modes: rows padded to 4 bytes, bytes in the host's order,
// the first pixel of a bitmap in the highest bit. Nothing else about the pixels is interpreted here.
#include "gl/list_image.h"

#include <GL/glext.h>

#include <algorithm>
#include <cstring>

namespace terrazzo::gl {
namespace {

constexpr std::size_t kDefaultAlignment = 4;

struct PixelLayout {
    std::size_t elements;       // per pixel
    std::size_t element_bytes;  // 0: format or type unknown
};

std::size_t component_count(GLenum format) {
    switch (format) {
        case GL_COLOR_INDEX:
        case GL_STENCIL_INDEX:
        case GL_DEPTH_COMPONENT:
        case GL_RED:
        case GL_GREEN:
        case GL_BLUE:
        case GL_ALPHA:
        case GL_LUMINANCE:
            return 1;
        case GL_LUMINANCE_ALPHA:
            return 2;
        case GL_RGB:
        case GL_BGR:
            return 3;
        case GL_RGBA:
        case GL_BGRA:
            return 4;
        default:
            return 0;
    }
}

PixelLayout pixel_layout(GLenum format, GLenum type) {
    const std::size_t components = component_count(format);
    if (components == 0) return {0, 0};
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
            return {components, 1};
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
            return {components, 2};
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
            return {components, 4};
        case GL_UNSIGNED_BYTE_3_3_2:
        case GL_UNSIGNED_BYTE_2_3_3_REV:
            return {1, 1};
        case GL_UNSIGNED_SHORT_5_6_5:
        case GL_UNSIGNED_SHORT_5_6_5_REV:
        case GL_UNSIGNED_SHORT_4_4_4_4:
        case GL_UNSIGNED_SHORT_4_4_4_4_REV:
        case GL_UNSIGNED_SHORT_5_5_5_1:
        case GL_UNSIGNED_SHORT_1_5_5_5_REV:
            return {1, 2};
        case GL_UNSIGNED_INT_8_8_8_8:
        case GL_UNSIGNED_INT_8_8_8_8_REV:
        case GL_UNSIGNED_INT_10_10_10_2:
        case GL_UNSIGNED_INT_2_10_10_10_REV:
            return {1, 4};
        default:
            return {0, 0};
    }
}

std::size_t aligned(std::size_t bytes, std::size_t alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
}

void swap_elements(std::byte* bytes, std::size_t size, std::size_t element_bytes) {
    for (std::size_t i = 0; i < size; i += element_bytes) std::reverse(bytes + i, bytes + i + element_bytes);
}

std::vector<std::byte> unpack_pixels(const PixelStore& unpack, std::size_t width, std::size_t height,
                                     PixelLayout layout, const std::byte* source) {
    const std::size_t pixel_bytes = layout.elements * layout.element_bytes;
    const std::size_t source_width =
        unpack.row_length > 0 ? static_cast<std::size_t>(unpack.row_length) : width;
    const std::size_t source_stride =
        aligned(source_width * pixel_bytes, static_cast<std::size_t>(unpack.alignment));
    const std::size_t row_bytes = width * pixel_bytes;
    const std::size_t stride = aligned(row_bytes, kDefaultAlignment);
    source += static_cast<std::size_t>(unpack.skip_rows) * source_stride +
              static_cast<std::size_t>(unpack.skip_pixels) * pixel_bytes;

    std::vector<std::byte> image(stride * height);
    for (std::size_t row = 0; row < height; ++row) {
        std::byte* target = image.data() + row * stride;
        std::memcpy(target, source + row * source_stride, row_bytes);
        if (unpack.swap_bytes) swap_elements(target, row_bytes, layout.element_bytes);
    }
    return image;
}

bool bitmap_bit(const std::byte* row, std::size_t index, bool lsb_first) {
    const std::size_t bit = lsb_first ? index % 8 : 7 - index % 8;
    return (std::to_integer<unsigned>(row[index / 8]) >> bit & 1u) != 0;
}

std::vector<std::byte> unpack_bitmap(const PixelStore& unpack, std::size_t width, std::size_t height,
                                     const std::byte* source) {
    const std::size_t source_width =
        unpack.row_length > 0 ? static_cast<std::size_t>(unpack.row_length) : width;
    const std::size_t source_stride =
        aligned((source_width + 7) / 8, static_cast<std::size_t>(unpack.alignment));
    const std::size_t stride = aligned((width + 7) / 8, kDefaultAlignment);
    source += static_cast<std::size_t>(unpack.skip_rows) * source_stride;
    const std::size_t skip = static_cast<std::size_t>(unpack.skip_pixels);

    std::vector<std::byte> image(stride * height);
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t x = 0; x < width; ++x) {
            const bool bit = bitmap_bit(source + row * source_stride, skip + x, unpack.lsb_first);
            if (bit) image[row * stride + x / 8] |= std::byte(0x80u >> x % 8);
        }
    }
    return image;
}

}  // namespace

std::vector<std::byte> unpack_for_list(const PixelStore& unpack, GLsizei width, GLsizei height, GLenum format,
                                       GLenum type, const void* pixels) {
    constexpr GLsizei kLargestSize = kMaxTextureSize + 2;  // with both borders
    if (!pixels || width <= 0 || height <= 0 || width > kLargestSize || height > kLargestSize) return {};
    const auto* source = static_cast<const std::byte*>(pixels);
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    if (type == GL_BITMAP) {
        const bool legal = format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
        return legal ? unpack_bitmap(unpack, columns, rows, source) : std::vector<std::byte>();
    }
    const PixelLayout layout = pixel_layout(format, type);
    if (layout.element_bytes == 0) return {};
    return unpack_pixels(unpack, columns, rows, layout, source);
}

}  // namespace terrazzo::gl
