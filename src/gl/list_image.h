// Images that display lists keep (GL 1.5 §5.4): client memory is read when the command is compiled.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <vector>

#include "gl/pixels.h"

namespace terrazzo::gl {

// In place of the depth of an image of one or two dimensions.
inline constexpr GLsizei kNoDepth = -1;

// The image as default pixel store modes (PixelStore{}) would find it. Empty when `pixels` is null, or when
// format, type or size are such that the command will fail: then the memory is not touched.
std::vector<std::byte> unpack_for_list(const PixelStore& unpack, GLsizei width, GLsizei height, GLsizei depth,
                                       GLenum format, GLenum type, const void* pixels);

}  // namespace terrazzo::gl
