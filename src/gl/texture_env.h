// Per-unit texture environment and texture coordinate generation (GL 1.5 §2.11.4, §3.8.13; tables 6.17-6.18).
//
// Eye planes are kept as they were stored: multiplied by the inverse of the model-view matrix of the moment
// they were specified. Both structs are members of a texture unit and saved by glPushAttrib(GL_TEXTURE_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

namespace terrazzo::gl {

struct TextureEnv {
    GLenum mode = GL_MODULATE;
    std::array<GLfloat, 4> color{};  // as specified; clamped to 0..1 where it is used
};

struct TexgenCoordinate {
    bool enabled = false;
    GLenum mode = GL_EYE_LINEAR;
    std::array<GLfloat, 4> object_plane{};
    std::array<GLfloat, 4> eye_plane{};
};

struct TexgenState {
    TexgenState() {
        coordinates[0].object_plane = coordinates[0].eye_plane = {1, 0, 0, 0};
        coordinates[1].object_plane = coordinates[1].eye_plane = {0, 1, 0, 0};
    }

    std::array<TexgenCoordinate, 4> coordinates;  // s, t, r, q
};

}  // namespace terrazzo::gl
