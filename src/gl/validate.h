// Parts of validate() that have files of their own.
#pragma once

#include <memory>

#include "pipeline/geometry/vertex_input.h"
#include "pipeline/geometry/vertex_state.h"
#include "pipeline/schedule/fragment_block.h"

namespace terrazzo::gl {

struct Context;

// Lighting and what becomes of normals. `vertex` has its texture coordinates already, and the modelview
// matrix is settled: both say which space lighting happens in.
void make_lighting(const Context& ctx, const pipeline::VertexInput& input, pipeline::VertexState& vertex);

// Texture coordinates of a unit that samples something, or that feedback asks for.
void make_texture_coordinates(Context& ctx, int number, pipeline::TextureCoordinates& out);

// What fragments go through that get their colours, texture coordinates and fog distance from the current
// raster position, where `image` does not give them. See draw_pixel_rect() for `past_tests`.
std::shared_ptr<const pipeline::FragmentBlock> make_raster_fragment(Context& ctx, raster::PixelImage image,
                                                                    bool past_tests);

}  // namespace terrazzo::gl
