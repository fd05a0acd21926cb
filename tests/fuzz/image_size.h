// How many bytes of client memory a pixel rectangle has (GL 1.5 §3.6.4, §4.3.2): up to its last pixel and no
// further.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

namespace terrazzo::fuzz {

struct PixelStore {
    GLint alignment = 4, row_length = 0, image_height = 0, skip_pixels = 0, skip_rows = 0, skip_images = 0;
    bool in_buffer = false;  // a buffer is bound, pointers are offsets
};

struct ImageShape {
    std::int64_t width = 1, height = 1, depth = 1;
    bool has_images = false;  // three-dimensional: image height and skipped images count
    GLenum format = GL_RGBA, type = GL_UNSIGNED_BYTE;
};

// Zero where the image has no pixels, or format and type are none.
std::uint64_t image_bytes(const PixelStore& store, const ImageShape& image);
// How many components pixels of the format have; zero for what is no format.
unsigned components_of(GLenum format);
// How many components a type packs into one element: 1 for most, zero for what is no type.
unsigned packed_components(GLenum type);

}  // namespace terrazzo::fuzz
