// A unit's filtered texels (GL 1.5 §3.8.7-§3.8.8) for all entries of a batch, at the coordinates that were
// worked out before.
#pragma once

#include "raster/sample/anisotropic.h"
#include "raster/sample/cube.h"
#include "raster/stages/fetch.h"
#include "raster/stages/footprint.h"
#include "raster/stages/place.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

TERRAZZO_INLINE Batch::Words* packed_texels(const FragmentState& state, const TextureStage& stage,
                                            Batch& batch) {
    return reinterpret_cast<Batch::Words*>(texels_of(state, stage, batch, 0));
}

// One level, LINEAR.
template <bool kMasked>
void linear_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    const Sampler& sampler = stage.sampler;
    const MipLevel level = sampler.levels[0];
    const int count = batch.count;
    for (int i = 0; i < count; ++i) {
        const F32x16 s = load(batch.s[i]), t = load(batch.t[i]);
        if constexpr (kMasked) {
            masked_footprint(level, s, t, batch.footprints[i]);
        } else {
            linear_footprint(sampler, level, s, t, batch.footprints[i]);
        }
    }
    Batch::Words* const to = packed_texels(state, stage, batch);
    for (int i = 0; i < count; ++i)
        for (int p = 0; p < kParts; ++p)
            store_texels(join_texels(fetch_linear(batch.footprints[i], p)), p, to[i]);
}

// One level, NEAREST.
inline void nearest_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    const int count = batch.count;
    for (int i = 0; i < count; ++i)
        nearest_footprint(stage.sampler, stage.sampler.levels[0], load(batch.s[i]), load(batch.t[i]),
                          batch.footprints[i]);
    Batch::Words* const to = packed_texels(state, stage, batch);
    for (int i = 0; i < count; ++i)
        for (int p = 0; p < kParts; ++p) store_texels(fetch_nearest(batch.footprints[i], p), p, to[i]);
}

// Everything else, a tile at a time.
TERRAZZO_INLINE void sample_tile(const FragmentState& state, const TextureStage& stage, Batch& batch,
                                 int entry) {
    const Sampler& sampler = stage.sampler;
    const bool has_r = state.varyings.uses_r >> stage.unit & 1;
    const TexturePoint at{load(batch.s[entry]), load(batch.t[entry]),
                          has_r ? load(batch.r[entry]) : F32x16(0.0f)};
    const uint32_t mask = batch.masks[entry];
    const Color c = sampler.faces ? sample_cube(sampler, at, mask) : sample_texture(sampler, at, mask);
    std::byte* const to = texels_of(state, stage, batch, entry);
    if (!stage.texels_are_floats) return store(quantize_rgba8(c), reinterpret_cast<uint32_t*>(to));
    float* const channels = reinterpret_cast<float*>(to);
    store(c.r, channels), store(c.g, channels + 16), store(c.b, channels + 32), store(c.a, channels + 48);
}
inline void general_sample_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    for (int i = 0; i < batch.count; ++i) sample_tile(state, stage, batch, i);
}

// lambda of the pixels on a texture of one or two dimensions, as level_of_detail has it.
TERRAZZO_INLINE F32x16 plane_lambda(const Sampler& sampler, F32x16 s, F32x16 t) {
    F32x16 rho_x(0.0f), rho_y(0.0f);
    const auto add = [&](F32x16 coordinate, int32_t size) TERRAZZO_INLINE_LAMBDA {
        const F32x16 u = coordinate * F32x16(static_cast<float>(size));
        const F32x16 du_dx = swap_columns(u) - u, du_dy = swap_rows(u) - u;
        rho_x = rho_x + du_dx * du_dx, rho_y = rho_y + du_dy * du_dy;
    };
    add(s, sampler.levels[0].width);
    if (sampler.dimensions > 1) add(t, sampler.levels[0].height);
    return lambda_of(sampler, select(rho_x > rho_y, rho_x, rho_y), true);
}

// Which levels an entry's texels come from.
struct LevelChoice {
    enum Kind : uint8_t {
        kMagnified,  // all from the first level, with the magnification's filter
        kMinified,   // all from `first`, mixed with those of `second` where that is another
        kMixed       // not the same levels for all pixels
    } kind;
    int first, second;
};

