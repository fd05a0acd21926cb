// A batch: tiles of one bin that wait for their fragments, of one or several primitives with one fragment
// state, in the order in which they were drawn.
//
// Coverage appends to it, and when it is full, or something else is to come, the stages of the state
// (raster/stages) run over all of it one after the other. What they hand on stands here too and fits into
// the L1 cache. The owner is a thread that draws a bin.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/primitive.h"
#include "raster/target/target.h"

namespace terrazzo::raster {

inline constexpr int kBatchTiles = 32;

struct alignas(64) Batch {
    using Tile = float[kTilePixels];
    using Words = uint32_t[kTilePixels];

    const FragmentState* state = nullptr;
    int count = 0;

    // Of each entry: where it is in its bin, which of its pixels are still alive (bit 4*y + x), and whose it
    // is.
    uint16_t tiles[kBatchTiles];
    uint16_t masks[kBatchTiles];
    const Primitive* primitives[kBatchTiles];
    // The same of each sample of a multisampled target; `masks` has the pixels of any of them then.
    uint16_t sample_masks[kBatchTiles][kMaxSamples];
    // From where a pixel's coordinates count to where it is shaded.
    float to_centre = 0;

    // 1 / (1/w), and the coordinates of the texture that is being sampled.
    alignas(64) Tile w[kBatchTiles];
    alignas(64) Tile s[kBatchTiles], t[kBatchTiles], r[kBatchTiles];
    // When all have been sampled: the alphas of fragments that are tested as floats.
    Tile (&alphas())[kBatchTiles] { return s; }

    // Where the texels are that a bilinear filter mixes: of each pixel the first of its lower and of its
    // higher row, counted from `base`, and weights. Two for each entry: mip levels are mixed in pairs.
    struct Footprint {
        alignas(64) int32_t low[kTilePixels];
        alignas(64) int32_t high[kTilePixels];
        alignas(64) uint32_t weights[kTilePixels];  // x << 7, and y << 23, in 256ths
        const int32_t* base;
        int32_t wrap_step;  // to the second column of the pixels in wraps
        uint16_t wraps;     // pixels whose second column is not the next in memory
    };
    Footprint footprints[2 * kBatchTiles];

    // Texels of all units: FragmentState::Stages::tiles entries of the first unit, then of the second, and so
    // on; an entry is 16 packed RGBA8 words, or four times 16 floats (TextureStage::texels_are_floats).
    static constexpr size_t kTexelBytes = kMaxTextureUnits * kBatchTiles * sizeof(Words);
    alignas(64) std::byte texels[kTexelBytes];

    // The colours that reach alpha test and blending: in eight bits a channel, or as floats where the buffer
    // has more.
    alignas(64) Words colors[kBatchTiles];
    alignas(64) Tile wide_colors[kBatchTiles][4];
};

}  // namespace terrazzo::raster
