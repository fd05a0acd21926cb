// The format and type of pixels in client memory (GL 1.5 §3.6.4, tables 3.5-3.8): which pairs are legal, how
// many bytes a pixel takes, and where a row of an image lies under the pixel store state.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>

#include "gl/pixels.h"

namespace terrazzo::gl {

// An error to record, or none when `code` is GL_NO_ERROR.
struct Rule {
    GLenum code = GL_NO_ERROR;
    const char* words = "";
};

// Whether format and type exist and fit together.
Rule check_client_pixel(GLenum format, GLenum type);

bool is_color_format(GLenum format);  // neither an index nor depth

// Components of a pixel as the format has it: 1 to 4.
int component_count(GLenum format);

// A type that holds all components of a pixel in one integer (GL 1.5 table 3.8).
struct PackedType {
    GLenum type;
    int bytes;
    int components;
    unsigned char bits[4];  // in the order of the format's components
    unsigned char shift[4];
};

// GL 1.5 §3.6.4: the first component is in the highest bits, with _REV in the lowest.
inline constexpr PackedType kPackedTypes[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, 3, {3, 3, 2, 0}, {5, 2, 0, 0}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3, {3, 3, 2, 0}, {0, 3, 6, 0}},
    {GL_UNSIGNED_SHORT_5_6_5, 2, 3, {5, 6, 5, 0}, {11, 5, 0, 0}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3, {5, 6, 5, 0}, {0, 5, 11, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4, {4, 4, 4, 4}, {12, 8, 4, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4, {4, 4, 4, 4}, {0, 4, 8, 12}},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4, {5, 5, 5, 1}, {11, 6, 1, 0}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4, {5, 5, 5, 1}, {0, 5, 10, 15}},
    {GL_UNSIGNED_INT_8_8_8_8, 4, 4, {8, 8, 8, 8}, {24, 16, 8, 0}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4, {8, 8, 8, 8}, {0, 8, 16, 24}},
    {GL_UNSIGNED_INT_10_10_10_2, 4, 4, {10, 10, 10, 2}, {22, 12, 2, 0}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4, {10, 10, 10, 2}, {0, 10, 20, 30}},
};
const PackedType* find_packed_type(GLenum type);  // null for other types

// Bytes of one element: a component, or a packed pixel. 0 for GL_BITMAP.
size_t element_size(GLenum type);

// Bytes of one pixel; 0 for GL_BITMAP.
size_t bytes_per_pixel(GLenum format, GLenum type);

// Where the pixels of an image are in client memory.
struct ImageLayout {
    size_t offset = 0;      // bytes from the program's pointer to the first pixel
    int first_bit = 0;      // GL_BITMAP: the first pixel's bit in that byte, counted in the order of pixels
    size_t row_stride = 0;  // bytes
    size_t image_stride = 0;
};
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLenum format, GLenum type);
// The same for commands whose images have three dimensions; other ones ignore the image height.
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLsizei height, int dimensions,
                         GLenum format, GLenum type);

}  // namespace terrazzo::gl