// Stores the weights of the second level, in 256ths, where there is one.
TERRAZZO_INLINE LevelChoice choose_levels(const Sampler& sampler, F32x16 lambda, uint32_t mask,
                                          uint32_t* weights) {
    const uint32_t minified = bits_of(lambda > F32x16(0.0f)) & mask;
    if (minified == 0) return {LevelChoice::kMagnified, 0, 0};
    const int last = sampler.mip_filter == MipFilter::kNone ? 0 : sampler.level_count - 1;
    const bool mixes = sampler.mip_filter == MipFilter::kLinear;
    const F32x16 l = clamp(lambda, F32x16(0.0f), F32x16(static_cast<float>(last)));
    const F32x16 base = floor(mixes ? l : l + F32x16(0.5f));
    const I32x16 levels = truncate_to_int(base);
    alignas(64) int32_t level_of[16];
    store(levels, level_of);
    const int level = level_of[std::countr_zero(mask)];
    if (minified != mask || (bits_of(levels != I32x16(level)) & mask) != 0)
        return {LevelChoice::kMixed, 0, 0};
    if (mixes) store(truncate_to_int((l - base) * F32x16(256.0f)), weights);
    return {LevelChoice::kMinified, level, mixes ? std::min(level + 1, last) : level};
}

// The footprint of one level, with either filter.
TERRAZZO_INLINE void locate(const Sampler& sampler, int level, Filter filter, bool masked, F32x16 s, F32x16 t,
                            Batch::Footprint& to) {
    const MipLevel& mip = sampler.levels[static_cast<size_t>(level)];
    if (filter == Filter::kNearest) return nearest_footprint(sampler, mip, s, t, to);
    return masked ? masked_footprint(mip, s, t, to) : linear_footprint(sampler, mip, s, t, to);
}
TERRAZZO_INLINE NativeTexels fetch(const Batch::Footprint& from, Filter filter, int p) {
    return filter == Filter::kLinear ? fetch_linear(from, p) : split_texels(fetch_nearest(from, p));
}

// A mip-mapped texture of 8 bits whose coordinates repeat or are clamped to the edge, or one whose filters
// differ. Few entries have pixels of different levels; they are sampled one by one.
inline void mipmapped_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    const Sampler& sampler = stage.sampler;
    const bool masked = is_masked(sampler);
    const int count = batch.count;
    LevelChoice choices[kBatchTiles];
    alignas(64) Batch::Words weights[kBatchTiles];
    const auto filter_of = [&](const LevelChoice& choice) TERRAZZO_INLINE_LAMBDA {
        return choice.kind == LevelChoice::kMagnified ? sampler.mag_filter : sampler.min_filter;
    };
    for (int i = 0; i < count; ++i) {
        const F32x16 s = load(batch.s[i]), t = load(batch.t[i]);
        const LevelChoice choice = choices[i] =
            choose_levels(sampler, plane_lambda(sampler, s, t), batch.masks[i], weights[i]);
        if (choice.kind == LevelChoice::kMixed) continue;
        locate(sampler, choice.first, filter_of(choice), masked, s, t, batch.footprints[2 * i]);
        if (choice.second != choice.first)
            locate(sampler, choice.second, filter_of(choice), masked, s, t, batch.footprints[2 * i + 1]);
    }
    Batch::Words* const to = packed_texels(state, stage, batch);
    for (int i = 0; i < count; ++i) {
        const LevelChoice choice = choices[i];
        if (choice.kind == LevelChoice::kMixed) {
            sample_tile(state, stage, batch, i);
            continue;
        }
        const Filter filter = filter_of(choice);
        for (int p = 0; p < kParts; ++p) {
            NativeTexels texels = fetch(batch.footprints[2 * i], filter, p);
            if (choice.second != choice.first) {
                const auto* const weight = reinterpret_cast<const int32_t*>(weights[i]) + p * kNativeLanes;
                texels = lerp_texels(texels, fetch(batch.footprints[2 * i + 1], filter, p),
                                     twice_a_lane(hn::Load(TagI(), weight)));
            }
            store_texels(join_texels(texels), p, to[i]);
        }
    }
}

// Whether a texture's filtered texels have eight bits a channel.
TERRAZZO_INLINE bool has_packed_texels(const Sampler& sampler) {
    return samples_fixed(sampler) && !sampler.anisotropic;
}

TERRAZZO_INLINE UnitStage choose_sample_stage(const Sampler& sampler) {
    if (!has_packed_texels(sampler) || sampler.faces || sampler.dimensions > 2) return general_sample_stage;
    if (!filters_agree(sampler)) return mipmapped_stage;
    if (sampler.mag_filter == Filter::kNearest) return nearest_stage;
    return is_masked(sampler) ? linear_stage<true> : linear_stage<false>;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
