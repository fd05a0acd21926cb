// The walk of one primitive's fragments from coverage to the tile, stage after stage in GL's order. Every
// kernel is this function: with a constant key its branches fold away, with a run-time key it serves all
// state.
#pragma once

#include <bit>

#include "raster/pixel/combine.h"
#include "raster/pixel/coverage.h"
#include "raster/pixel/depth_stencil.h"
#include "raster/pixel/fog_alpha.h"
#include "raster/pixel/interpolate.h"
#include "raster/pixel/key.h"
#include "raster/pixel/stipple.h"
#include "raster/pixel/write.h"
#include "raster/sample/anisotropic.h"
#include "raster/sample/cube.h"
#include "raster/sample/filter.h"
#include "raster/traverse/half_space.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// What the tiles of a primitive share, read once: the compiler has to expect that a store to a tile changes
// everything that is not a local variable.
struct SharedByTiles {
    TERRAZZO_INLINE explicit SharedByTiles(const FragmentState& state)
        : constant_color(uniform_color(state.constant_color)), depth_bits(state.depth_bits) {}

    Color constant_color;
    int depth_bits;
};

template <class Key>
TERRAZZO_INLINE Color primary_color(Key key, const FragmentState& state, const SharedByTiles& shared,
                                    const Primitive& primitive, const Interpolator& at, F32x16 w) {
    if (key.value.image == PixelImage::kRgba8)
        return from_color8(unpack_rgba8(load(at.image_tile<uint32_t, 16>(primitive))));
    if (key.value.image == PixelImage::kRgba32F) {
        const float* const channels = at.image_tile<float, 64>(primitive);
        return {load(channels), load(channels + 16), load(channels + 32), load(channels + 48)};
    }
    if (!key.value.interpolated_color) return shared.constant_color;
    const int first = state.varyings.color;
    if (key.value.flat_color)
        return {at.constant(first), at.constant(first + 1), at.constant(first + 2), at.constant(first + 3)};
    Color c{at.varying(first), at.varying(first + 1), at.varying(first + 2), at.varying(first + 3)};
    if (key.value.perspective) c = {c.r * w, c.g * w, c.b * w, c.a * w};
    return c;
}

TERRAZZO_NOINLINE Color apply_textures(const FragmentState& state, const Interpolator& at, Color color,
                                       uint32_t mask) {
    const F32x16 w = at.exact_w();
    Combiner combiner;
    for (int i = 0; i < state.texture_count; ++i) {
        const TextureStage& stage = state.textures[i];
        const int first = state.varyings.texture[stage.unit];
        TexturePoint point{at.exact_varying(first) * w, at.exact_varying(first + 1) * w, 0.0f};
        if (state.varyings.uses_r >> stage.unit & 1) point.r = at.exact_varying(first + 2) * w;
        if (state.varyings.projective >> stage.unit & 1) {
            const F32x16 scale = F32x16(1.0f) / (at.exact_varying(first + 3) * w);
            point = {point.s * scale, point.t * scale, point.r * scale};
        }
        combiner.set_texel(stage.unit, stage.sampler.faces ? sample_cube(stage.sampler, point, mask)
                                                           : sample_texture(stage.sampler, point, mask));
    }
    return combiner.run(state, color);
}

template <class Key>
TERRAZZO_INLINE Color shade_fragment(Key key, const FragmentState& state, const SharedByTiles& shared,
                                     const Primitive& primitive, const Interpolator& at, uint32_t& mask) {
    const FragmentKey& k = key.value;
    const F32x16 w = k.perspective ? at.w() : F32x16(1.0f);
    Color color = primary_color(key, state, shared, primitive, at, w);
    if (k.textured) color = apply_textures(state, at, color, mask);
    if (k.separate_specular) {
        const int first = state.varyings.secondary;
        const auto second = [&](int i) {
            if (first < 0) return F32x16(state.constant_secondary[i]);
            return k.flat_color ? at.constant(first + i) : at.varying(first + i) * w;
        };
        color.r = color.r + second(0);
        color.g = color.g + second(1);
        color.b = color.b + second(2);
    }
    if (k.fog != FogMode::kNone) apply_fog(k.fog, state, at.varying(state.varyings.fog) * w, color);
    if (k.coverage != Coverage::kNone) mask = apply_coverage(k.coverage, state, at, w, color.a, mask);
    return color;
}

template <class Key>
TERRAZZO_INLINE void shade_tiles(Key key, const FragmentState& state, const Primitive& primitive,
                                 Bin& shared_bin, const TileList& list) {
    const FragmentKey& k = key.value;
    const Bin bin = shared_bin;
    const SharedByTiles shared(state);
    Interpolator at(primitive, Key::kTakesSteep && primitive.steep);
    // Where nothing that comes before the depth test can discard a fragment, the test comes first.
    const bool early = k.alpha_func == Compare::kAlways && k.coverage != Coverage::kPoint;
    uint64_t passed = 0;
    for (int i = 0; i < list.count; ++i) {
        const int tile = list.entries[i].tile;
        uint32_t mask = list.entries[i].masks[0];
        const int x = bin.x + tile % kTilesAcross * kTileSize, y = bin.y + tile / kTilesAcross * kTileSize;
        at.move_to(x, y);
        if (k.polygon_stipple) {
            mask &= stippled_pixels(state, x, y);
            if (mask == 0) continue;
        }
        if (early && (k.depth_test || k.stencil_test)) {
            mask = depth_stencil_test(key, state, shared.depth_bits, primitive, at, bin, tile, mask);
            if (mask == 0) continue;
        }
        if (k.counts_samples && early) passed += static_cast<uint32_t>(std::popcount(mask));
        if (early && k.color_mask == 0) continue;
        if (k.image == PixelImage::kVerbatim) {
            write_packed_rgba8(load(at.image_tile<uint32_t, 16>(primitive)), mask, bin, tile);
            continue;
        }
        const Color color = shade_fragment(key, state, shared, primitive, at, mask);
        if (!early) {
            mask &= bits_of(alpha_test(k.alpha_func, state, k.color_format, color.a));
            if (mask == 0) continue;
            if (k.depth_test || k.stencil_test) {
                mask = depth_stencil_test(key, state, shared.depth_bits, primitive, at, bin, tile, mask);
                if (mask == 0) continue;
            }
            if (k.counts_samples) passed += static_cast<uint32_t>(std::popcount(mask));
        }
        write_color(key, state, color, mask, bin, tile);
    }
    if (!k.counts_samples) return;
    shared_bin.samples_passed += passed;
    if (state.samples_passed) __atomic_fetch_add(state.samples_passed, passed, __ATOMIC_RELAXED);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
