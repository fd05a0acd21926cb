// From texels to the colour of a fragment: primary colour, texture environments, secondary colour and fog
// (GL 1.5 §3.8.13, §3.9, §3.10), quantised to what the rest of its way works with.
#pragma once

#include "raster/pixel/combine.h"
#include "raster/pixel/fog_alpha.h"
#include "raster/stages/place.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

enum class Environments : uint8_t {
    kNone,
    kModulate,  // one unit, 8-bit texels
    kGeneral,
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

TERRAZZO_INLINE Color apply_environments(const FragmentState& state, Batch& batch, int entry,
                                         const Color& primary) {
    Color texels[kMaxTextureUnits];
    for (int u = 0; u < state.texture_count; ++u) {
        const TextureStage& stage = state.textures[u];
        texels[stage.unit] = color_of_texel(state, stage, batch, entry);
    }
    CombineInput in{texels, primary, primary, {}};
    for (int u = 0; u < state.texture_count; ++u) {
        const TextureStage& stage = state.textures[u];
        if (stage.mode != EnvMode::kCombine) {
            in.previous = combine_inline(stage, in.previous, texels[stage.unit]);
        } else {
            in.constant = uniform_color(stage.env_color);
            in.previous = combine_general(stage, in);
        }
    }
    return in.previous;
}

// `kPlain`: no flat colours, no secondary colour and no fog.
template <bool kInterpolated, Environments kEnvironments, bool kPlain>
void color_stage(const FragmentState& state, Bin& bin, Batch& batch) {
    const FragmentKey& k = state.key;
    const Color constant = uniform_color(state.constant_color);
    const Varyings v = state.varyings;
    const bool perspective = k.perspective, has_w = state.texture_count != 0, flat = !kPlain && k.flat_color;
    const TextureStage* const stage = state.textures;
    const I32x16 missing =
        kEnvironments == Environments::kModulate ? missing_channels(stage->base_format) : I32x16(0);
    const std::byte* const texels =
        kEnvironments == Environments::kModulate ? texels_of(state, *stage, batch, 0) : nullptr;
    // Tested against alpha as it is unless the buffer has eight bits of it.
    const bool keeps_alpha = k.alpha_func != Compare::kAlways && k.color_format != ColorFormat::kRgba8;
    for (int i = 0; i < batch.count; ++i) {
        [[maybe_unused]] Interpolator at = planes_of(batch, bin, i);
        Color c = constant;
        F32x16 w(1.0f);
        if constexpr (kInterpolated || !kPlain) {
            if (perspective) w = has_w ? load(batch.w[i]) : at.w();
        }
        if constexpr (kInterpolated) c = varying_color(at, v.color, flat, w);
        if constexpr (kEnvironments == Environments::kModulate) {
            const I32x16 texel = load(reinterpret_cast<const uint32_t*>(texels) + i * kTilePixels) | missing;
            const Color t = color_of_packed(texel);
            c = {c.r * t.r, c.g * t.g, c.b * t.b, c.a * t.a};
        }
        if constexpr (kEnvironments == Environments::kGeneral) c = apply_environments(state, batch, i, c);
        if constexpr (!kPlain) {
            if (k.separate_specular) {
                const auto second = [&](int channel) {
                    if (v.secondary < 0) return F32x16(state.constant_secondary[channel]);
                    return flat ? at.constant(v.secondary + channel) : at.varying(v.secondary + channel) * w;
                };
                c.r = c.r + second(0), c.g = c.g + second(1), c.b = c.b + second(2);
            }
            if (k.fog != FogMode::kNone) fog_inline(k.fog, state, at.varying(v.fog) * w, c);
        }
        if (keeps_alpha) store(c.a, batch.alphas()[i]);
        store(quantize_rgba8(c), batch.colors[i]);
    }
}

template <bool kInterpolated>
TERRAZZO_INLINE Stage choose_color_stage(const FragmentState& state) {
    const FragmentKey& k = state.key;
    const bool plain = !k.flat_color && !k.separate_specular && k.fog == FogMode::kNone;
    const bool modulates = state.texture_count == 1 && state.textures[0].mode == EnvMode::kModulate &&
                           !state.textures[0].texels_are_floats;
    const auto among = [plain](Stage if_plain, Stage other) { return plain ? if_plain : other; };
    if (state.texture_count == 0)
        return among(color_stage<kInterpolated, Environments::kNone, true>,
                     color_stage<kInterpolated, Environments::kNone, false>);
    if (modulates)
        return among(color_stage<kInterpolated, Environments::kModulate, true>,
                     color_stage<kInterpolated, Environments::kModulate, false>);
    return among(color_stage<kInterpolated, Environments::kGeneral, true>,
                 color_stage<kInterpolated, Environments::kGeneral, false>);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
