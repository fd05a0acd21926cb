// Where the pixels of a command are (ARB_pixel_buffer_object): in the program's memory at the pointer it
// gave, or in the bound pack or unpack buffer from that offset on.
//
// A command finds out first, before it takes the mutex of the share group, which the buffer's state is
// behind; then it asks whether all that it touches is there.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <memory>

#include "gl/client_pixel.h"

namespace terrazzo::gl {

struct Context;
class BufferStore;

struct PixelMemory {
    std::byte* data = nullptr;  // null where there is nothing to read or write
    std::size_t size = 0;       // bytes from there on; no bound in the program's memory
    Rule rule;                  // the error to record instead
    std::shared_ptr<const BufferStore> keep;

    bool is_usable() const { return rule.code == GL_NO_ERROR; }
    // Adds an error where there are less than `bytes`.
    void require(std::size_t bytes);
};

// `pointer` is what the program gave, to elements of this size each.
PixelMemory find_pixel_memory(const Context& ctx, const PixelStore& store, const void* pointer,
                              std::size_t element_bytes);

struct ImageSize {
    GLsizei width, height;
    GLsizei depth = 1;
    int dimensions = 2;
};

// From the byte that the pointer means to the last pixel's end. Where image_layout() would wrap round, it is
// the largest number.
std::size_t image_end(const PixelStore& store, const ImageSize& size, GLenum format, GLenum type);

// All of an image, or of `count` elements side by side.
PixelMemory find_image(const Context& ctx, const PixelStore& store, const ImageSize& size, GLenum format,
                       GLenum type, const void* pixels);
PixelMemory find_elements(const Context& ctx, const PixelStore& store, GLsizei count,
                          std::size_t element_bytes, const void* elements);

}  // namespace terrazzo::gl
