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

TERRAZZO_INLINE TexturePoint point_of(const FragmentState& state, const TextureStage& stage,
                                      const Batch& batch, int entry) {
    const bool has_r = state.varyings.uses_r >> stage.unit & 1;
    return {load(batch.s[entry]), load(batch.t[entry]), has_r ? load(batch.r[entry]) : F32x16(0.0f)};
}
TERRAZZO_INLINE void store_sample(const FragmentState& state, const TextureStage& stage, const Color& c,
                                  Batch& batch, int entry) {
    std::byte* const to = texels_of(state, stage, batch, entry);
    if (!stage.texels_are_floats) return store(quantize_rgba8(c), reinterpret_cast<uint32_t*>(to));
    float* const channels = reinterpret_cast<float*>(to);
    store(c.r, channels), store(c.g, channels + 16), store(c.b, channels + 32), store(c.a, channels + 48);
}

// Everything else, a tile at a time.
TERRAZZO_INLINE void sample_tile(const FragmentState& state, const TextureStage& stage, Batch& batch,
                                 int entry) {
    const Sampler& sampler = stage.sampler;
    const TexturePoint at = point_of(state, stage, batch, entry);
    const uint32_t mask = batch.masks[entry];
    store_sample(state, stage,
                 sampler.faces ? sample_cube(sampler, at, mask) : sample_texture(sampler, at, mask), batch,
                 entry);
}
inline void general_sample_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    for (int i = 0; i < batch.count; ++i) sample_tile(state, stage, batch, i);
}

// Of each of a tile's quads: the square of the larger of its scale factors, as level_of_detail has it.
TERRAZZO_INLINE void quads_squared_rho(const Sampler& sampler, const Batch& batch, int entry, float* to) {
    F32x16 rho_x(0.0f), rho_y(0.0f);
    const auto add = [&](F32x16 coordinate, int32_t size) TERRAZZO_INLINE_LAMBDA {
        const F32x16 u = coordinate * F32x16(static_cast<float>(size));
        const F32x16 du_dx = swap_columns(u) - u, du_dy = swap_rows(u) - u;
        rho_x = rho_x + du_dx * du_dx, rho_y = rho_y + du_dy * du_dy;
    };
    add(load(batch.s[entry]), sampler.levels[0].width);
    if (sampler.dimensions > 1) add(load(batch.t[entry]), sampler.levels[0].height);
    if (sampler.dimensions > 2) add(load(batch.r[entry]), sampler.levels[0].depth);
    alignas(64) float of_pixels[kTilePixels];
    store(select(rho_x > rho_y, rho_x, rho_y), of_pixels);
    to[0] = of_pixels[0], to[1] = of_pixels[2], to[2] = of_pixels[8], to[3] = of_pixels[10];
}

// Of all quads of a batch, four an entry: 0 where the texture is magnified, else the number of the first
// level that its texels come from, plus 1; and the weight of the next level, in 256ths.
struct QuadLevels {
    static constexpr int kQuads = 4 * kBatchTiles;
    alignas(64) int32_t codes[kQuads], weights[kQuads];
};

// Sixteen quads, whichever tiles they belong to.
TERRAZZO_INLINE void choose_levels(const Sampler& sampler, F32x16 squared_rho, int32_t* codes,
                                   int32_t* weights) {
    const F32x16 lambda = lambda_of(sampler, squared_rho, false);
    const int last = sampler.mip_filter == MipFilter::kNone ? 0 : sampler.level_count - 1;
    const F32x16 l = clamp(lambda, F32x16(0.0f), F32x16(static_cast<float>(last)));
    const F32x16 base = floor(sampler.mip_filter == MipFilter::kLinear ? l : l + F32x16(0.5f));
    store(select(lambda > F32x16(0.0f), truncate_to_int(base) + I32x16(1), I32x16(0)), codes);
    store(truncate_to_int((l - base) * F32x16(256.0f)), weights);
}

inline void choose_levels(const Sampler& sampler, const Batch& batch, QuadLevels& levels) {
    alignas(64) float squared_rho[QuadLevels::kQuads];
    const int count = batch.count, quads = 4 * count;
    for (int i = 0; i < count; ++i) quads_squared_rho(sampler, batch, i, squared_rho + 4 * i);
    for (int q = quads; q % kTilePixels != 0; ++q) squared_rho[q] = 1;
    for (int q = 0; q < quads; q += kTilePixels)
        choose_levels(sampler, load(squared_rho + q), levels.codes + q, levels.weights + q);
}

