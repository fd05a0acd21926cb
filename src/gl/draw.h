// From GL commands to the pipeline: draws, clears, and making queued work visible.
#pragma once

#include <GL/gl.h>

#include <array>
#include <memory>

#include "pipeline/geometry/renderer.h"

namespace terrazzo::gl {

struct Context;

// What lighting made of a raster position: that of the next one, too, where neither the attributes nor the
// lighting have changed and the light comes from far away.
struct LitColors {
    unsigned lighting = 0;  // Drawing::lighting_made; 0 for none
    std::array<float, 4> color{}, secondary{};
};

// What a context needs to draw; derived state is remade by validate() when ctx.dirty says so.
struct Drawing {
    pipeline::DrawState state;
    // What the derived state was made for besides the GL state.
    pipeline::AttributeMask streamed = 0;
    unsigned projective = 0;  // texture units, one bit each, whose coordinates may have a q other than 1
    std::array<float, 4> constant_color{}, constant_secondary{};
    bool secondary_varies = false;
    // The fragment state of the last bitmap or pixel rectangle, and whether state has changed since.
    std::shared_ptr<const pipeline::FragmentBlock> raster_fragment;
    pipeline::RasterState raster_box;
    bool raster_is_stale = true;
    raster::PixelImage raster_image = raster::PixelImage::kNone;
    bool raster_past_tests = false;
    std::array<float, 4> raster_color{};
    pipeline::ShadedVertices raster_vertices;  // the one vertex of a raster position that is lit
    pipeline::VertexInput raster_input;        // its attributes, all constant
    unsigned lighting_made = 0;                // how often lighting was derived
    LitColors raster_lit;
};

// Queues primitives of vertices that were specified under the present state. Throws std::bad_alloc.
void draw_primitives(Context& ctx, GLenum mode, const pipeline::VertexInput& input,
                     const pipeline::VertexRange& range);

// Brings ctx.drawing.state up to date for a draw of these attributes.
void validate(Context& ctx, const pipeline::VertexInput& input);

// The pixels that draws and clears may touch, in the target's rows.
void scissor_box(const Context& ctx, pipeline::RasterState& out);

// Hands over collected vertices and draws everything queued; the render target then holds the picture.
void finish_drawing(Context& ctx);

}  // namespace terrazzo::gl
