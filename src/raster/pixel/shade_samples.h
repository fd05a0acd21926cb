// shade_tiles on a multisampled target (GL 1.5 §3.2.1, §4.1.3): a pixel is shaded once, at its centre, for
// all of its samples that are covered; depth, stencil and the colours that are there belong to samples.
//
// A tile whose samples are all alike (raster/target/target.h) is worked on in the first sample's planes alone
// for as long as that remains so.
#pragma once

#include "raster/pixel/shade.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// Which pixels of a tile each sample covers.
struct SampleMasks {
    uint32_t of[kMaxSamples];

    TERRAZZO_INLINE explicit SampleMasks(const uint16_t (&masks)[kMaxSamples]) {
        for (int s = 0; s < kMaxSamples; ++s) of[s] = masks[s];
    }
    TERRAZZO_INLINE uint32_t any() const { return of[0] | of[1] | of[2] | of[3]; }
    TERRAZZO_INLINE bool alike() const { return of[0] == of[1] && of[0] == of[2] && of[0] == of[3]; }
    TERRAZZO_INLINE void keep(uint32_t pixels) {
        for (uint32_t& mask : of) mask &= pixels;
    }
    TERRAZZO_INLINE uint32_t count() const {
        return static_cast<uint32_t>(
            std::popcount(uint64_t{of[0]} << 48 | uint64_t{of[1]} << 32 | of[2] << 16 | of[3]));
    }
};

// The first sample's values of some pixels to the others.
template <class Value>
TERRAZZO_NOINLINE void copy_to_samples(Value* plane, int tile, uint32_t pixels) {
    Value* const first = plane + tile * kTilePixels;
    for (int s = 1; s < kMaxSamples; ++s)
        for (int i = 0; i < kTilePixels; ++i)
            if (pixels >> i & 1) first[s * kBinPixels + i] = first[i];
}

// `corner` and `centre` are where the tile's pixels begin and where they are shaded. Without multisampling
// the first sample's test decides for all and all get its depth and stencil, which GL 1.5 §4.1.9 allows and
// the reference does.
template <class Key>
TERRAZZO_NOINLINE void test_samples(Key key, const FragmentState& state, const Primitive& primitive,
                                    const Interpolator& corner, const Interpolator& centre, const Bin& bin,
                                    int tile, SampleMasks& masks) {
    const FragmentKey& k = key.value;
    const bool depths_alike = !k.depth_test || bin.depth_alike[tile],
               stencils_alike = !k.stencil_test || bin.stencil_alike[tile];
    const bool level = primitive.dadx()[0] == 0 && primitive.dady()[0] == 0;
    const bool once = !state.multisample || (level && depths_alike && stencils_alike && masks.alike());
    const uint32_t tested = masks.of[0];
    if (!once && k.depth_write) spread_tile(bin.depth, tile, sizeof *bin.depth, bin.depth_alike);
    if (!once && k.stencil_test) spread_tile(bin.stencil, tile, sizeof *bin.stencil, bin.stencil_alike);
    for (int s = 0; s < (once ? 1 : kMaxSamples); ++s) {
        if (masks.of[s] == 0) continue;
        Bin planes = planes_of_sample(bin, s, k.color_format);
        if (k.depth_test && bin.depth_alike[tile]) planes.depth = bin.depth;
        const SamplePosition place = kSamplePositions[s];
        const Interpolator at = once || level ? centre
                                              : corner.at_offset(static_cast<float>(place.x) / 256.0f,
                                                                 static_cast<float>(place.y) / 256.0f);
        masks.of[s] =
            depth_stencil_test(key, state, state.depth_bits, primitive, at, planes, tile, masks.of[s]);
    }
    if (!once) return;
    for (uint32_t& mask : masks.of) mask = masks.of[0];
    if (k.depth_write && !bin.depth_alike[tile]) copy_to_samples(bin.depth, tile, masks.of[0]);
    if (k.stencil_test && !bin.stencil_alike[tile]) copy_to_samples(bin.stencil, tile, tested);
}

// Makes the tile ready for a store of one colour a pixel through the masks. Whether the first sample's planes
// are all that is to be written.
template <class Key>
TERRAZZO_INLINE bool stays_alike(Key key, const SampleMasks& masks, const Bin& bin, int tile) {
    const FragmentKey& k = key.value;
    if (masks.alike()) {
        const bool reads = k.blend != BlendKind::kNone || k.logic_op || k.color_mask != 0xf;
        if (masks.of[0] == 0xffff && !reads) bin.color_alike[tile] = 1;
        if (bin.color_alike[tile]) return true;
    }
    spread_tile(bin.color, tile, static_cast<size_t>(bytes_per_pixel(k.color_format)), bin.color_alike);
    return false;
}

