// The current raster position (GL 1.5 §2.13, table 6.5), saved by glPushAttrib(GL_CURRENT_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

namespace terrazzo::gl {

struct RasterPosition {
    std::array<GLfloat, 4> window{0, 0, 0, 1};
    GLfloat distance = 0;  // from the eye, for fog
    std::array<GLfloat, 4> color{1, 1, 1, 1};
    GLfloat index = 1;
    std::array<GLfloat, 4> texture_coordinates{0, 0, 0, 1};
    bool valid = true;
};

}  // namespace terrazzo::gl
