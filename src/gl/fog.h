// Fog state (GL 1.5 §3.10, table 6.11), saved by glPushAttrib(GL_FOG_BIT).
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>

namespace terrazzo::gl {

struct FogState {
    bool enabled = false;
    GLenum mode = GL_EXP;
    std::array<GLfloat, 4> color{};  // as specified; clamped to 0..1 where it is used
    GLfloat density = 1;
    GLfloat start = 0;
    GLfloat end = 1;
    GLfloat index = 0;
    GLenum coordinate_source = GL_FRAGMENT_DEPTH;
    GLenum distance_mode = GL_EYE_PLANE_ABSOLUTE_NV;  // NV_fog_distance
    bool color_sum = false;  // the secondary colour is added without lighting too (GL 1.5 §3.9)
};

}  // namespace terrazzo::gl
