// Texture environments (GL 1.5 §3.8.13, tables 3.22-3.26): what a unit makes of the incoming colour and its
// texel, and with COMBINE of other units' texels too. In floats, in the reference's order.
#pragma once

#include "raster/pixel/color.h"
#include "raster/state.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

TERRAZZO_INLINE Color combine_inline(const TextureStage& stage, const Color& f, const Color& t) {
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

TERRAZZO_NOINLINE Color combine(const TextureStage& stage, const Color& f, const Color& t) {
    return combine_inline(stage, f, t);
}

// What the arguments of a combiner choose from.
struct CombineInput {
    const Color* texels;  // of each unit that samples
    Color primary, previous, constant;
};

TERRAZZO_INLINE Color combine_source(const CombineInput& in, CombineSource source) {
    switch (source) {
        case CombineSource::kPrimary:
            return in.primary;
        case CombineSource::kPrevious:
            return in.previous;
        case CombineSource::kConstant:
            return in.constant;
        case CombineSource::kZero:
            return {0.0f, 0.0f, 0.0f, 0.0f};
        case CombineSource::kOne:
            return {1.0f, 1.0f, 1.0f, 1.0f};
        default:
            return in.texels[static_cast<int>(source)];
    }
}

// An argument before its complement is taken.
TERRAZZO_INLINE Color combine_argument(const CombineInput& in, const CombineArgument& argument) {
    Color c = combine_source(in, argument.source);
    if (argument.alpha) c.r = c.g = c.b = c.a;
    return c;
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

TERRAZZO_NOINLINE Color combine_general(const TextureStage& stage, const CombineInput& in) {
    const auto bounded = [](F32x16 v) { return clamp(v, F32x16(0.0f), F32x16(1.0f)); };
    const CombineHalf &rgb = stage.rgb, &alpha = stage.alpha;
    const Color a = combine_argument(in, rgb.arguments[0]), b = combine_argument(in, rgb.arguments[1]),
                c = combine_argument(in, rgb.arguments[2]);
    Color out;
    if (is_dot3(rgb.function)) {
        out.r = out.g = out.b = combine_dot3(rgb, a, b);
    } else {
        out.r = combine_channel(rgb, a.r, b.r, c.r);
        out.g = combine_channel(rgb, a.g, b.g, c.g);
        out.b = combine_channel(rgb, a.b, b.b, c.b);
    }
    // What is scaled is bounded afterwards.
    if (rgb.scale == 1 && leaves_range(rgb.function)) {
        out.r = bounded(out.r);
        out.g = bounded(out.g);
        out.b = bounded(out.b);
    }
    if (rgb.function == CombineFunction::kDot3Rgba) {
        out.a = out.r;
    } else {
        const auto argument = [&](int i) { return combine_argument(in, alpha.arguments[i]).a; };
        out.a = combine_channel(alpha, argument(0), argument(1), argument(2));
        if (alpha.scale == 1 && leaves_range(alpha.function)) out.a = bounded(out.a);
    }
    if (rgb.scale == 1 && alpha.scale == 1) return out;
    const F32x16 k(rgb.scale);
    return {bounded(out.r * k), bounded(out.g * k), bounded(out.b * k), bounded(out.a * F32x16(alpha.scale))};
}

// Runs one stage; `in.previous` is the colour that reaches it.
TERRAZZO_INLINE Color combine_stage(const TextureStage& stage, CombineInput& in) {
    if (stage.mode != EnvMode::kCombine) return combine(stage, in.previous, in.texels[stage.unit]);
    in.constant = uniform_color(stage.env_color);
    return combine_general(stage, in);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
