// Images that display lists keep (GL 1.5 §5.4): client memory is read when the command is compiled.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <vector>

#include "gl/pixel_buffers.h"
#include "gl/pixels.h"

namespace terrazzo::gl {

// The image as default pixel store modes (PixelStore{}) would find it. Empty when `pixels` is null, or when
// format, type or size are such that the command will fail: then the memory is not touched. `largest` is the
// size beyond which it fails. Throws std::bad_alloc.
std::vector<std::byte> unpack_for_list(const PixelStore& unpack, const ImageSize& size, GLsizei largest,
                                       GLenum format, GLenum type, const void* pixels);

}  // namespace terrazzo::gl
