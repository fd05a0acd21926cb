// Display lists (GL 1.5 §5.4): the list being compiled, and where calls of lists stand.
#pragma once

#include <GL/gl.h>

namespace terrazzo::gl {

struct ListState {};

}  // namespace terrazzo::gl
