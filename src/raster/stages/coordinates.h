// The coordinates at which a unit samples its texture, and what perspective divides by.
#pragma once

#include "raster/stages/place.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// `kExact`: rounded as the reference rounds them (pixel/interpolate.h). The first unit leaves w for others.
template <bool kPerspective, bool kExact>
void coordinates_stage(const FragmentState& state, const TextureStage& stage, Bin& bin, Batch& batch) {
    const int first = state.varyings.texture[stage.unit];
    const bool has_r = state.varyings.uses_r >> stage.unit & 1,
               projects = state.varyings.projective >> stage.unit & 1, is_first = &stage == state.textures;
    for (int i = 0; i < batch.count; ++i) {
        const Interpolator at = planes_of(batch, bin, i);
        const auto plane = [&](int index) { return kExact ? at.exact_varying(index) : at.varying(index); };
        F32x16 w(1.0f);
        if constexpr (kPerspective) {
            if (is_first) {
                w = kExact ? at.exact_w() : at.w();
                store(w, batch.w[i]);
            } else {
                w = load(batch.w[i]);
            }
        }
        F32x16 s = plane(first), t = plane(first + 1), r(0.0f);
        if (has_r) r = plane(first + 2);
        if constexpr (kPerspective) s = s * w, t = t * w, r = r * w;
        if (projects) {
            F32x16 q = plane(first + 3);
            if constexpr (kPerspective) q = q * w;
            const F32x16 scale = F32x16(1.0f) / q;
            s = s * scale, t = t * scale, r = r * scale;
        }
        store(s, batch.s[i]);
        store(t, batch.t[i]);
        if (has_r) store(r, batch.r[i]);
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
