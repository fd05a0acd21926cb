// What each compiled instruction set offers to the code above it; one instance of the table per set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/primitive.h"
#include "raster/target/target.h"
#include "simd/isa.h"

namespace terrazzo::raster {

// A clear in a bin's list: of the whole bin where the rectangle and masks are full, else pixel by pixel.
struct BinClear {
    ClearPlanes planes;
    ClearValues values;
    int16_t x0, y0, x1, y1;
    uint8_t color_mask;  // bit 0 red ... bit 3 alpha
    uint8_t stencil_mask;
};

struct KernelTable {
    simd::Isa isa;
    // Chooses how the fragments of a state whose key and textures are there get their colours: its kernels,
    // or stages of its own and of its texture units.
    void (*choose)(FragmentState&, std::span<TextureStage> units);
    // Draws one primitive into one bin, whose planes are materialised; or leaves it in the batch, which
    // belongs to the bin until it is flushed.
    void (*draw_primitive)(const Primitive&, Bin&, Batch&);
    // The same for a bin of a multisampled target.
    void (*draw_multisampled)(const Primitive&, Bin&, Batch&);
    // Draws what is left in the batch.
    void (*flush)(Bin&, Batch&);
    // The mean of each pixel's samples: tiles of a bin's planes to one of a single sample.
    void (*resolve_rgba8)(const uint32_t* samples, const uint8_t* alike, int tile_count, uint32_t* to);
    // Stores `value` in `count` words, a multiple of 16, from a 64-byte boundary on.
    void (*fill)(uint32_t* to, uint32_t value, size_t count);
};

// The table in use: the best for this processor, or what TERRAZZO_ISA asks for where it can be had. Chosen
// once.
const KernelTable& kernels();

// Every table this processor can run, best first; for tests that compare them.
std::span<const KernelTable* const> compiled_kernels();

}  // namespace terrazzo::raster
