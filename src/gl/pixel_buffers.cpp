// Finding the pixels of a command; see pixel_buffers.h.
#include "gl/pixel_buffers.h"

#include <algorithm>

#include "gl/buffers.h"
#include "gl/context.h"

namespace terrazzo::gl {
namespace {

// Sums and products that end at the largest number, which no buffer holds.
std::size_t sum(std::size_t a, std::size_t b) {
    std::size_t result;
    return __builtin_add_overflow(a, b, &result) ? static_cast<std::size_t>(-1) : result;
}
std::size_t product(std::size_t a, std::size_t b) {
    std::size_t result;
    return __builtin_mul_overflow(a, b, &result) ? static_cast<std::size_t>(-1) : result;
}

}  // namespace

void PixelMemory::require(std::size_t bytes) {
    if (is_usable() && bytes > size) rule = {GL_INVALID_OPERATION, "the pixels are not all in the buffer"};
}

PixelMemory find_pixel_memory(const Context& ctx, const PixelStore& store, const void* pointer,
                              std::size_t element_bytes) {
    const ReadableBytes bytes = find_bytes(ctx, store.buffer.get(), pointer);
    PixelMemory found{const_cast<std::byte*>(bytes.data), bytes.size, {}, bytes.keep};
    if (!store.buffer) return found;
    if (bytes.mapped)
        found.rule = {GL_INVALID_OPERATION, "the pixel buffer is mapped"};
    else if (reinterpret_cast<std::size_t>(pointer) % std::max<std::size_t>(element_bytes, 1) != 0)
        found.rule = {GL_INVALID_OPERATION, "the offset is no multiple of an element's size"};
    return found;
}

std::size_t image_end(const PixelStore& store, const ImageSize& size, GLenum format, GLenum type) {
    if (size.width <= 0 || size.height <= 0 || size.depth <= 0) return 0;
    const auto count = [](GLsizei n) { return static_cast<std::size_t>(n); };
    const bool is_3d = size.dimensions == 3;
    const std::size_t image_rows = count(is_3d && store.image_height > 0 ? store.image_height : size.height),
                      images = sum(is_3d ? count(store.skip_images) : 0, count(size.depth) - 1),
                      rows = sum(product(images, image_rows),
                                 sum(count(store.skip_rows), count(size.height) - 1)),
                      columns = sum(count(store.skip_pixels), count(size.width));
    const std::size_t in_row = type == GL_BITMAP ? columns / 8 + (columns % 8 != 0)
                                                 : product(columns, bytes_per_pixel(format, type));
    return sum(product(rows, image_layout(store, size.width, format, type).row_stride), in_row);
}

PixelMemory find_image(const Context& ctx, const PixelStore& store, const ImageSize& size, GLenum format,
                       GLenum type, const void* pixels) {
    PixelMemory found = find_pixel_memory(ctx, store, pixels, element_size(type));
    if (store.buffer) found.require(image_end(store, size, format, type));
    return found;
}

PixelMemory find_elements(const Context& ctx, const PixelStore& store, GLsizei count,
                          std::size_t element_bytes, const void* elements) {
    PixelMemory found = find_pixel_memory(ctx, store, elements, element_bytes);
    found.require(product(static_cast<std::size_t>(std::max(count, 0)), element_bytes));
    return found;
}

}  // namespace terrazzo::gl