// Which levels an entry's texels come from: all from the first, mixed with those of the second where that is
// another. One number, which is written and read again whole.
class LevelChoice {
  public:
    enum Kind : uint32_t { kMagnified, kMinified, kMixed /* not the same for all quads */ };

    LevelChoice() = default;
    TERRAZZO_INLINE LevelChoice(Kind kind, int first, int second)
        : m_code(kind << 16 | static_cast<uint32_t>(second) << 8 | static_cast<uint32_t>(first)) {}
    TERRAZZO_INLINE Kind kind() const { return static_cast<Kind>(m_code >> 16); }
    TERRAZZO_INLINE int first() const { return static_cast<int>(m_code & 0xff); }
    TERRAZZO_INLINE int second() const { return static_cast<int>(m_code >> 8 & 0xff); }

  private:
    uint32_t m_code;
};
static_assert(kMaxMipLevels <= 0xff);

TERRAZZO_INLINE LevelChoice choice_of(const Sampler& sampler, const int32_t* codes, uint32_t mask) {
    const int first_pixel = std::countr_zero(mask);
    const int32_t code = codes[first_pixel / 8 * 2 + first_pixel % 4 / 2];
    // Without branches: which quads are alive nobody can foretell.
    const auto difference = [&](int quad, uint32_t pixels) TERRAZZO_INLINE_LAMBDA {
        return (mask & pixels) != 0 ? codes[quad] ^ code : 0;
    };
    if ((difference(0, 0x0033) | difference(1, 0x00cc) | difference(2, 0x3300) | difference(3, 0xcc00)) != 0)
        return {LevelChoice::kMixed, 0, 0};
    if (code == 0) return {LevelChoice::kMagnified, 0, 0};
    const int level = code - 1;
    const bool mixes = sampler.mip_filter == MipFilter::kLinear;
    return {LevelChoice::kMinified, level, mixes ? std::min(level + 1, sampler.level_count - 1) : level};
}
// Quads' values for their pixels.
TERRAZZO_INLINE void spread_quads(const int32_t* quads, uint32_t* pixels) {
    for (int half = 0; half < 2; ++half)
        for (int i = 0; i < 4; ++i) {
            const auto value = static_cast<uint32_t>(quads[2 * half + i / 2]);
            pixels[8 * half + i] = pixels[8 * half + 4 + i] = value;
        }
}

// What a mip-mapped stage is made for.
enum class MipKind : uint8_t {
    kMaskedLinear,  // both filters LINEAR, coordinates that repeat by masks
    kLinear,        // both LINEAR
    kAny
};

// The footprint of one level, with either filter.
template <MipKind kKind>
TERRAZZO_INLINE void locate(const Sampler& sampler, int level, Filter filter, F32x16 s, F32x16 t,
                            Batch::Footprint& to) {
    const MipLevel& mip = sampler.levels[static_cast<size_t>(level)];
    if constexpr (kKind == MipKind::kMaskedLinear) return masked_footprint(mip, s, t, to);
    if (kKind == MipKind::kAny && filter == Filter::kNearest)
        return nearest_footprint(sampler, mip, s, t, to);
    linear_footprint(sampler, mip, s, t, to);
}
template <MipKind kKind>
TERRAZZO_INLINE NativeTexels fetch(const Batch::Footprint& from, Filter filter, int p) {
    if (kKind == MipKind::kAny && filter == Filter::kNearest) return split_texels(fetch_nearest(from, p));
    return fetch_linear(from, p);
}

