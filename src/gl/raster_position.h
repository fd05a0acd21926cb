// The current raster position (GL 1.5 §2.13, table 6.5), saved by glPushAttrib(GL_CURRENT_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

#include "gl/limits.h"

namespace terrazzo::gl {

struct RasterPosition {
    RasterPosition() { texture_coordinates.fill({0, 0, 0, 1}); }

    std::array<GLfloat, 4> window{0, 0, 0, 1};  // x, y, z and the clip coordinate w
    GLfloat distance = 0;                       // from the eye, for fog
    std::array<GLfloat, 4> color{1, 1, 1, 1};   // in [0, 1], like the secondary one
    std::array<GLfloat, 4> secondary_color{0, 0, 0, 1};
    GLfloat index = 1;
    std::array<std::array<GLfloat, 4>, kMaxTextureUnits> texture_coordinates;
    bool valid = true;
};

}  // namespace terrazzo::gl
