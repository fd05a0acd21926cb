// Copies images out of client memory for display lists.
//
// The copy is in the layout of default pixel store modes: rows padded to 4 bytes, bytes in the host's order,
// the first pixel of a bitmap in the highest bit. Nothing else about the pixels is interpreted here.
#include "gl/list_image.h"

#include <algorithm>
#include <cstring>

#include "gl/client_pixel.h"
#include "gl/list_record.h"

namespace terrazzo::gl {
namespace {

void swap_elements(std::byte* bytes, std::size_t size, std::size_t element_bytes) {
    for (std::size_t i = 0; i < size; i += element_bytes) std::reverse(bytes + i, bytes + i + element_bytes);
}

bool bitmap_bit(const std::byte* row, std::size_t index, bool lsb_first) {
    const std::size_t bit = lsb_first ? index % 8 : 7 - index % 8;
    return (std::to_integer<unsigned>(row[index / 8]) >> bit & 1u) != 0;
}

void copy_bits(const std::byte* source, std::size_t first_bit, std::size_t width, bool lsb_first,
               std::byte* target) {
    for (std::size_t x = 0; x < width; ++x) {
        if (bitmap_bit(source, first_bit + x, lsb_first)) target[x / 8] |= std::byte(0x80u >> x % 8);
    }
}

}  // namespace

std::vector<std::byte> unpack_for_list(const PixelStore& unpack, const ImageSize& size, GLsizei largest,
                                       GLenum format, GLenum type, const void* pixels) {
    if (!pixels) return {};
    for (const GLsizei extent : {size.width, size.height, size.depth})
        if (extent <= 0 || extent > largest) return {};
    if (check_client_pixel(format, type).code != GL_NO_ERROR) return {};
    if (image_end(PixelStore{}, size, format, type) > DisplayList::kLargestRecord) throw std::bad_alloc();
    const ImageLayout from = image_layout(unpack, size.width, size.height, size.dimensions, format, type);
    const ImageLayout to = image_layout(PixelStore{}, size.width, size.height, size.dimensions, format, type);
    const auto columns = static_cast<std::size_t>(size.width), rows = static_cast<std::size_t>(size.height);
    const auto images = static_cast<std::size_t>(size.depth);
    const std::size_t row_bytes = columns * bytes_per_pixel(format, type);

    std::vector<std::byte> image(to.image_stride * images);
    const auto* first = static_cast<const std::byte*>(pixels) + from.offset;
    std::byte* target = image.data();
    for (std::size_t row = 0; row < rows * images; ++row, target += to.row_stride) {
        const std::byte* const source = first + row / rows * from.image_stride + row % rows * from.row_stride;
        if (type == GL_BITMAP) {
            copy_bits(source, static_cast<std::size_t>(from.first_bit), columns, unpack.lsb_first, target);
            continue;
        }
        std::memcpy(target, source, row_bytes);
        if (unpack.swap_bytes) swap_elements(target, row_bytes, element_size(type));
    }
    return image;
}

}  // namespace terrazzo::gl
