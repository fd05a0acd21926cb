// Rows of pixels out of a render target, in the forms that read-backs and copies start from.
//
// What is queued must have been drawn. (x, row) is in the target's own coordinates, row 0 the first in
// memory, and `count` pixels from there on lie within the target. Planes that are asked for must exist. Of a
// multisampled target a pixel's colour is the mean of its samples, depth and stencil are the first one's.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/target/target.h"

namespace terrazzo::raster {

// Whether bytes hold every colour of the format: what `read_color_rgba8` can take.
constexpr bool fits_rgba8(ColorFormat format) {
    return format == ColorFormat::kRgba8 || format == ColorFormat::kRgb565;
}

// Colour as R, G, B, A; alpha is 1 where the format has none. Components of fewer than 8 bits have their bits
// repeated.
void read_color_rgba8(Target& target, int x, int row, int count, uint8_t* rgba);
void read_color_float(Target& target, int x, int row, int count, float* rgba);

// Depth as an integer of the target's depth_bits.
void read_depth(Target& target, int x, int row, int count, uint32_t* depths);
void read_stencil(Target& target, int x, int row, int count, uint8_t* stencils);

}  // namespace terrazzo::raster
