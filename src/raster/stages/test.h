// First stage of a batch: polygon stipple, stencil and depth test, in order. Entries of which no pixel is
// left are taken out.
#pragma once

#include <bit>

#include "raster/pixel/depth_stencil.h"
#include "raster/pixel/key.h"
#include "raster/pixel/stipple.h"
#include "raster/stages/place.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// Moves an entry that is still alive to its new place.
TERRAZZO_INLINE int keep_entry(Batch& batch, int entry, uint32_t mask, int kept) {
    batch.tiles[kept] = batch.tiles[entry];
    batch.masks[kept] = static_cast<uint16_t>(mask);
    batch.primitives[kept] = batch.primitives[entry];
    return kept + (mask != 0);
}

// Nothing but the comparison with what is there, whether it passes or not without a branch.
template <Compare kFunc, bool kWrite>
void depth_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const int depth_bits = state.depth_bits, count = batch.count;
    uint32_t* const plane = bin.depth;
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        const I32x16 depth = quantize_depth(planes_of(batch, bin, i).depth(), depth_bits);
        uint32_t* const stored = plane + batch.tiles[i] * kTilePixels;
        const Mask16 pass = compare(kFunc, depth, load(stored)) & mask_from_bits(batch.masks[i]);
        if (kWrite) store_masked(pass, depth, stored);
        kept = keep_entry(batch, i, bits_of(pass), kept);
    }
    batch.count = kept;
}

// The same with any comparison, and with an offset of polygons: shadow maps are drawn with one.
template <bool kWrite>
void any_depth_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const Compare func = state.key.depth_func;
    const bool is_offset = state.key.depth_offset;
    const int depth_bits = state.depth_bits, count = batch.count;
    uint32_t* const plane = bin.depth;
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        F32x16 z = planes_of(batch, bin, i).depth();
        if (is_offset) z = z + F32x16(batch.primitives[i]->depth_offset);
        const I32x16 depth = quantize_depth(z, depth_bits);
        uint32_t* const stored = plane + batch.tiles[i] * kTilePixels;
        const Mask16 pass = compare(func, depth, load(stored)) & mask_from_bits(batch.masks[i]);
        if (kWrite) store_masked(pass, depth, stored);
        kept = keep_entry(batch, i, bits_of(pass), kept);
    }
    batch.count = kept;
}

// All that there is, chosen as it runs.
inline void general_test_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = state.key;
    const RuntimeKey key{k};
    int kept = 0;
    for (int i = 0; i < batch.count; ++i) {
        uint32_t mask = batch.masks[i];
        const int tile = batch.tiles[i];
        if (k.polygon_stipple)
            mask &= stippled_pixels(state, bin.x + tile % kTilesAcross * kTileSize,
                                    bin.y + tile / kTilesAcross * kTileSize);
        if (mask != 0 && (k.depth_test || k.stencil_test) && tests_early(k))
            mask = depth_stencil_test(key, state, state.depth_bits, *batch.primitives[i],
                                      planes_of(batch, bin, i), bin, tile, mask);
        kept = keep_entry(batch, i, mask, kept);
    }
    batch.count = kept;
}

// Whether a state's test is a comparison of depths and no more.
TERRAZZO_INLINE bool only_compares_depth(const FragmentKey& k) {
    return k.depth_test && !k.stencil_test && !k.polygon_stipple && !k.depth_clamp;
}

template <bool kWrite>
TERRAZZO_INLINE Stage depth_stage_for(const FragmentKey& k) {
    if (k.depth_offset) return any_depth_stage<kWrite>;
    switch (k.depth_func) {
        case Compare::kLess:
            return depth_stage<Compare::kLess, kWrite>;
        case Compare::kLessEqual:
            return depth_stage<Compare::kLessEqual, kWrite>;
        case Compare::kEqual:
            return depth_stage<Compare::kEqual, kWrite>;
        default:
            return any_depth_stage<kWrite>;
    }
}

TERRAZZO_INLINE Stage choose_test_stage(const FragmentState& state) {
    const FragmentKey& k = state.key;
    if (tests_early(k)) {
        if (only_compares_depth(k))
            return k.depth_write ? depth_stage_for<true>(k) : depth_stage_for<false>(k);
        return k.depth_test || k.stencil_test || k.polygon_stipple ? general_test_stage : nullptr;
    }
    // Depths only come nearer while a batch is drawn: what fails now would fail later too.
    if (only_compares_depth(k) && (k.depth_func == Compare::kLess || k.depth_func == Compare::kLessEqual))
        return depth_stage_for<false>(k);
    return k.polygon_stipple ? general_test_stage : nullptr;
}

// What occlusion queries and statistics ask for.
inline void count_samples(const FragmentState& state, Bin& bin, const Batch& batch) {
    uint64_t passed = 0;
    for (int i = 0; i < batch.count; ++i)
        passed += static_cast<uint64_t>(std::popcount(static_cast<uint32_t>(batch.masks[i])));
    bin.samples_passed += passed;
    if (state.samples_passed) __atomic_fetch_add(state.samples_passed, passed, __ATOMIC_RELAXED);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
