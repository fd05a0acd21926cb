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

// Types that hold all components of a pixel in one integer (GL 1.5 table 3.5, last ten rows).
struct PackedType {
    GLenum type;
    int bytes;
    int components;
    unsigned char bits[4];  // in the order of the format's components
    unsigned char shift[4];
};
const PackedType* find_packed_type(GLenum type);  // null for the others

// Bytes of one element: a component, or a packed pixel. 0 for GL_BITMAP.
size_t element_size(GLenum type);

// Bytes of one pixel; 0 for GL_BITMAP.
size_t bytes_per_pixel(GLenum format, GLenum type);

// Where the pixels of an image are in client memory.
struct ImageLayout {
    size_t offset = 0;      // bytes from the program's pointer to the first pixel
    int first_bit = 0;      // GL_BITMAP: the first pixel's bit in that byte, counted in the order of pixels
    size_t row_stride = 0;  // bytes
};
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLenum format, GLenum type);

}  // namespace terrazzo::gl
