// Per-fragment operations (GL 1.5 §4.1, tables 6.19-6.20) in the order a fragment meets them: scissor, alpha
// test, stencil, depth, blending, dither, logic op, write masks. Each member of FragmentOpsState is saved by
// one bit of glPushAttrib (together with the clear value of its buffer, which is in framebuffer.h).
#pragma once

#include <GL/gl.h>

#include <array>

namespace terrazzo::gl {

struct ScissorState {
    bool enabled = false;
    GLint x = 0, y = 0;
    GLsizei width = 0, height = 0;  // the first MakeCurrent sets them to the size of the render target
};

struct AlphaTestState {
    bool enabled = false;
    GLenum func = GL_ALWAYS;
    GLfloat reference = 0;  // as specified; clamped to 0..1 where it is used
};

struct StencilFace {
    GLenum func = GL_ALWAYS;
    GLint reference = 0;       // as specified; clamped to the buffer's range where it is used
    GLuint value_mask = 0xff;  // all bits of the deepest stencil buffer there is
    GLuint write_mask = 0xff;
    GLenum fail = GL_KEEP;
    GLenum depth_fail = GL_KEEP;
    GLenum depth_pass = GL_KEEP;
};

// Two extensions give back sides a test of their own. With ATI_separate_stencil (and GL 2.0) it always is in
// use, and commands that name no face set both. With EXT_stencil_two_side it is in use while its capability
// is enabled, and commands that name no face set the active one. As in the reference the two have back sides
// of their own, so that programs of either kind see what they expect; ATI's front and EXT's are one.
struct StencilState {
    bool enabled = false;
    bool two_side_enabled = false;
    GLenum active_face = GL_FRONT;
    StencilFace front, back, two_side_back;

    // The back sides' test, as it is in use.
    const StencilFace& back_in_use() const { return two_side_enabled ? two_side_back : back; }
    // What queries without a face answer.
    const StencilFace& active() const { return active_face == GL_BACK ? two_side_back : front; }
};

struct DepthState {
    bool test_enabled = false;
    GLenum func = GL_LESS;
    bool write_mask = true;
};

struct BlendState {
    bool enabled = false;
    GLenum source_rgb = GL_ONE;
    GLenum source_alpha = GL_ONE;
    GLenum destination_rgb = GL_ZERO;
    GLenum destination_alpha = GL_ZERO;
    GLenum equation_rgb = GL_FUNC_ADD;
    GLenum equation_alpha = GL_FUNC_ADD;
    std::array<GLfloat, 4> color{};
};

struct LogicOpState {
    bool color_enabled = false;
    bool index_enabled = false;
    GLenum op = GL_COPY;
};

struct ColorBufferState {
    AlphaTestState alpha_test;
    BlendState blend;
    LogicOpState logic_op;
    bool dither = true;
    std::array<bool, 4> write_mask{true, true, true, true};
    GLuint index_write_mask = ~0u;
};

struct FragmentOpsState {
    ScissorState scissor;
    ColorBufferState color;
    StencilState stencil;
    DepthState depth;
};

}  // namespace terrazzo::gl
