// Where and how the frame buffer is addressed (GL 1.5 §2.11.1, §4.2, §4.3.2; tables 6.9, 6.21): viewport,
// depth range, clear values, the buffers drawn to and read from.
#pragma once

#include <GL/gl.h>

#include <array>

#include "gl/drawable.h"
#include "pipeline/schedule/frame.h"

namespace terrazzo::gl {

// The part that glPushAttrib(GL_VIEWPORT_BIT) saves.
struct ViewportState {
    GLint x = 0, y = 0;
    GLsizei width = 0, height = 0;  // the first MakeCurrent sets them to the size of the render target
    GLdouble near_depth = 0, far_depth = 1;
};

// Window depth of a depth in normalised device coordinates, in the reference's roundings: it keeps the range
// as floats.
struct DepthMapping {
    float scale, translate;
};
inline DepthMapping depth_mapping(const ViewportState& viewport, GLenum clip_depth_mode) {
    const GLdouble near = static_cast<GLfloat>(viewport.near_depth),
                   far = static_cast<GLfloat>(viewport.far_depth);
    if (clip_depth_mode == GL_ZERO_TO_ONE) return {static_cast<float>(far - near), static_cast<float>(near)};
    return {static_cast<float>(0.5 * (far - near)), static_cast<float>(0.5 * (near + far))};
}

struct ClearValues {
    std::array<GLfloat, 4> color{};  // as specified; clamped where it is used, for a float target must not be
    GLfloat index = 0;
    GLdouble depth = 1;
    GLint stencil = 0;  // as specified; the buffer's low bits are used
    std::array<GLfloat, 4> accum{};
};

struct FramebufferState {
    ViewportState viewport;
    ClearValues clear;
    GLenum draw_buffer = GL_FRONT;  // GL_BACK in contexts for double-buffered drawables
    GLenum read_buffer = GL_FRONT;
    bool has_met_drawable = false;  // the first one gives viewport and scissor box their size
};

struct ColorBits {
    int red, green, blue, alpha;
};
ColorBits color_bits(const raster::TargetFormat& format);

// The colour buffer that an argument of glDrawBuffer or glReadBuffer stands for, and the one to read from.
ColorBuffer color_buffer_of(GLenum buffer);
ColorBuffer read_color_buffer(const Context& ctx);

// What `buffer`, an argument of glDrawBuffer, stands for: colour planes of a target, which has them; null
// where the drawable has none yet. Throws std::bad_alloc.
struct DrawTarget {
    std::shared_ptr<raster::Target> target;
    pipeline::DrawnColors colors = pipeline::DrawnColors::kFirst;
};
DrawTarget draw_target(Drawable& drawable, GLenum buffer);

// glDrawBuffer with a checked argument. Throws std::bad_alloc and changes nothing then.
void select_draw_buffer(Context& ctx, GLenum buffer);

}  // namespace terrazzo::gl
