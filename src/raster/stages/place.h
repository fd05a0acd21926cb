// The planes of a batch's entry, where its tile is.
#pragma once

#include "raster/batch.h"
#include "raster/pixel/interpolate.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Where the pixels are shaded.
TERRAZZO_INLINE Interpolator planes_of(const Batch& batch, const Bin& bin, int entry) {
    const Primitive& primitive = *batch.primitives[entry];
    Interpolator at(primitive, primitive.steep);
    const int tile = batch.tiles[entry];
    at.move_to(bin.x + tile % kTilesAcross * kTileSize, bin.y + tile / kTilesAcross * kTileSize);
    return at.at_offset(batch.to_centre, batch.to_centre);
}

// Whether a buffer's channels have more than eight bits.
TERRAZZO_INLINE bool has_wide_channels(ColorFormat format) {
    return format == ColorFormat::kRgba16 || format == ColorFormat::kRgba32F;
}

// The texels of a unit's first entry; the next ones follow at intervals of texel_bytes.
TERRAZZO_INLINE size_t texel_bytes(const TextureStage& stage) {
    return stage.texels_are_floats ? 4 * sizeof(Batch::Tile) : sizeof(Batch::Words);
}
TERRAZZO_INLINE std::byte* texels_of(const FragmentState& state, const TextureStage& stage, Batch& batch,
                                     int entry) {
    return batch.texels + state.stages.tiles * size_t{stage.texel_bytes_before} +
           static_cast<size_t>(entry) * texel_bytes(stage);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
