// Automatic mipmap generation (GL 1.5 §3.8.8, EXT_framebuffer_object).
#pragma once

#include "gl/texture.h"

namespace terrazzo::gl {

// Called with the lock held after the image of a level was changed: derives the levels behind it where the
// texture asks for that and the level is its base. Throws std::bad_alloc.
void update_mipmap(const ImageTarget& target, GLint level);

}  // namespace terrazzo::gl
