// Rectangles of pixels at the current raster position, on their way to the pipeline: what Bitmap, DrawPixels
// and CopyPixels have in common (GL 1.5 §3.6.4, §3.7).
#pragma once

#include "pipeline/geometry/renderer.h"

namespace terrazzo::gl {

struct Context;

// A window coordinate that fits an integer, as are sums with sizes; no window reaches further. NaN is far to
// the left.
constexpr float kFarAway = 1 << 24;
inline float bounded(float coordinate) {
    const float not_left = coordinate > -kFarAway ? coordinate : -kFarAway;
    return not_left < kFarAway ? not_left : kFarAway;
}

// Queues `rect`, whose pixels and data are filled in, with the depth, colours, texture coordinates and fog
// distance of the current raster position. `past_tests`: depths go to their buffer through its mask, and
// nothing else happens, as with stencil values in any case. begin_drawing() has been called. Throws
// std::bad_alloc.
void draw_pixel_rect(Context& ctx, raster::PixelImage image, pipeline::PixelRect& rect,
                     bool past_tests = false);

// Sets where the rectangle's tiles are and returns how many there are.
std::size_t lay_out_tiles(pipeline::PixelRect& rect);

}  // namespace terrazzo::gl
