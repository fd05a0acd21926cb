// Coverage of smooth lines and points (GL 1.5 §3.3.2, §3.4.3), which multiplies alpha: four varyings that
// src/pipeline/geometry/assemble/smooth.cpp set up, all perspective. As the reference computes it
// (doc/reference.md §3.3).
//
// Lines: across the line and half its width, along it and half its length, from the middle. Points: x and y
// from the centre in radii, the squared distance where the rim begins, and 1.
#pragma once

#include "raster/pixel/interpolate.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

TERRAZZO_INLINE F32x16 saturate(F32x16 v) {
    return clamp(v, F32x16(0.0f), F32x16(1.0f));
}

// Multiplies alpha and takes the pixels outside a point from the mask.
TERRAZZO_INLINE uint32_t apply_coverage(Coverage kind, const FragmentState& state, const Interpolator& at,
                                        F32x16 w, F32x16& alpha, uint32_t mask) {
    const int first = state.varyings.coverage;
    const F32x16 a = at.varying(first) * w, b = at.varying(first + 1) * w;
    const F32x16 c = at.varying(first + 2) * w, d = at.varying(first + 3) * w;
    if (kind == Coverage::kLine) {
        alpha = alpha * (saturate(b - abs(a)) * saturate(d - abs(c)));
        return mask;
    }
    const F32x16 distance = a * a + b * b;
    // (1 - distance) / (1 - rim) inside the rim, where it exceeds 1, and 1 on the rim: not GL's round edge,
    // but the reference's.
    const F32x16 inner = F32x16(1.0f) / (d - c) * (d - distance);
    alpha = alpha * select(c >= distance, inner, d);
    return mask & ~bits_of(d < distance);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
