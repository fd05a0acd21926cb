// Viewport, depth range, clear values, draw and read buffer (GL 1.5 §2.11.1, §4.2, §4.3.2).
#include "gl/framebuffer.h"

#include <algorithm>

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

// GL_INVALID_ENUM for what is no buffer, GL_INVALID_OPERATION for buffers that are not there (GL 1.5 §4.2.1).
// The render target has one colour buffer, front left, and like OSMesa we take back left for another name of
// it: programs written for double-buffered windows ask for it.
GLenum check_buffer(GLenum buffer) {
    switch (buffer) {
        case GL_FRONT:
        case GL_BACK:
        case GL_LEFT:
        case GL_FRONT_LEFT:
        case GL_BACK_LEFT:
            return GL_NO_ERROR;
        case GL_RIGHT:
        case GL_FRONT_RIGHT:
        case GL_BACK_RIGHT:
        case GL_AUX0:
        case GL_AUX1:
        case GL_AUX2:
        case GL_AUX3:
            return GL_INVALID_OPERATION;
    }
    return GL_INVALID_ENUM;
}

// NaN becomes 0.
GLdouble clamp_depth(GLdouble depth) {
    return depth > 0 ? std::min(depth, 1.0) : 0;
}

}  // namespace

void viewport(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    ViewportState& viewport = ctx.framebuffer.viewport;
    x = std::clamp(x, kMinViewportOrigin, kMaxViewportOrigin);
    y = std::clamp(y, kMinViewportOrigin, kMaxViewportOrigin);
    width = std::min(width, kMaxViewportSize);
    height = std::min(height, kMaxViewportSize);
    if (x == viewport.x && y == viewport.y && width == viewport.width && height == viewport.height) return;
    begin_change(ctx, Dirty::kTransform);
    viewport.x = x;
    viewport.y = y;
    viewport.width = width;
    viewport.height = height;
}

void depth_range(Context& ctx, GLdouble n, GLdouble f) {
    change(ctx, Dirty::kTransform, ctx.framebuffer.viewport.near_depth, clamp_depth(n));
    change(ctx, Dirty::kTransform, ctx.framebuffer.viewport.far_depth, clamp_depth(f));
}

// Clear values matter to Clear alone, which has drawn everything before it: no change to announce.
void clear_color(Context& ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    ctx.framebuffer.clear.color = {red, green, blue, alpha};
}

void clear_index(Context& ctx, GLfloat c) {
    ctx.framebuffer.clear.index = c;
}

void clear_depth(Context& ctx, GLdouble depth) {
    ctx.framebuffer.clear.depth = clamp_depth(depth);
}

void clear_stencil(Context& ctx, GLint s) {
    ctx.framebuffer.clear.stencil = s;
}

void clear_accum(Context& ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    ctx.framebuffer.clear.accum = {red, green, blue, alpha};
    for (GLfloat& component : ctx.framebuffer.clear.accum) component = std::clamp(component, -1.0f, 1.0f);
}

void draw_buffer(Context& ctx, GLenum buf) {
    const bool none_or_several = buf == GL_NONE || buf == GL_FRONT_AND_BACK;
    if (const GLenum error = none_or_several ? GL_NO_ERROR : check_buffer(buf)) {
        return record_error(ctx, error, "no such draw buffer");
    }
    change(ctx, Dirty::kFragment, ctx.framebuffer.draw_buffer, buf);
}

void read_buffer(Context& ctx, GLenum src) {
    if (const GLenum error = check_buffer(src)) return record_error(ctx, error, "no such read buffer");
    ctx.framebuffer.read_buffer = src;
}

}  // namespace terrazzo::gl
