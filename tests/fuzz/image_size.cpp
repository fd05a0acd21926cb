// Bytes of pixel rectangles; see image_size.h.
#include "fuzz/image_size.h"

namespace terrazzo::fuzz {
namespace {

unsigned bytes_of(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
        case GL_UNSIGNED_BYTE_3_3_2:
        case GL_UNSIGNED_BYTE_2_3_3_REV:
            return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_HALF_FLOAT:
        case GL_UNSIGNED_SHORT_5_6_5:
        case GL_UNSIGNED_SHORT_5_6_5_REV:
        case GL_UNSIGNED_SHORT_4_4_4_4:
        case GL_UNSIGNED_SHORT_4_4_4_4_REV:
        case GL_UNSIGNED_SHORT_5_5_5_1:
        case GL_UNSIGNED_SHORT_1_5_5_5_REV:
            return 2;
        case GL_FLOAT_32_UNSIGNED_INT_24_8_REV:
            return 8;
    }
    return 4;
}

std::uint64_t rounded_up(std::uint64_t value, std::uint64_t to) {
    return (value + to - 1) / to * to;
}

}  // namespace

unsigned components_of(GLenum format) {
    switch (format) {
        case GL_COLOR_INDEX:
        case GL_STENCIL_INDEX:
        case GL_DEPTH_COMPONENT:
        case GL_DEPTH_STENCIL:
        case GL_RED:
        case GL_GREEN:
        case GL_BLUE:
        case GL_ALPHA:
        case GL_LUMINANCE:
        case GL_RED_INTEGER:
        case GL_GREEN_INTEGER:
        case GL_BLUE_INTEGER:
            return 1;
        case GL_LUMINANCE_ALPHA:
        case GL_RG:
        case GL_RG_INTEGER:
            return 2;
        case GL_RGB:
        case GL_BGR:
        case GL_RGB_INTEGER:
        case GL_BGR_INTEGER:
            return 3;
        case GL_RGBA:
        case GL_BGRA:
        case GL_ABGR_EXT:
        case GL_CMYK_EXT:
        case GL_RGBA_INTEGER:
        case GL_BGRA_INTEGER:
            return 4;
        case GL_CMYKA_EXT:
            return 5;
    }
    return 0;
}

unsigned packed_components(GLenum type) {
    switch (type) {
        case GL_BITMAP:
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_HALF_FLOAT:
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
            return 1;
        case GL_UNSIGNED_INT_24_8:
        case GL_FLOAT_32_UNSIGNED_INT_24_8_REV:
            return 2;
        case GL_UNSIGNED_BYTE_3_3_2:
        case GL_UNSIGNED_BYTE_2_3_3_REV:
        case GL_UNSIGNED_SHORT_5_6_5:
        case GL_UNSIGNED_SHORT_5_6_5_REV:
        case GL_UNSIGNED_INT_10F_11F_11F_REV:
        case GL_UNSIGNED_INT_5_9_9_9_REV:
            return 3;
        case GL_UNSIGNED_SHORT_4_4_4_4:
        case GL_UNSIGNED_SHORT_4_4_4_4_REV:
        case GL_UNSIGNED_SHORT_5_5_5_1:
        case GL_UNSIGNED_SHORT_1_5_5_5_REV:
        case GL_UNSIGNED_INT_8_8_8_8:
        case GL_UNSIGNED_INT_8_8_8_8_REV:
        case GL_UNSIGNED_INT_10_10_10_2:
        case GL_UNSIGNED_INT_2_10_10_10_REV:
            return 4;
    }
    return 0;
}

std::uint64_t image_bytes(const PixelStore& store, const ImageShape& image) {
    const unsigned components = components_of(image.format), packed = packed_components(image.type);
    if (image.width <= 0 || image.height <= 0 || image.depth <= 0 || components == 0 || packed == 0) return 0;
    __extension__ typedef unsigned __int128 Wide;  // every parameter may be as large as an int
    const auto positive = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
    const std::uint64_t width = positive(image.width);
    const std::uint64_t length = store.row_length > 0 ? positive(store.row_length) : width;
    const std::uint64_t rows =
        image.has_images && store.image_height > 0 ? positive(store.image_height) : positive(image.height);
    const std::uint64_t skipped_images = image.has_images ? positive(store.skip_images) : 0;
    const std::uint64_t alignment = positive(store.alignment);
    const std::uint64_t skipped_pixels = positive(store.skip_pixels),
                        skipped_rows = positive(store.skip_rows);

    std::uint64_t row = 0, last = 0;  // bytes of a whole row, and of the last one up to its last pixel
    if (image.type == GL_BITMAP) {
        row = rounded_up((components * length + 7) / 8, alignment);
        last = (components * (skipped_pixels + width) + 7) / 8;
    } else {
        const std::uint64_t pixel = std::uint64_t{bytes_of(image.type)} * (packed > 1 ? 1 : components);
        row = rounded_up(pixel * length, alignment);
        last = pixel * (skipped_pixels + width);
    }
    const Wide total = (Wide{skipped_images} + positive(image.depth) - 1) * rows * row +
                       (Wide{skipped_rows} + positive(image.height) - 1) * row + last;
    return total > UINT64_MAX ? UINT64_MAX : static_cast<std::uint64_t>(total);
}

}  // namespace terrazzo::fuzz
