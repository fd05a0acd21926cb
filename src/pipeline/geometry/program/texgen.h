// Texture coordinates of 16 vertices: generation, then the texture matrix (GL 1.5 §2.11.2, §2.11.4).
#pragma once

#include "pipeline/geometry/program/light.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;

TERRAZZO_INLINE Wide4 transform(const float m[16], const Wide4& v) {
    const auto row = [&](int r) {
        return F32x16(m[r]) * v.x + F32x16(m[4 + r]) * v.y + F32x16(m[8 + r]) * v.z + F32x16(m[12 + r]) * v.w;
    };
    return {row(0), row(1), row(2), row(3)};
}

// Last component first, as the reference's shaders add them.
TERRAZZO_INLINE F32x16 dot4(const float plane[4], const Wide4& v) {
    return v.w * F32x16(plane[3]) + v.z * F32x16(plane[2]) + v.y * F32x16(plane[1]) + v.x * F32x16(plane[0]);
}

// What texture coordinate generation may look at.
struct TexgenSource {
    Wide4 object, eye;
    Wide3 normal;
};

// The reflection of the eye's ray, and the shares of it that a sphere map takes.
struct Reflection {
    Wide3 ray;
    F32x16 sphere_s, sphere_t;
};

inline Reflection reflect(const TexgenSource& source, bool for_sphere) {
    const Wide3& n = source.normal;
    const Wide3 e = normalize({source.eye.x, source.eye.y, source.eye.z});
    const F32x16 once = dot(n, e), twice = once + once;
    Reflection r{{e.x - n.x * twice, e.y - n.y * twice, e.z - n.z * twice}, 0.0f, 0.0f};
    if (!for_sphere) return r;
    const F32x16 one(1.0f), half(0.5f);
    const F32x16 z = e.z + (one - n.z * twice);
    const F32x16 share = one / sqrt(z * z + r.ray.y * r.ray.y + r.ray.x * r.ray.x) * half;
    r.sphere_s = r.ray.x * share + half;
    r.sphere_t = r.ray.y * share + half;
    return r;
}

inline Wide4 texture_coordinates(const TextureCoordinates& unit, const Wide4& given,
                                 const TexgenSource& source) {
    Wide4 out = given;
    bool sphere = false, reflects = false;
    for (const TexgenMode mode : unit.texgen) {
        sphere = sphere || mode == TexgenMode::kSphereMap;
        reflects = reflects || mode == TexgenMode::kReflectionMap;
    }
    Reflection r;
    if (sphere || reflects) r = reflect(source, sphere);
    F32x16* const coordinates[4] = {&out.x, &out.y, &out.z, &out.w};
    const F32x16 spherical[4] = {r.sphere_s, r.sphere_t, out.z, out.w};
    const F32x16 reflected[4] = {r.ray.x, r.ray.y, r.ray.z, out.w};
    const F32x16 normal[4] = {source.normal.x, source.normal.y, source.normal.z, out.w};
    for (int c = 0; c < 4; ++c) {
        switch (unit.texgen[c]) {
            case TexgenMode::kOff:
                break;
            case TexgenMode::kObjectLinear:
                *coordinates[c] = dot4(unit.planes[c], source.object);
                break;
            case TexgenMode::kEyeLinear:
                *coordinates[c] = dot4(unit.planes[c], source.eye);
                break;
            case TexgenMode::kSphereMap:
                *coordinates[c] = spherical[c];
                break;
            case TexgenMode::kReflectionMap:
                *coordinates[c] = reflected[c];
                break;
            case TexgenMode::kNormalMap:
                *coordinates[c] = normal[c];
                break;
        }
    }
    return unit.has_matrix ? transform(unit.matrix, out) : out;
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
