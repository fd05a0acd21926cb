// Texture environments (GL 1.5 §3.8.13, tables 3.22-3.26): what a unit makes of the incoming colour and its
// texel, and with COMBINE of other units' texels too. In floats, in the reference's order.
#pragma once

#include "raster/fragment_state.h"
#include "raster/pixel/color.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

TERRAZZO_INLINE Color combine(const TextureStage& stage, const Color& f, const Color& t) {
    const BaseFormat base = stage.base_format;
    const bool has_color = base != BaseFormat::kAlpha;
    const bool has_alpha = base != BaseFormat::kLuminance && base != BaseFormat::kRgb;
    const float* const c = stage.env_color;
    Color out = f;
    switch (stage.mode) {
        case EnvMode::kReplace:
            if (has_color) out = {t.r, t.g, t.b, f.a};
            if (has_alpha) out.a = t.a;
            return out;
        case EnvMode::kModulate:
            if (has_color) out = {f.r * t.r, f.g * t.g, f.b * t.b, f.a};
            if (has_alpha) out.a = f.a * t.a;
            return out;
        case EnvMode::kDecal: {
            // Defined for RGB and RGBA only; without alpha the texel replaces the colour.
            if (base == BaseFormat::kRgb) return {t.r, t.g, t.b, f.a};
            const F32x16 rest = F32x16(1.0f) - t.a;
            return {f.r * rest + t.r * t.a, f.g * rest + t.g * t.a, f.b * rest + t.b * t.a, f.a};
        }
        case EnvMode::kBlend: {
            const F32x16 one(1.0f);
            if (has_color) {
                out = {f.r * (one - t.r) + F32x16(c[0]) * t.r, f.g * (one - t.g) + F32x16(c[1]) * t.g,
                       f.b * (one - t.b) + F32x16(c[2]) * t.b, f.a};
            }
            if (base == BaseFormat::kIntensity) {
                out.a = f.a * (one - t.a) + F32x16(c[3]) * t.a;
            } else if (has_alpha) {
                out.a = f.a * t.a;
            }
            return out;
        }
        case EnvMode::kAdd: {
            const auto sum = [](F32x16 a, F32x16 b) { return clamp(a + b, F32x16(0.0f), F32x16(1.0f)); };
            if (has_color) out = {sum(f.r, t.r), sum(f.g, t.g), sum(f.b, t.b), f.a};
            if (base == BaseFormat::kIntensity) {
                out.a = sum(f.a, t.a);
            } else if (has_alpha) {
                out.a = f.a * t.a;
            }
            return out;
        }
        case EnvMode::kCombine:
            break;
    }
    return out;
}

// One channel of one half, of arguments whose complements have not been taken: the reference adds constants
// to them first, and knows that 1 - (1 - c) is c (doc/reference.md §4).
TERRAZZO_INLINE F32x16 combine_channel(const CombineHalf& half, F32x16 a, F32x16 b, F32x16 c) {
    const F32x16 one(1.0f), minus_half(-0.5f), plus_half(0.5f);
    const F32x16 raw[3] = {a, b, c};
    const auto value = [&](int i) { return half.arguments[i].complement ? one - raw[i] : raw[i]; };
    const auto rest = [&](int i) { return half.arguments[i].complement ? raw[i] : one - raw[i]; };
    const auto less_half = [&](int i) {
        return half.arguments[i].complement ? plus_half - raw[i] : raw[i] + minus_half;
    };
    switch (half.function) {
        case CombineFunction::kReplace:
            return value(0);
        case CombineFunction::kModulate:
            return value(0) * value(1);
        case CombineFunction::kAdd:
            return value(0) + value(1);
        case CombineFunction::kAddSigned:
            return less_half(0) + value(1);
        case CombineFunction::kInterpolate:
            return value(0) * value(2) + value(1) * rest(2);
        case CombineFunction::kSubtract:
            return value(0) - value(1);
        case CombineFunction::kModulateAdd:
            return value(0) * value(2) + value(1);
        case CombineFunction::kModulateSignedAdd:
            return value(0) * value(2) + less_half(1);
        case CombineFunction::kModulateSubtract:
            return value(0) * value(2) - value(1);
        case CombineFunction::kDot3Rgb:
        case CombineFunction::kDot3Rgba:
            break;
    }
    return value(0);
}

TERRAZZO_INLINE F32x16 combine_dot3(const CombineHalf& half, const Color& a, const Color& b) {
    const F32x16 one(1.0f), two(2.0f);
    const auto term = [&](F32x16 x, F32x16 y) {
        if (half.arguments[0].complement) x = one - x;
        if (half.arguments[1].complement) y = one - y;
        return (x * two - one) * (y * two - one);
    };
    return term(a.b, b.b) + term(a.g, b.g) + term(a.r, b.r);
}

