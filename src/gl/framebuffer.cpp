// Flush and Finish (GL 1.5 §5.5).
#include "gl/framebuffer.h"

#include "gl/context.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {

void flush(Context& ctx) {
    begin_change(ctx, Dirty::kFramebuffer);
    if (ctx.surface.present) ctx.surface.present(ctx, ctx.surface.front_end);
}

// Nothing here runs behind the caller's back after a flush.
void finish(Context& ctx) {
    flush(ctx);
}

}  // namespace terrazzo::gl
