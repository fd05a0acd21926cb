// The colours of a multisampled bin as they are seen: each pixel the mean of its samples (GL 1.5 §4.2.1
// leaves open how they are combined; so does the reference).
//
// Tiles go to where they lie in a plane of one sample. What is queued must have been drawn and the bin be
// materialised.
#pragma once

#include <cstddef>

#include "raster/target/target.h"

namespace terrazzo::raster {

// Room for a bin's pixels in any format.
struct ResolvedPixels {
    alignas(64) std::byte bytes[kBinPixels * 16];
};

// Some of a bin's tiles, row by row from `first_tile` on.
void resolve_samples(const Bin& bin, ColorFormat format, int first_tile, int tile_count, ResolvedPixels& to);

// The mean of one pixel's samples before it is rounded; `pixel` counts within the bin.
void mean_of_samples(const Bin& bin, ColorFormat format, int pixel, float (&rgba)[4]);

}  // namespace terrazzo::raster
