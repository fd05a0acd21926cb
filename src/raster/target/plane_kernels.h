// What targets need of the instruction set in use: the part of its table that knows nothing of primitives.
#pragma once

#include <cstddef>
#include <cstdint>

namespace terrazzo::raster {

struct PlaneKernels {
    // The mean of each pixel's samples: tiles of a bin's planes to one of a single sample.
    void (*resolve_rgba8)(const uint32_t* samples, const uint8_t* alike, int tile_count, uint32_t* to);
    // Stores `value` in `count` words, a multiple of 16, from a 64-byte boundary on.
    void (*fill)(uint32_t* to, uint32_t value, size_t count);
};

// Those of raster::kernels(), which stands further up.
const PlaneKernels& plane_kernels();

}  // namespace terrazzo::raster
