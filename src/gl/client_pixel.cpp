// Legality, size and place of pixels in client memory.
#include "gl/client_pixel.h"

namespace terrazzo::gl {
namespace {

bool fits_packed(GLenum format, const PackedType& packed) {
    if (packed.components == 3) return format == GL_RGB;
    if (format == GL_ABGR_EXT) return packed.bits[0] == packed.bits[3];  // EXT_abgr with equal fields only
    return format == GL_RGBA || format == GL_BGRA;
}

bool is_index_format(GLenum format) {
    return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
}

}  // namespace

const PackedType* find_packed_type(GLenum type) {
    for (const PackedType& packed : kPackedTypes) {
        if (packed.type == type) return &packed;
    }
    return nullptr;
}

int component_count(GLenum format) {
    switch (format) {
        case GL_RGBA:
        case GL_BGRA:
        case GL_ABGR_EXT:
            return 4;
        case GL_RGB:
        case GL_BGR:
            return 3;
        case GL_LUMINANCE_ALPHA:
            return 2;
        default:
            return 1;
    }
}

bool is_color_format(GLenum format) {
    switch (format) {
        case GL_RED:
        case GL_GREEN:
        case GL_BLUE:
        case GL_ALPHA:
        case GL_RGB:
        case GL_BGR:
        case GL_RGBA:
        case GL_BGRA:
        case GL_ABGR_EXT:
        case GL_LUMINANCE:
        case GL_LUMINANCE_ALPHA:
            return true;
        default:
            return false;
    }
}

size_t element_size(GLenum type) {
    switch (type) {
        case GL_UNSIGNED_BYTE:
        case GL_BYTE:
            return 1;
        case GL_UNSIGNED_SHORT:
        case GL_SHORT:
            return 2;
        case GL_UNSIGNED_INT:
        case GL_INT:
        case GL_FLOAT:
        case GL_UNSIGNED_INT_24_8:
            return 4;
        default:
            break;
    }
    const PackedType* packed = find_packed_type(type);
    return packed ? static_cast<size_t>(packed->bytes) : 0;
}

size_t bytes_per_pixel(GLenum format, GLenum type) {
    const size_t element = element_size(type);
    return find_packed_type(type) ? element : element * static_cast<size_t>(component_count(format));
}

Rule check_client_pixel(GLenum format, GLenum type) {
    const bool is_depth = format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL;
    if (!is_color_format(format) && !is_index_format(format) && !is_depth)
        return {GL_INVALID_ENUM, "unknown pixel format"};
    // EXT_packed_depth_stencil: the one for the other.
    if (format == GL_DEPTH_STENCIL && type != GL_UNSIGNED_INT_24_8)
        return {GL_INVALID_ENUM, "depth and stencil are GL_UNSIGNED_INT_24_8"};
    if (const PackedType* packed = find_packed_type(type)) {
        if (fits_packed(format, *packed)) return {};
        return {GL_INVALID_OPERATION, "the packed type does not fit the format"};
    }
    if (type == GL_UNSIGNED_INT_24_8) {
        if (format == GL_DEPTH_STENCIL) return {};
        return {GL_INVALID_OPERATION, "GL_UNSIGNED_INT_24_8 holds depth and stencil"};
    }
    if (type == GL_BITMAP) {
        if (is_index_format(format)) return {};
        return {GL_INVALID_ENUM, "GL_BITMAP needs an index format"};
    }
    if (element_size(type) == 0) return {GL_INVALID_ENUM, "unknown pixel type"};
    return {};
}

// GL 1.5 §3.6.4, equations 3.13 and 3.14; for bitmaps §3.7. Sizes wrap like the pointer arithmetic they stand
// for: where they do, no memory could hold the image.
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLenum format, GLenum type) {
    const size_t row_pixels = static_cast<size_t>(store.row_length > 0 ? store.row_length : width);
    const size_t alignment = static_cast<size_t>(store.alignment);
    const size_t skip_rows = static_cast<size_t>(store.skip_rows);
    const size_t skip_pixels = static_cast<size_t>(store.skip_pixels);
    ImageLayout layout;
    if (type == GL_BITMAP) {
        layout.row_stride = (row_pixels + 8 * alignment - 1) / (8 * alignment) * alignment;
        layout.offset = skip_rows * layout.row_stride + skip_pixels / 8;
        layout.first_bit = static_cast<int>(skip_pixels % 8);
        return layout;
    }
    const size_t element = element_size(type);
    const size_t pixel = bytes_per_pixel(format, type);
    layout.row_stride = row_pixels * pixel;
    if (element < alignment) layout.row_stride = (layout.row_stride + alignment - 1) / alignment * alignment;
    layout.offset = skip_rows * layout.row_stride + skip_pixels * pixel;
    return layout;
}

// GL 1.5 §3.8.1.
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLsizei height, int dimensions,
                         GLenum format, GLenum type) {
    ImageLayout layout = image_layout(store, width, format, type);
    const GLsizei rows = dimensions == 3 && store.image_height > 0 ? store.image_height : height;
    layout.image_stride = static_cast<size_t>(rows) * layout.row_stride;
    if (dimensions == 3) layout.offset += static_cast<size_t>(store.skip_images) * layout.image_stride;
    return layout;
}

}  // namespace terrazzo::gl
