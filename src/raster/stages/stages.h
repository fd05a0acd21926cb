// The door of the stages: what the kernels of an instruction set call.
#pragma once

#include <span>

#include "raster/batch.h"
#include "raster/traverse/half_space.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// The part of KernelTable::choose that is about stages, and its flush.
void choose_stages(FragmentState& state, std::span<TextureStage> units);
void flush(Bin& bin, Batch& batch);
// Has what goes through a state's stages counted, once they are chosen (stage_log.h).
void count_stages(FragmentState& state);

// Adds the tiles that a primitive covers in a bin to its batch.
template <int kSamples>
TERRAZZO_INLINE void append(const Primitive& primitive, const CoveredTiles<kSamples>& list, Bin& bin,
                            Batch& batch) {
    const int limit = primitive.state->stages.tiles;
    batch.state = primitive.state;
    for (int i = 0; i < list.count; ++i) {
        if (batch.count == limit) flush(bin, batch);
        const auto& entry = list.entries[i];
        batch.tiles[batch.count] = entry.tile;
        batch.masks[batch.count] = entry.masks[0];
        if constexpr (kSamples > 1) {
            for (int s = 0; s < kSamples; ++s) {
                batch.sample_masks[batch.count][s] = entry.masks[s];
                batch.masks[batch.count] |= entry.masks[s];
            }
        }
        batch.primitives[batch.count] = &primitive;
        batch.count += batch.masks[batch.count] != 0;
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