// A mip-mapped texture of 8 bits whose coordinates repeat or are clamped to the edge, or one whose filters
// differ. Few entries have pixels of different levels; they are sampled one by one.
template <MipKind kKind>
void mipmapped_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    const Sampler& sampler = stage.sampler;
    const int count = batch.count;
    QuadLevels levels;
    choose_levels(sampler, batch, levels);
    LevelChoice choices[kBatchTiles];
    const auto filter_of = [&](const LevelChoice& choice) TERRAZZO_INLINE_LAMBDA {
        return choice.kind() == LevelChoice::kMagnified ? sampler.mag_filter : sampler.min_filter;
    };
    for (int i = 0; i < count; ++i) {
        const LevelChoice choice = choice_of(sampler, levels.codes + 4 * i, batch.masks[i]);
        choices[i] = choice;
        if (choice.kind() == LevelChoice::kMixed) continue;
        const F32x16 s = load(batch.s[i]), t = load(batch.t[i]);
        locate<kKind>(sampler, choice.first(), filter_of(choice), s, t, batch.footprints[2 * i]);
        if (choice.second() != choice.first())
            locate<kKind>(sampler, choice.second(), filter_of(choice), s, t, batch.footprints[2 * i + 1]);
    }
    Batch::Words* const to = packed_texels(state, stage, batch);
    for (int i = 0; i < count; ++i) {
        const LevelChoice choice = choices[i];
        if (choice.kind() == LevelChoice::kMixed) {
            sample_tile(state, stage, batch, i);
            continue;
        }
        const Filter filter = filter_of(choice);
        if (choice.second() == choice.first()) {
            for (int p = 0; p < kParts; ++p)
                store_texels(join_texels(fetch<kKind>(batch.footprints[2 * i], filter, p)), p, to[i]);
            continue;
        }
        alignas(64) uint32_t weights[kTilePixels];
        spread_quads(levels.weights + 4 * i, weights);
        for (int p = 0; p < kParts; ++p) {
            const auto weight =
                hn::Load(TagI(), reinterpret_cast<const int32_t*>(weights) + p * kNativeLanes);
            const NativeTexels first = fetch<kKind>(batch.footprints[2 * i], filter, p),
                               second = fetch<kKind>(batch.footprints[2 * i + 1], filter, p);
            store_texels(join_texels(lerp_texels(first, second, twice_a_lane(weight))), p, to[i]);
        }
    }
}

// Any other texture whose level is to be chosen, but cube maps: levels are chosen for the whole batch, texels
// fetched a tile at a time.
inline void mipmapped_tiles_stage(const FragmentState& state, const TextureStage& stage, Bin&, Batch& batch) {
    const Sampler& sampler = stage.sampler;
    QuadLevels levels;
    choose_levels(sampler, batch, levels);
    for (int i = 0; i < batch.count; ++i) {
        const LevelChoice choice = choice_of(sampler, levels.codes + 4 * i, batch.masks[i]);
        if (choice.kind() == LevelChoice::kMixed) {
            sample_tile(state, stage, batch, i);
            continue;
        }
        const TexturePoint at = point_of(state, stage, batch, i);
        alignas(64) uint32_t weights[kTilePixels];
        spread_quads(levels.weights + 4 * i, weights);
        store_sample(state, stage,
                     choice.kind() == LevelChoice::kMagnified
                         ? sample_level(sampler, 0, sampler.mag_filter, at)
                         : sample_minified(sampler, choice.first(), load(weights), at),
                     batch, i);
    }
}

inline UnitStage choose_mipmapped_stage(const Sampler& sampler) {
    if (sampler.min_filter != Filter::kLinear || sampler.mag_filter != Filter::kLinear)
        return mipmapped_stage<MipKind::kAny>;
    return is_masked(sampler) ? mipmapped_stage<MipKind::kMaskedLinear> : mipmapped_stage<MipKind::kLinear>;
}

// Whether a texture's filtered texels have eight bits a channel.
TERRAZZO_INLINE bool has_packed_texels(const Sampler& sampler) {
    return samples_fixed(sampler) && !sampler.anisotropic;
}

TERRAZZO_INLINE UnitStage choose_sample_stage(const Sampler& sampler) {
    if (!has_packed_texels(sampler) || sampler.faces || sampler.dimensions > 2) {
        const bool has_levels = !sampler.faces && !sampler.anisotropic && !filters_agree(sampler);
        return has_levels ? mipmapped_tiles_stage : general_sample_stage;
    }
    if (!filters_agree(sampler)) return choose_mipmapped_stage(sampler);
    if (sampler.mag_filter == Filter::kNearest) return nearest_stage;
    return is_masked(sampler) ? linear_stage<true> : linear_stage<false>;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
