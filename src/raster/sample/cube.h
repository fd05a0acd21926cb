// Cube maps (GL 1.5 §3.8.6): the face and the coordinates on it that a direction points at, and the filtered
// texel there. Faces are filtered each by itself, clamped to its edge, as the reference does.
#pragma once

#include "raster/sample/anisotropic.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// What a face's coordinates are made of: table 3.19 without its quotients. Derivatives go the same way.
struct FaceAxes {
    Mask16 is_x, is_z;  // the major axis; y otherwise
    I32x16 sign;        // sign bit of the major coordinate

    TERRAZZO_INLINE explicit FaceAxes(const TexturePoint& at) {
        const auto magnitude = [](F32x16 v) { return as_float(as_int(v) & I32x16(0x7fffffff)); };
        const F32x16 s = magnitude(at.s), t = magnitude(at.t), r = magnitude(at.r);
        is_x = s > t;
        is_z = r >= max(s, t);
        sign = as_int(major(at)) & I32x16(static_cast<int32_t>(0x80000000u));
    }

    TERRAZZO_INLINE F32x16 major(const TexturePoint& v) const {
        return select(is_z, v.r, select(is_x, v.s, v.t));
    }
    TERRAZZO_INLINE F32x16 face_s(const TexturePoint& v) const {
        const F32x16 x_side = as_float(as_int(-v.r) ^ sign), z_side = as_float(as_int(v.s) ^ sign);
        return select(is_z, z_side, select(is_x, x_side, v.s));
    }
    TERRAZZO_INLINE F32x16 face_t(const TexturePoint& v) const {
        const F32x16 down = -v.t, y_side = as_float(as_int(v.r) ^ sign);
        return select(is_z, down, select(is_x, down, y_side));
    }
    TERRAZZO_INLINE I32x16 face() const {
        return select(is_z, I32x16(4), select(is_x, I32x16(0), I32x16(2))) | shift_right_logical<31>(sign);
    }
};

// lambda from how the coordinates on the face change: 0.5 * (d(sc) - sc * d(ma) / ma) / ma. With mip levels
// each pixel has its own.
TERRAZZO_NOINLINE F32x16 cube_level_of_detail(const Sampler& sampler, const FaceAxes& axes,
                                              const TexturePoint& at, F32x16 reciprocal) {
    const F32x16 half = F32x16(0.5f) * reciprocal, size(static_cast<float>(sampler.levels[0].width));
    const F32x16 s = axes.face_s(at), t = axes.face_t(at);
    const auto squared_change = [&](const TexturePoint& step) {
        const F32x16 along = axes.major(step) * reciprocal;
        const F32x16 ds = (axes.face_s(step) - along * s) * half * size;
        const F32x16 dt = (axes.face_t(step) - along * t) * half * size;
        return ds * ds + dt * dt;
    };
    const F32x16 rho_x =
        squared_change({swap_columns(at.s) - at.s, swap_columns(at.t) - at.t, swap_columns(at.r) - at.r});
    const F32x16 rho_y =
        squared_change({swap_rows(at.s) - at.s, swap_rows(at.t) - at.t, swap_rows(at.r) - at.r});
    return lambda_of(sampler, select(rho_x > rho_y, rho_x, rho_y), sampler.mip_filter == MipFilter::kNone);
}

TERRAZZO_NOINLINE Color sample_cube(const Sampler& sampler, const TexturePoint& at, uint32_t mask) {
    const FaceAxes axes(at);
    const F32x16 zero(0.0f), half(0.5f), major = axes.major(at);
    const bool needs_lambda = !filters_agree(sampler);
    F32x16 lambda(0.0f), scale;
    if (needs_lambda) {
        const F32x16 reciprocal = F32x16(1.0f) / major;
        lambda = cube_level_of_detail(sampler, axes, at, reciprocal);
        scale = abs(half * reciprocal);
    } else {
        scale = select(major == zero, zero, half / abs(major));
    }
    const TexturePoint on_face{axes.face_s(at) * scale + half, axes.face_t(at) * scale + half, zero};
    const I32x16 faces = axes.face();
    alignas(64) int32_t face_of[16];
    store(faces, face_of);
    Color result{0.0f, 0.0f, 0.0f, 0.0f};
    for (uint32_t todo = mask; todo != 0;) {
        const int face = face_of[std::countr_zero(todo)];
        const Mask16 same = faces == I32x16(face);
        const Sampler& of_face = sampler.faces[face];
        const uint32_t pixels = bits_of(same) & todo;
        const Color texel = sampler.anisotropic ? sample_anisotropic(of_face, on_face, pixels)
                            : needs_lambda      ? sample_at_lambda(of_face, lambda, on_face, pixels)
                                                : sample_level(of_face, 0, sampler.mag_filter, on_face);
        todo &= ~bits_of(same);
        result = select(same, texel, result);
    }
    return result;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
