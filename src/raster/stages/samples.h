// The first and the last stage of a batch of a multisampled target (GL 1.5 §3.2.1, §4.1.3): what there is of
// each sample. In between a pixel is shaded once, at its centre, as elsewhere.
#pragma once

#include "raster/pixel/shade_samples.h"
#include "raster/stages/output.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// The planes where a tile's pixels begin; planes_of has their centres.
TERRAZZO_INLINE Interpolator planes_of_corner(const Batch& batch, const Bin& bin, int entry) {
    return planes_of(batch, bin, entry).at_offset(-batch.to_centre, -batch.to_centre);
}

// Leaves an entry's masks where they belong; the pixels of any of them are shaded.
TERRAZZO_INLINE int keep_samples(Batch& batch, int entry, const SampleMasks& masks, int kept) {
    for (int s = 0; s < kMaxSamples; ++s) batch.sample_masks[kept][s] = static_cast<uint16_t>(masks.of[s]);
    return keep_entry(batch, entry, masks.any(), kept);
}

template <class Key>
TERRAZZO_INLINE void test_all_samples(Key key, const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = key.value;
    const bool tests = (k.depth_test || k.stencil_test) && tests_early(k);
    int kept = 0;
    for (int i = 0; i < batch.count; ++i) {
        SampleMasks masks(batch.sample_masks[i]);
        const int tile = batch.tiles[i];
        if (k.polygon_stipple)
            masks.keep(stippled_pixels(state, bin.x + tile % kTilesAcross * kTileSize,
                                       bin.y + tile / kTilesAcross * kTileSize));
        if (tests && masks.any() != 0)
            test_samples(key, state, *batch.primitives[i], planes_of_corner(batch, bin, i),
                         planes_of(batch, bin, i), bin, tile, masks);
        kept = keep_samples(batch, i, masks, kept);
    }
    batch.count = kept;
}

inline void general_sample_test_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    test_all_samples(RuntimeKey{state.key}, state, bin, batch);
}
template <Compare kFunc, bool kWrite>
void depth_sample_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    static constexpr FragmentKey kKey = [] {
        FragmentKey key;
        key.depth_test = true;
        key.depth_write = kWrite;
        key.depth_func = kFunc;
        return key;
    }();
    test_all_samples(ConstantKey<kKey>{}, state, bin, batch);
}

TERRAZZO_INLINE Stage choose_sample_test_stage(const FragmentState& state) {
    const FragmentKey& k = state.key;
    const bool tests = (k.depth_test || k.stencil_test) && tests_early(k);
    if (!tests && !k.polygon_stipple) return nullptr;
    if (!only_compares_depth(k) || k.depth_offset || !k.depth_write) return general_sample_test_stage;
    if (k.depth_func == Compare::kLess) return depth_sample_stage<Compare::kLess, true>;
    if (k.depth_func == Compare::kLessEqual) return depth_sample_stage<Compare::kLessEqual, true>;
    return general_sample_test_stage;
}

// What is left to be done after the tests, entry after entry.
template <class Output>
void sample_output_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = state.key;
    const RuntimeKey key{k};
    const Output output(state, batch);
    const bool late = !tests_early(k) && (k.depth_test || k.stencil_test), stores_only = output.stores_only();
    Bin planes[kMaxSamples];
    for (int s = 0; s < kMaxSamples; ++s) planes[s] = planes_of_sample(bin, s, k.color_format);
    for (int i = 0; i < batch.count; ++i) {
        SampleMasks masks(batch.sample_masks[i]);
        const int tile = batch.tiles[i];
        if (k.alpha_func != Compare::kAlways) masks.keep(output.passing(i));
        if (late && masks.any() != 0)
            test_samples(key, state, *batch.primitives[i], planes_of_corner(batch, bin, i),
                         planes_of(batch, bin, i), bin, tile, masks);
        for (int s = 0; s < kMaxSamples; ++s) batch.sample_masks[i][s] = static_cast<uint16_t>(masks.of[s]);
        if (masks.any() == 0 || k.color_mask == 0) continue;
        if (stores_only) {
            write_packed_samples(key, output.pixels(i), masks, bin, tile);
            continue;
        }
        const int samples = stays_alike(key, masks, bin, tile) ? 1 : kMaxSamples;
        for (int s = 0; s < samples; ++s)
            if (masks.of[s] != 0) output.write(i, masks.of[s], planes[s], tile);
    }
}

inline void count_all_samples(const FragmentState& state, Bin& bin, const Batch& batch) {
    uint64_t passed = 0;
    for (int i = 0; i < batch.count; ++i) passed += SampleMasks(batch.sample_masks[i]).count();
    bin.samples_passed += passed;
    if (state.samples_passed) __atomic_fetch_add(state.samples_passed, passed, __ATOMIC_RELAXED);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
