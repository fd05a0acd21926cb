// Hints (GL 1.5 §5.6, table 6.30), saved by glPushAttrib(GL_HINT_BIT). They are remembered and change
// nothing.
#pragma once

#include <GL/gl.h>

namespace terrazzo::gl {

struct HintState {
    GLenum perspective_correction = GL_DONT_CARE;
    GLenum point_smooth = GL_DONT_CARE;
    GLenum line_smooth = GL_DONT_CARE;
    GLenum polygon_smooth = GL_DONT_CARE;
    GLenum fog = GL_DONT_CARE;
    GLenum generate_mipmap = GL_DONT_CARE;
    GLenum texture_compression = GL_DONT_CARE;
};

}  // namespace terrazzo::gl
