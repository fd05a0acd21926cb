// From texels to the colour of a fragment: primary colour, texture environments, secondary colour and fog
// (GL 1.5 §3.8.13, §3.9, §3.10), quantised to what the rest of its way works with.
#pragma once

#include <type_traits>

#include "raster/pixel/combine.h"
#include "raster/pixel/fog_alpha.h"
#include "raster/stages/place.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

enum class Environments : uint8_t {
    kNone,
    kModulate,  // of all units, which have 8-bit texels
    kGeneral,   // no unit combines
    kCombine,
};

TERRAZZO_INLINE Color varying_color(const Interpolator& at, int first, bool flat, F32x16 w) {
    if (flat)
        return {at.constant(first), at.constant(first + 1), at.constant(first + 2), at.constant(first + 3)};
    return {at.varying(first) * w, at.varying(first + 1) * w, at.varying(first + 2) * w,
            at.varying(first + 3) * w};
}

// Bytes of a texel that modulation leaves out, as 1.
TERRAZZO_INLINE I32x16 missing_channels(BaseFormat format) {
    if (format == BaseFormat::kAlpha) return I32x16(0x00ffffff);
    const bool no_alpha = format == BaseFormat::kRgb || format == BaseFormat::kLuminance;
    return I32x16(no_alpha ? static_cast<int32_t>(0xff000000u) : 0);
}

TERRAZZO_INLINE Color color_of_texel(const FragmentState& state, const TextureStage& stage, Batch& batch,
                                     int entry) {
    const std::byte* const texels = texels_of(state, stage, batch, entry);
    if (!stage.texels_are_floats) return color_of_packed(load(reinterpret_cast<const uint32_t*>(texels)));
    const float* const channels = reinterpret_cast<const float*>(texels);
    return {load(channels), load(channels + 16), load(channels + 32), load(channels + 48)};
}

// The texels of units that all modulate, looked up once a batch.
class ModulatingUnits {
  public:
    TERRAZZO_INLINE ModulatingUnits(const FragmentState& state, Batch& batch) : m_count(state.texture_count) {
        for (int u = 0; u < m_count; ++u) {
            const TextureStage& stage = state.textures[u];
            m_texels[u] = reinterpret_cast<const Batch::Words*>(texels_of(state, stage, batch, 0));
            store(missing_channels(stage.base_format), m_missing[u]);
        }
    }
    TERRAZZO_INLINE Color apply(int entry, Color c) const {
        for (int u = 0; u < m_count; ++u) {
            const Color t = color_of_packed(load(m_texels[u][entry]) | load(m_missing[u]));
            c = {c.r * t.r, c.g * t.g, c.b * t.b, c.a * t.a};
        }
        return c;
    }

  private:
    int m_count;
    const Batch::Words* m_texels[kMaxTextureUnits];
    alignas(64) uint32_t m_missing[kMaxTextureUnits][kTilePixels];
};

TERRAZZO_INLINE Color apply_environments(const FragmentState& state, Batch& batch, int entry, Color c) {
    for (int u = 0; u < state.texture_count; ++u) {
        const TextureStage& stage = state.textures[u];
        c = combine(stage, c, color_of_texel(state, stage, batch, entry));
    }
    return c;
}

TERRAZZO_INLINE Color combine_all(Combiner& combiner, const FragmentState& state, Batch& batch, int entry,
                                  const Color& primary) {
    for (int u = 0; u < state.texture_count; ++u) {
        const TextureStage& stage = state.textures[u];
        combiner.set_texel(stage.unit, color_of_texel(state, stage, batch, entry));
    }
    return combiner.run(state, primary);
}

// Alphas are tested as they are unless the buffer has eight bits of them.
TERRAZZO_INLINE bool tests_float_alpha(const FragmentKey& k) {
    return k.alpha_func != Compare::kAlways && k.color_format == ColorFormat::kRgb565;
}

struct Nothing {
    TERRAZZO_INLINE Nothing() = default;
    TERRAZZO_INLINE Nothing(const FragmentState&, Batch&) {}
};

