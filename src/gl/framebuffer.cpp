// Viewport, depth range, clear values, draw and read buffer (GL 1.5 §2.11.1, §4.2, §4.3.2).
#include "gl/framebuffer.h"

#include <algorithm>

#include "gl/change.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

// GL_INVALID_ENUM for what is no buffer, GL_INVALID_OPERATION for buffers that are not there (GL 1.5 §4.2.1).
GLenum check_window_buffer(const Context& ctx, GLenum buffer) {
    switch (buffer) {
        case GL_FRONT:
        case GL_LEFT:
        case GL_FRONT_LEFT:
            return GL_NO_ERROR;
        case GL_BACK:
        case GL_BACK_LEFT: {
            const Drawable* drawable = ctx.framebuffers.window_draw.get();
            const bool there =
                drawable ? drawable->buffering() != Buffering::kSingle : ctx.config.double_buffered;
            return there ? GL_NO_ERROR : GL_INVALID_OPERATION;
        }
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

// A frame buffer object has one of its own and GL_NONE, and none of the window system's.
GLenum check_buffer(const Context& ctx, GLenum buffer, const Framebuffer* object) {
    constexpr GLenum kAttachmentNames = 16;
    if (buffer - GL_COLOR_ATTACHMENT0 < kAttachmentNames)
        return object && buffer == GL_COLOR_ATTACHMENT0 ? GL_NO_ERROR : GL_INVALID_OPERATION;
    if (object && buffer == GL_NONE) return GL_NO_ERROR;
    const GLenum error = check_window_buffer(ctx, buffer);
    return object && error == GL_NO_ERROR ? GLenum{GL_INVALID_OPERATION} : error;
}

// Of a double-buffered drawable GL_LEFT names both buffers, GL_NONE neither: the back buffer stands for it
// then.
bool names_front(GLenum buffer) {
    return buffer == GL_FRONT || buffer == GL_FRONT_LEFT;
}

// NaN becomes 0.
GLdouble clamp_depth(GLdouble depth) {
    return depth > 0 ? std::min(depth, 1.0) : 0;
}

}  // namespace

ColorBits color_bits(const raster::TargetFormat& format) {
    int bits = 8;
    switch (format.color) {
        case raster::ColorFormat::kRgba8:
            break;
        case raster::ColorFormat::kRgba16:
            bits = 16;
            break;
        case raster::ColorFormat::kRgba32F:
            bits = 32;
            break;
        case raster::ColorFormat::kRgb565:
            return {5, 6, 5, 0};
    }
    return {bits, bits, bits, format.has_alpha ? bits : 0};
}

ColorBuffer color_buffer_of(GLenum buffer) {
    return names_front(buffer) ? ColorBuffer::kFront : ColorBuffer::kBack;
}

ColorBuffer read_color_buffer(const Context& ctx) {
    return color_buffer_of(ctx.framebuffer.read_buffer);
}

void viewport(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    ViewportState& viewport = ctx.framebuffer.viewport;
    x = std::clamp(x, kMinViewportOrigin, kMaxViewportOrigin);
    y = std::clamp(y, kMinViewportOrigin, kMaxViewportOrigin);
    width = std::min(width, kMaxViewportSize);
    height = std::min(height, kMaxViewportSize);
    if (x == viewport.x && y == viewport.y && width == viewport.width && height == viewport.height) return;
    if (ctx.surface.draw && !ctx.surface.drawn) {
        ctx.surface.draw->follow_window(Follow::kOncePerPicture);
        follow_drawables(ctx);
    }
    begin_change(ctx, Dirty::kTransform);
    viewport.x = x;
    viewport.y = y;
    viewport.width = width;
    viewport.height = height;
}

void depth_range(Context& ctx, GLdouble n, GLdouble f) {
    const Dirty stale = ctx.matrix.transform.depth_clamp ? Dirty::kAll : Dirty::kTransform;
    change(ctx, stale, ctx.framebuffer.viewport.near_depth, clamp_depth(n));
    change(ctx, stale, ctx.framebuffer.viewport.far_depth, clamp_depth(f));
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
    const Framebuffer* const object = ctx.framebuffers.draw.get();
    const bool none_or_several = buf == GL_NONE || (buf == GL_FRONT_AND_BACK && !object);
    if (const GLenum error = none_or_several ? GL_NO_ERROR : check_buffer(ctx, buf, object)) {
        return record_error(ctx, error, "no such draw buffer");
    }
    select_draw_buffer(ctx, buf);
}

DrawTarget draw_target(Drawable& drawable, GLenum buffer) {
    using pipeline::DrawnColors;
    const bool both = buffer == GL_FRONT_AND_BACK || buffer == GL_LEFT;
    if (!drawable.is_double_buffered() || (!both && !names_front(buffer))) return {drawable.target()};
    return {drawable.target_with_front(), both ? DrawnColors::kBoth : DrawnColors::kSecond};
}

void select_draw_buffer(Context& ctx, GLenum buffer) {
    if (buffer == ctx.framebuffer.draw_buffer) return;
    // A front buffer that loses its context's attention is shown now: Flush looks only at what is drawn to
    // then.
    present(ctx);
    finish_drawing(ctx);
    use_draw_drawable(ctx, ctx.surface.draw, buffer);
    change(ctx, Dirty::kFragment, ctx.framebuffer.draw_buffer, buffer);
}

void read_buffer(Context& ctx, GLenum src) {
    if (const GLenum error = check_buffer(ctx, src, ctx.framebuffers.read.get()))
        return record_error(ctx, error, "no such read buffer");
    ctx.framebuffer.read_buffer = src;
}

}  // namespace terrazzo::gl
