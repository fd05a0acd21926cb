// Fog (GL 1.5 §3.10) and the alpha test (§4.1.4).
#pragma once

#include "raster/pixel/color.h"
#include "raster/pixel/compare.h"
#include "raster/pixel/depth_stencil.h"
#include "simd/math.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// Mixes the fog colour in; `distance` is the fog coordinate.
TERRAZZO_INLINE void fog_inline(FogMode mode, const FragmentState& state, F32x16 distance, Color& color) {
    const F32x16 scaled = distance * F32x16(state.fog_scale);
    F32x16 f(1.0f);
    switch (mode) {
        case FogMode::kNone:
            return;
        case FogMode::kLinear:
            f = scaled + F32x16(state.fog_bias);
            break;
        case FogMode::kExp:
            f = exp2(-scaled);
            break;
        case FogMode::kExp2:
            f = exp2(-(scaled * scaled));
            break;
    }
    f = clamp(f, F32x16(0.0f), F32x16(1.0f));
    const F32x16 rest = F32x16(1.0f) - f;
    color.r = color.r * f + F32x16(state.fog_color[0]) * rest;
    color.g = color.g * f + F32x16(state.fog_color[1]) * rest;
    color.b = color.b * f + F32x16(state.fog_color[2]) * rest;
}

TERRAZZO_NOINLINE void apply_fog(FogMode mode, const FragmentState& state, F32x16 distance, Color& color) {
    fog_inline(mode, state, distance, color);
}

// Which fragments pass; compared in eight bits where the colour buffer has eight bits of alpha, else as
// floats.
TERRAZZO_NOINLINE Mask16 alpha_test(Compare func, const FragmentState& state, ColorFormat format,
                                    F32x16 alpha) {
    if (format != ColorFormat::kRgba8) {
        return compare(func, alpha, F32x16(state.alpha_reference));
    }
    return compare(func, to_unorm8(alpha), to_unorm8(F32x16(state.alpha_reference)));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
