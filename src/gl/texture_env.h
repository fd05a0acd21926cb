// Per-unit texture environment and texture coordinate generation (GL 1.5 §2.11.4, §3.8.13; tables 6.17-6.18).
//
// Eye planes are kept as they were stored: multiplied by the inverse of the model-view matrix of the moment
// they were specified. Both structs are members of a texture unit and saved by glPushAttrib(GL_TEXTURE_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

namespace terrazzo::gl {

// One half of a combiner, for the colours or for alpha (GL 1.5 tables 3.24-3.26).
struct CombineHalf {
    GLenum function = GL_MODULATE;
    std::array<GLenum, 3> sources{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
    std::array<GLenum, 3> operands{GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA};
    GLfloat scale = 1;
};

struct TextureEnv {
    TextureEnv() { rgb.operands = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA}; }

    GLenum mode = GL_MODULATE;
    std::array<GLfloat, 4> color{};  // as specified; clamped to 0..1 where it is used
    CombineHalf rgb, alpha;          // of GL_COMBINE
    GLfloat lod_bias = 0;            // GL_TEXTURE_FILTER_CONTROL
};

struct Context;

// The parameters of GL_COMBINE (texture_combine.cpp). False: `pname` is none of them, and nothing is read.
bool set_combine_parameter(Context& ctx, TextureEnv& env, GLenum pname, const GLfloat* params);
bool get_combine_parameter(const TextureEnv& env, GLenum pname, GLfloat& value);

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
