// Rows of pixels into a render target: what copies between targets and images made of rows end with.
//
// What is queued must have been drawn. (x, row) is in the target's own coordinates, row 0 the first in
// memory, and `count` pixels from there on lie within the target. Planes that are written to must exist.
#pragma once

#include <cstdint>

#include "raster/target/target.h"

namespace terrazzo::raster {

// Of a multisampled target all samples get the same.

// Colours as R, G, B, A, rounded as drawing rounds them.
void write_color(Target& target, int x, int row, int count, const float* rgba);
void write_color_rgba8(Target& target, int x, int row, int count, const uint8_t* rgba);

// Depth as an integer of the target's depth_bits.
void write_depth(Target& target, int x, int row, int count, const uint32_t* depths);
void write_stencil(Target& target, int x, int row, int count, const uint8_t* stencils);

// One pixel with all its samples from one multisampled target to another. Planes that are named exist in
// both, depths have the same format.
struct PixelPlace {
    Target& target;
    int x, row;
};
void copy_samples(const PixelPlace& from, const PixelPlace& to, ClearPlanes planes);

}  // namespace terrazzo::raster
