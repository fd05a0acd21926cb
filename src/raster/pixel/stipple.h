// Polygon stipple (GL 1.5 §3.5.2).
#pragma once

#include "raster/fragment_state.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Which pixels of a tile the 32x32 polygon stipple lets through. `y` counts upwards in the window.
TERRAZZO_INLINE uint32_t stipple_mask(const uint32_t* pattern, int x, int y, int step) {
    uint32_t mask = 0;
    for (int row = 0; row < 4; ++row, y += step) {
        const uint32_t bits = pattern[y & 31];
        for (int i = 0; i < 4; ++i) mask |= (bits >> (31 - ((x + i) & 31)) & 1) << (4 * row + i);
    }
    return mask;
}

TERRAZZO_INLINE uint32_t stippled_pixels(const FragmentState& state, int x, int y) {
    const int up = state.target_height_for_stipple;
    return up > 0 ? stipple_mask(state.polygon_stipple, x, up - 1 - y, -1)
                  : stipple_mask(state.polygon_stipple, x, y, 1);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
