// Vertex arrays (GL 1.5 §2.8): the pointers a client has set and which of them are enabled.
#pragma once

#include <GL/gl.h>

namespace terrazzo::gl {

struct ArrayState {};

}  // namespace terrazzo::gl
