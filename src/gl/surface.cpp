// The surface a context draws to, and Flush and Finish (GL 1.5 §5.5).
#include "gl/surface.h"

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {

void attach_surface(Context& ctx, const Surface& surface) {
    begin_change(ctx, Dirty::kFramebuffer);
    const bool first = ctx.surface.width == 0;
    const bool same = surface.width == ctx.surface.width && surface.height == ctx.surface.height &&
                      surface.format == ctx.surface.format;
    const bool drawn = same && ctx.surface.drawn;
    if (!same) {
        ctx.renderer.set_target(
            std::make_shared<raster::Target>(surface.width, surface.height, surface.format));
    }
    ctx.surface = surface;
    ctx.surface.drawn = drawn;
    if (first) {
        viewport(ctx, 0, 0, surface.width, surface.height);
        scissor(ctx, 0, 0, surface.width, surface.height);
    }
}

void present(Context& ctx) {
    begin_change(ctx, Dirty::kFramebuffer);
    if (!ctx.surface.drawn || !ctx.surface.present) return;
    ctx.surface.drawn = false;
    ctx.surface.present(ctx, ctx.surface.front_end);
}

void copy_picture(Context& ctx, pipeline::PixelLayout layout, std::byte* bottom_row, std::ptrdiff_t stride) {
    flush_vertices(ctx);
    // Row 0 of a window's target is its top row.
    std::byte* const top_row = bottom_row + (ctx.surface.height - 1) * stride;
    ctx.renderer.finish(layout, top_row, -stride);
}

void flush(Context& ctx) {
    present(ctx);
}

// Nothing runs behind the caller's back once a picture is presented.
void finish(Context& ctx) {
    present(ctx);
}

}  // namespace terrazzo::gl
