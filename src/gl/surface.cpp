// The surface a context draws to, and Flush and Finish (GL 1.5 §5.5).
#include "gl/surface.h"

#include "gl/context.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {

void attach_surface(Context& ctx, const Surface& surface) {
    begin_change(ctx, Dirty::kFramebuffer);
    const bool first = ctx.surface.target_desc.width == 0;
    const bool same = surface.target_desc == ctx.surface.target_desc;
    const bool drawn = same && ctx.surface.drawn;
    ctx.surface = surface;
    ctx.surface.drawn = drawn;
    if (first) {
        const auto& [width, height] = std::pair(surface.target_desc.width, surface.target_desc.height);
        viewport(ctx, 0, 0, width, height);
        scissor(ctx, 0, 0, width, height);
    }
}

void present(Context& ctx) {
    begin_change(ctx, Dirty::kFramebuffer);
    if (!ctx.surface.drawn || !ctx.surface.present) return;
    ctx.surface.drawn = false;
    ctx.surface.present(ctx, ctx.surface.front_end);
}

void flush(Context& ctx) {
    present(ctx);
}

// Nothing runs behind the caller's back once a picture is presented.
void finish(Context& ctx) {
    present(ctx);
}

}  // namespace terrazzo::gl
