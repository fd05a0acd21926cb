// The drawables a context draws to and reads from, and Flush and Finish (GL 1.5 §5.5).
#include "gl/surface.h"

#include <utility>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/framebuffer.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

// Everything that needs memory comes first.
void use_target(Context& ctx, Drawable* drawable, GLenum draw_buffer) {
    const auto [target, colors] = drawable ? draw_target(*drawable, draw_buffer) : DrawTarget{};
    if (target == ctx.renderer.target()) {
        if (colors != ctx.renderer.colors()) {
            flush_vertices(ctx);
            ctx.renderer.set_target(target, colors);
        }
        return;
    }
    begin_change(ctx, Dirty::kAll);
    ctx.renderer.set_target(target, colors);
    Surface& surface = ctx.surface;
    surface.drawn = false;
    surface.width = target ? target->width() : 0;
    surface.height = target ? target->height() : 0;
    surface.format = target ? target->format() : raster::TargetFormat{};
    if (!target || drawable != ctx.framebuffers.window_draw.get() ||
        std::exchange(ctx.framebuffer.has_met_drawable, true))
        return;
    ViewportState& viewport = ctx.framebuffer.viewport;
    ScissorState& scissor = ctx.fragment_ops.scissor;
    viewport.x = viewport.y = scissor.x = scissor.y = 0;
    viewport.width = scissor.width = target->width();
    viewport.height = scissor.height = target->height();
}

// Whether what is drawn while `draw_buffer` is chosen goes to the front buffer.
bool draws_to_front(const Drawable& drawable, GLenum draw_buffer) {
    return !drawable.is_double_buffered() || draw_buffer == GL_FRONT_AND_BACK || draw_buffer == GL_LEFT ||
           color_buffer_of(draw_buffer) == ColorBuffer::kFront;
}

}  // namespace

void attach_drawables(Context& ctx, std::shared_ptr<Drawable> draw, std::shared_ptr<Drawable> read) {
    finish_drawing(ctx);
    FramebufferBindings& bindings = ctx.framebuffers;
    const auto window_before = bindings.window_draw;
    bindings.window_draw = draw;
    if (!bindings.draw) {
        try {
            use_target(ctx, draw.get(), ctx.framebuffer.draw_buffer);
        } catch (...) {
            bindings.window_draw = window_before;
            throw;
        }
        ctx.surface.draw = draw;
    }
    bindings.window_read = read;
    if (!bindings.read) ctx.surface.read = std::move(read);
}

void use_draw_drawable(Context& ctx, std::shared_ptr<Drawable> drawable, GLenum buffer) {
    use_target(ctx, drawable.get(), buffer);
    ctx.surface.draw = std::move(drawable);
}

void follow_drawables(Context& ctx) {
    use_target(ctx, ctx.surface.draw.get(), ctx.framebuffer.draw_buffer);
}

void begin_drawing(Context& ctx) {
    if (std::exchange(ctx.surface.drawn, true)) return;
    if (!ctx.surface.draw) return;
    try {
        ctx.surface.draw->follow_window(Follow::kPictureBegins);
        follow_drawables(ctx);
    } catch (...) {
        ctx.surface.drawn = false;
        throw;
    }
    ctx.surface.drawn = true;
}

void present(Context& ctx) {
    begin_change(ctx, Dirty::kFramebuffer);
    const bool front = ctx.surface.draw && draws_to_front(*ctx.surface.draw, ctx.framebuffer.draw_buffer);
    if (!front || !ctx.surface.drawn) return;
    ctx.surface.draw->show_front(ctx);
    ctx.surface.drawn = false;
}

void present_window(Context& ctx) {
    present(ctx);
    FramebufferBindings& bindings = ctx.framebuffers;
    if (!bindings.draw || !bindings.window_draw) return;
    // All that was queued for the window was drawn when the object took its place.
    const bool front = draws_to_front(*bindings.window_draw, bindings.window_draw_buffer);
    if (!front || !bindings.window_drawn) return;
    bindings.window_draw->show_front(ctx);
    bindings.window_drawn = false;
}

void picture_was_shown(Context& ctx, const Drawable& window) {
    if (ctx.framebuffers.window_draw.get() != &window) return;
    (ctx.framebuffers.draw ? ctx.framebuffers.window_drawn : ctx.surface.drawn) = false;
}

void copy_picture(Context& ctx, Drawable& drawable, ColorBuffer buffer, raster::PixelLayout layout,
                  std::byte* bottom_row, std::ptrdiff_t stride) {
    if (ctx.surface.draw.get() == &drawable) flush_vertices(ctx);
    const auto target = drawable.target();
    if (!target || ctx.renderer.target() != target)
        return copy_picture(drawable, buffer, layout, bottom_row, stride);
    if (drawable.plane_of(buffer) != pipeline::shown_color(ctx.renderer.colors())) {
        ctx.renderer.finish();
        return copy_picture(drawable, buffer, layout, bottom_row, stride);
    }
    // Windows have their top row first.
    ctx.renderer.finish(layout, bottom_row + (target->height() - 1) * stride, -stride);
}

// Back buffers are drawn when they are swapped or read: nobody can see them before.
void flush(Context& ctx) {
    present(ctx);
}

// Nothing runs behind the caller's back once a picture is drawn.
void finish(Context& ctx) {
    present(ctx);
    ctx.renderer.finish();
}

}  // namespace terrazzo::gl