// `kPlain`: no flat colours, no secondary colour, no fog, and nothing but packed bytes is handed on.
template <bool kInterpolated, Environments kEnvironments, bool kPlain>
void color_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = state.key;
    const Color constant = uniform_color(state.constant_color);
    const Varyings v = state.varyings;
    const bool perspective = k.perspective, has_w = state.texture_count != 0, flat = !kPlain && k.flat_color;
    [[maybe_unused]] std::conditional_t<kEnvironments == Environments::kCombine, Combiner, Nothing> combiner;
    const std::conditional_t<kEnvironments == Environments::kModulate, ModulatingUnits, Nothing> modulating(
        state, batch);
    const bool is_wide = !kPlain && has_wide_channels(k.color_format),
               keeps_alpha = !kPlain && tests_float_alpha(k);
    for (int i = 0; i < batch.count; ++i) {
        [[maybe_unused]] Interpolator at = planes_of(batch, bin, i);
        Color c = constant;
        F32x16 w(1.0f);
        if constexpr (kInterpolated || !kPlain) {
            if (perspective) w = has_w ? load(batch.w[i]) : at.w();
        }
        if constexpr (kInterpolated) c = varying_color(at, v.color, flat, w);
        if constexpr (kEnvironments == Environments::kModulate) c = modulating.apply(i, c);
        if constexpr (kEnvironments == Environments::kGeneral) c = apply_environments(state, batch, i, c);
        if constexpr (kEnvironments == Environments::kCombine) c = combine_all(combiner, state, batch, i, c);
        if constexpr (!kPlain) {
            if (k.separate_specular) {
                const auto second = [&](int channel) TERRAZZO_INLINE_LAMBDA {
                    if (v.secondary < 0) return F32x16(state.constant_secondary[channel]);
                    return flat ? at.constant(v.secondary + channel) : at.varying(v.secondary + channel) * w;
                };
                c.r = c.r + second(0), c.g = c.g + second(1), c.b = c.b + second(2);
            }
            if (k.fog != FogMode::kNone) fog_inline(k.fog, state, at.varying(v.fog) * w, c);
        }
        if (keeps_alpha) store(c.a, batch.alphas()[i]);
        if (is_wide) {
            store(c.r, batch.wide_colors[i][0]), store(c.g, batch.wide_colors[i][1]);
            store(c.b, batch.wide_colors[i][2]), store(c.a, batch.wide_colors[i][3]);
        } else {
            store(quantize_rgba8(c), batch.colors[i]);
        }
    }
}

inline Environments environments_of(const FragmentState& state) {
    if (state.texture_count == 0) return Environments::kNone;
    bool modulate = true;
    for (int u = 0; u < state.texture_count; ++u) {
        const TextureStage& stage = state.textures[u];
        if (stage.mode == EnvMode::kCombine) return Environments::kCombine;
        modulate = modulate && stage.mode == EnvMode::kModulate && !stage.texels_are_floats;
    }
    return modulate ? Environments::kModulate : Environments::kGeneral;
}

template <bool kInterpolated>
TERRAZZO_INLINE Stage choose_color_stage(const FragmentState& state) {
    const FragmentKey& k = state.key;
    const bool plain = !k.flat_color && !k.separate_specular && k.fog == FogMode::kNone &&
                       !has_wide_channels(k.color_format) && !tests_float_alpha(k);
    switch (environments_of(state)) {
        case Environments::kNone:
            return plain ? color_stage<kInterpolated, Environments::kNone, true>
                         : color_stage<kInterpolated, Environments::kNone, false>;
        case Environments::kModulate:
            return plain ? color_stage<kInterpolated, Environments::kModulate, true>
                         : color_stage<kInterpolated, Environments::kModulate, false>;
        case Environments::kGeneral:
            return plain ? color_stage<kInterpolated, Environments::kGeneral, true>
                         : color_stage<kInterpolated, Environments::kGeneral, false>;
        case Environments::kCombine:
            break;
    }
    return plain ? color_stage<kInterpolated, Environments::kCombine, true>
                 : color_stage<kInterpolated, Environments::kCombine, false>;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
