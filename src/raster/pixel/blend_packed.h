// Blending of packed pixels (GL 1.5 §4.1.7), every factor and equation, without unpacking them.
#pragma once

#include "raster/fragment_state.h"
#include "raster/pixel/color.h"
#include "raster/pixel/packed.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

inline constexpr int32_t kAlphaByte = static_cast<int32_t>(0xff000000u);

struct PackedBlend {
    I32x16 source, destination, constant;
};

TERRAZZO_INLINE I32x16 blend_factor(BlendFactor factor, const PackedBlend& in) {
    switch (factor) {
        case BlendFactor::kZero:
            break;
        case BlendFactor::kOne:
            return I32x16(-1);
        case BlendFactor::kSourceColor:
            return in.source;
        case BlendFactor::kOneMinusSourceColor:
            return invert_bytes(in.source);
        case BlendFactor::kDestinationColor:
            return in.destination;
        case BlendFactor::kOneMinusDestinationColor:
            return invert_bytes(in.destination);
        case BlendFactor::kSourceAlpha:
            return spread_alpha(in.source);
        case BlendFactor::kOneMinusSourceAlpha:
            return invert_bytes(spread_alpha(in.source));
        case BlendFactor::kDestinationAlpha:
            return spread_alpha(in.destination);
        case BlendFactor::kOneMinusDestinationAlpha:
            return invert_bytes(spread_alpha(in.destination));
        case BlendFactor::kConstantColor:
            return in.constant;
        case BlendFactor::kOneMinusConstantColor:
            return invert_bytes(in.constant);
        case BlendFactor::kConstantAlpha:
            return spread_alpha(in.constant);
        case BlendFactor::kOneMinusConstantAlpha:
            return invert_bytes(spread_alpha(in.constant));
        case BlendFactor::kSourceAlphaSaturate:
            return min_bytes(spread_alpha(in.source), invert_bytes(spread_alpha(in.destination))) |
                   I32x16(kAlphaByte);
    }
    return I32x16(0);
}

// Colours by one rule, alpha by another.
TERRAZZO_INLINE I32x16 apart(bool same, I32x16 colors, I32x16 alpha) {
    return same ? colors : (colors & I32x16(~kAlphaByte)) | (alpha & I32x16(kAlphaByte));
}

TERRAZZO_INLINE I32x16 blend_equation(BlendEquation equation, const PackedBlend& in, I32x16 source,
                                      I32x16 destination) {
    switch (equation) {
        case BlendEquation::kAdd:
            break;
        case BlendEquation::kSubtract:
            return subtract_bytes(source, destination);
        case BlendEquation::kReverseSubtract:
            return subtract_bytes(destination, source);
        case BlendEquation::kMin:
            return min_bytes(in.source, in.destination);
        case BlendEquation::kMax:
            return max_bytes(in.source, in.destination);
    }
    return add_bytes(source, destination);
}

// A product with 255 is the other factor, and one with 0 is 0: no factor needs to be told apart.
TERRAZZO_INLINE I32x16 blend_packed(const FragmentState& state, const PackedBlend& in) {
    const auto weighed = [&](BlendFactor colors, BlendFactor alpha, I32x16 v) TERRAZZO_INLINE_LAMBDA {
        const bool same = colors == alpha;
        const I32x16 factor = blend_factor(colors, in);
        return multiply_bytes(v, same ? factor : apart(false, factor, blend_factor(alpha, in)));
    };
    const I32x16 source = weighed(state.blend_source_rgb, state.blend_source_alpha, in.source);
    const I32x16 destination =
        weighed(state.blend_destination_rgb, state.blend_destination_alpha, in.destination);
    const BlendEquation colors = state.blend_equation_rgb, alpha = state.blend_equation_alpha;
    const I32x16 out = blend_equation(colors, in, source, destination);
    return colors == alpha ? out : apart(false, out, blend_equation(alpha, in, source, destination));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