// Whether a result of arguments in [0, 1] may lie outside.
TERRAZZO_INLINE bool leaves_range(CombineFunction function) {
    return function != CombineFunction::kReplace && function != CombineFunction::kModulate &&
           function != CombineFunction::kInterpolate;
}

TERRAZZO_INLINE bool is_dot3(CombineFunction function) {
    return function == CombineFunction::kDot3Rgb || function == CombineFunction::kDot3Rgba;
}

// Colours as combiners choose from them: in memory, a channel at a time.
struct ColorChannels {
    alignas(64) float channel[4][kTilePixels];

    TERRAZZO_INLINE void operator=(const Color& c) {
        store(c.r, channel[0]), store(c.g, channel[1]), store(c.b, channel[2]), store(c.a, channel[3]);
    }
    TERRAZZO_INLINE Color color() const {
        return {load(channel[0]), load(channel[1]), load(channel[2]), load(channel[3])};
    }
};

// Texture environments of several units for 16 pixels.
class Combiner {
  public:
    TERRAZZO_INLINE Combiner() {
        m_zero = Color{0.0f, 0.0f, 0.0f, 0.0f};
        m_one = Color{1.0f, 1.0f, 1.0f, 1.0f};
    }

    // The filtered texel of a unit that samples.
    TERRAZZO_INLINE void set_texel(int unit, const Color& texel) { m_texels[unit] = texel; }

    // All units, one after the other; the texels are there.
    TERRAZZO_INLINE Color run(const FragmentState& state, const Color& primary) {
        m_primary = primary;
        m_previous = primary;
        for (int u = 0; u < state.texture_count; ++u) {
            const TextureStage& stage = state.textures[u];
            m_previous = stage.mode == EnvMode::kCombine
                             ? combine_general(stage)
                             : combine(stage, m_previous.color(), m_texels[stage.unit].color());
        }
        return m_previous.color();
    }

  private:
    TERRAZZO_INLINE const ColorChannels& source(CombineSource source) const {
        switch (source) {
            case CombineSource::kPrimary:
                return m_primary;
            case CombineSource::kPrevious:
                return m_previous;
            case CombineSource::kConstant:
                return m_constant;
            case CombineSource::kZero:
                return m_zero;
            case CombineSource::kOne:
                return m_one;
            default:
                return m_texels[static_cast<int>(source)];
        }
    }
    TERRAZZO_INLINE F32x16 argument(const CombineArgument& a, int channel) const {
        return load(source(a.source).channel[a.alpha ? 3 : channel]);
    }
    TERRAZZO_INLINE F32x16 channel(const CombineHalf& half, int channel) const {
        return combine_channel(half, argument(half.arguments[0], channel),
                               argument(half.arguments[1], channel), argument(half.arguments[2], channel));
    }

    TERRAZZO_INLINE Color combine_general(const TextureStage& stage) {
        const auto bounded = [](F32x16 v)
                                 TERRAZZO_INLINE_LAMBDA { return clamp(v, F32x16(0.0f), F32x16(1.0f)); };
        m_constant = uniform_color(stage.env_color);
        const CombineHalf &rgb = stage.rgb, &alpha = stage.alpha;
        F32x16 out[4];
        if (is_dot3(rgb.function)) {
            const auto color = [&](const CombineArgument& a) TERRAZZO_INLINE_LAMBDA {
                return Color{argument(a, 0), argument(a, 1), argument(a, 2), F32x16(0.0f)};
            };
            out[0] = out[1] = out[2] = combine_dot3(rgb, color(rgb.arguments[0]), color(rgb.arguments[1]));
        } else {
            for (int c = 0; c < 3; ++c) out[c] = channel(rgb, c);
        }
        // What is scaled is bounded afterwards.
        if (rgb.scale == 1 && leaves_range(rgb.function))
            for (int c = 0; c < 3; ++c) out[c] = bounded(out[c]);
        if (rgb.function == CombineFunction::kDot3Rgba) {
            out[3] = out[0];
        } else {
            out[3] = channel(alpha, 3);
            if (alpha.scale == 1 && leaves_range(alpha.function)) out[3] = bounded(out[3]);
        }
        if (rgb.scale != 1 || alpha.scale != 1) {
            for (int c = 0; c < 3; ++c) out[c] = bounded(out[c] * F32x16(rgb.scale));
            out[3] = bounded(out[3] * F32x16(alpha.scale));
        }
        return {out[0], out[1], out[2], out[3]};
    }

    ColorChannels m_texels[kMaxTextureUnits];
    ColorChannels m_primary, m_previous, m_constant, m_zero, m_one;
};
}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
