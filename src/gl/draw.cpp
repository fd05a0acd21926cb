// From GL commands to the pipeline; see draw.h.
#include "gl/draw.h"

#include <algorithm>
#include <cmath>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/translate.h"
#include "raster/target/color_format.h"

namespace terrazzo::gl {

void begin_change(Context& ctx, Dirty what) {
    // Between Begin and End only materials change, and those become attributes of the vertices.
    flush_vertices(ctx);
    ctx.dirty |= static_cast<unsigned>(what);
    ctx.drawing.raster_is_stale |= what != Dirty::kTransform;
}

void draw_primitives(Context& ctx, GLenum mode, const pipeline::VertexInput& input,
                     const pipeline::VertexRange& range) {
    if (ctx.render_mode.mode != GL_RENDER) return capture_primitives(ctx, mode, input, range);
    begin_drawing(ctx);
    validate(ctx, input);
    ctx.renderer.draw(ctx.drawing.state, input, translate_mode(mode), range);
}

void finish_drawing(Context& ctx) {
    flush_vertices(ctx);
    ctx.renderer.finish();
}

namespace {

std::uint32_t clear_depth_value(GLdouble depth, int bits) {
    if (bits == 0) return 0;
    const double maximum = bits == 16 ? 65535.0 : 16777215.0;
    return static_cast<std::uint32_t>(std::lrint(std::clamp(depth, 0.0, 1.0) * maximum));
}

// Queues a clear of all buffers but the one of accumulation.
void clear_queued(Context& ctx, GLbitfield mask) {
    const raster::TargetFormat& target = ctx.surface.format;
    const ColorBufferState& color = ctx.fragment_ops.color;
    const ClearValues& values = ctx.framebuffer.clear;
    raster::BinClear clear{};
    for (unsigned c = 0; c < 4; ++c) clear.color_mask |= static_cast<std::uint8_t>(color.write_mask[c] << c);
    clear.stencil_mask = static_cast<std::uint8_t>(ctx.fragment_ops.stencil.front.write_mask);
    clear.planes.color = (mask & GL_COLOR_BUFFER_BIT) && draws_colors(ctx) && clear.color_mask != 0;
    clear.planes.depth =
        (mask & GL_DEPTH_BUFFER_BIT) && target.depth_bits != 0 && ctx.fragment_ops.depth.write_mask;
    clear.planes.stencil =
        (mask & GL_STENCIL_BUFFER_BIT) && target.stencil_bits != 0 && clear.stencil_mask != 0;
    if (!clear.planes.color && !clear.planes.depth && !clear.planes.stencil) return;
    std::copy_n(values.color.data(), 4, clear.values.color);
    clear.values.depth = clear_depth_value(values.depth, target.depth_bits);
    clear.values.stencil = static_cast<std::uint8_t>(values.stencil);

    pipeline::RasterState box;
    scissor_box(ctx, box);
    clear.x0 = static_cast<std::int16_t>(box.x0);
    clear.y0 = static_cast<std::int16_t>(box.y0);
    clear.x1 = static_cast<std::int16_t>(box.x1);
    clear.y1 = static_cast<std::int16_t>(box.y1);
    // The reference draws a rectangle where it cannot clear all of the buffer, and rounds as for that.
    const std::uint8_t channels = target.has_alpha ? 0xf : 0x7;
    const bool whole =
        box.x0 == 0 && box.y0 == 0 && box.x1 == ctx.surface.width && box.y1 == ctx.surface.height;
    if (!whole || (clear.color_mask & channels) != channels)
        raster::round_as_drawn(target.color, clear.values.color);
    ctx.renderer.clear(clear);
}

}  // namespace

void clear(Context& ctx, GLbitfield mask) {
    constexpr GLbitfield kBuffers =
        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
    if (mask & ~kBuffers) return record_error(ctx, GL_INVALID_VALUE, "mask has bits that name no buffer");
    if (!check_framebuffer(ctx)) return;
    flush_vertices(ctx);
    begin_drawing(ctx);
    if (ctx.render_mode.mode != GL_RENDER) return;
    if (mask & GL_ACCUM_BUFFER_BIT) allocate_accumulation(ctx);
    clear_queued(ctx, mask);
    if (mask & GL_ACCUM_BUFFER_BIT) clear_accumulation(ctx);
}

}  // namespace terrazzo::gl
