// Clears within one bin (GL 1.5 §4.2.3): deferred where the whole bin is cleared, else pixel by pixel through
// the scissor rectangle and the masks.
#pragma once

#include "raster/target/target.h"

namespace terrazzo::raster {

// A clear in a bin's list: of the whole bin where the rectangle and masks are full, else pixel by pixel.
struct BinClear {
    ClearPlanes planes;
    ClearValues values;
    int16_t x0, y0, x1, y1;
    uint8_t color_mask;  // bit 0 red ... bit 3 alpha
    uint8_t stencil_mask;
};

// Whether the clear covers every pixel of the target in the bin at (bin_x, bin_y), with all bits of its
// planes.
bool clears_whole_bin(const BinClear& clear, const Target& target, int bin_x, int bin_y);

// The same of all its bins.
bool clears_whole_target(const BinClear& clear, const Target& target);

// Lets `first` be what it and a later clear of the same pixels come to, both with all bits of their planes.
void join(const BinClear& later, BinClear& first);

void clear_bin(const BinClear& clear, Target& target, int bin);

}  // namespace terrazzo::raster