template <class Key>
TERRAZZO_INLINE void write_packed_samples(Key key, I32x16 packed, const SampleMasks& masks, const Bin& bin,
                                          int tile) {
    if (stays_alike(key, masks, bin, tile)) return write_packed_rgba8(packed, masks.of[0], bin, tile);
    for (int s = 0; s < kMaxSamples; ++s)
        write_packed_rgba8(packed, masks.of[s], planes_of_sample(bin, s, ColorFormat::kRgba8), tile);
}

template <class Key>
TERRAZZO_INLINE void write_samples(Key key, const FragmentState& state, const Color& color,
                                   const SampleMasks& masks, const Bin& bin, int tile) {
    const FragmentKey& k = key.value;
    if (k.color_mask == 0) return;
    if (k.color_format == ColorFormat::kRgba8 && k.blend == BlendKind::kNone && !k.logic_op &&
        k.color_mask == 0xf)
        return write_packed_samples(key, finish_rgba8(key, state, color, I32x16(0)), masks, bin, tile);
    const int samples = stays_alike(key, masks, bin, tile) ? 1 : kMaxSamples;
    for (int s = 0; s < samples; ++s) {
        if (masks.of[s] != 0)
            write_color(key, state, color, masks.of[s], planes_of_sample(bin, s, k.color_format), tile);
    }
}

template <class Key>
TERRAZZO_INLINE void shade_samples(Key key, const FragmentState& state, const Primitive& primitive,
                                   Bin& shared_bin, const SampleList& list) {
    const FragmentKey& k = key.value;
    const Bin bin = shared_bin;
    const SharedByTiles shared(state);
    Interpolator corner(primitive, Key::kTakesSteep && primitive.steep);
    const float to_centre = state.multisample ? 0.5f : 0.0f;
    const bool tests = k.depth_test || k.stencil_test;
    const bool early =
        k.alpha_func == Compare::kAlways && k.coverage != Coverage::kPoint && !k.alpha_to_coverage;
    uint64_t passed = 0;
    for (int i = 0; i < list.count; ++i) {
        const int tile = list.entries[i].tile;
        SampleMasks masks(list.entries[i].masks);
        const int x = bin.x + tile % kTilesAcross * kTileSize, y = bin.y + tile / kTilesAcross * kTileSize;
        corner.move_to(x, y);
        const Interpolator centre = corner.at_offset(to_centre, to_centre);
        if (k.polygon_stipple) masks.keep(stippled_pixels(state, x, y));
        if (early && tests && masks.any() != 0)
            test_samples(key, state, primitive, corner, centre, bin, tile, masks);
        uint32_t pixels = masks.any();
        if (pixels == 0) continue;
        if (k.counts_samples && early) passed += masks.count();
        if (early && k.color_mask == 0) continue;
        if (k.image == PixelImage::kVerbatim) {
            write_packed_samples(key, load(centre.image_tile<uint32_t, 16>(primitive)), masks, bin, tile);
            continue;
        }
        Color color = shade_fragment(key, state, shared, primitive, centre, pixels);
        if (!early) {
            masks.keep(pixels);
            if (k.alpha_to_coverage) {
                // As many samples as alpha has quarters, begun ones too.
                for (int s = 0; s < kMaxSamples; ++s)
                    masks.of[s] &= bits_of(color.a > F32x16(static_cast<float>(s) / kMaxSamples));
            }
        }
        if (k.alpha_to_one) color.a = F32x16(1.0f);
        if (!early) {
            masks.keep(bits_of(alpha_test(k.alpha_func, state, k.color_format, color.a)));
            if (tests && masks.any() != 0)
                test_samples(key, state, primitive, corner, centre, bin, tile, masks);
            if (masks.any() == 0) continue;
            if (k.counts_samples) passed += masks.count();
        }
        write_samples(key, state, color, masks, bin, tile);
    }
    if (!k.counts_samples) return;
    shared_bin.samples_passed += passed;
    if (state.samples_passed) __atomic_fetch_add(state.samples_passed, passed, __ATOMIC_RELAXED);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
