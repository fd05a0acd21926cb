// Texture coordinates of 16 vertices: generation, then the texture matrix (GL 1.5 §2.11.2, §2.11.4).
#pragma once

#include "pipeline/light.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;

TERRAZZO_INLINE Wide4 transform(const float m[16], const Wide4& v) {
    const auto row = [&](int r) {
        return F32x16(m[r]) * v.x + F32x16(m[4 + r]) * v.y + F32x16(m[8 + r]) * v.z + F32x16(m[12 + r]) * v.w;
    };
    return {row(0), row(1), row(2), row(3)};
}

TERRAZZO_INLINE F32x16 dot4(const float plane[4], const Wide4& v) {
    return v.x * F32x16(plane[0]) + v.y * F32x16(plane[1]) + v.z * F32x16(plane[2]) + v.w * F32x16(plane[3]);
}

// What texture coordinate generation may look at.
struct TexgenSource {
    Wide4 object, eye;
    Wide3 normal;
};

inline Wide4 texture_coordinates(const TextureCoordinates& unit, const Wide4& given,
                                 const TexgenSource& source) {
    Wide4 out = given;
    bool sphere = false, reflects = false;
    for (const TexgenMode mode : unit.texgen) {
        sphere = sphere || mode == TexgenMode::kSphereMap;
        reflects = reflects || mode == TexgenMode::kReflectionMap;
    }
    Wide3 reflection{0.0f, 0.0f, 0.0f};
    F32x16 sphere_scale(0.0f);
    if (sphere || reflects) {
        const Wide3 view = normalize({source.eye.x, source.eye.y, source.eye.z});
        const F32x16 twice = F32x16(2.0f) * dot(source.normal, view);
        reflection = {view.x - source.normal.x * twice, view.y - source.normal.y * twice,
                      view.z - source.normal.z * twice};
        const F32x16 z1 = reflection.z + F32x16(1.0f);
        sphere_scale =
            F32x16(0.5f) / sqrt(reflection.x * reflection.x + reflection.y * reflection.y + z1 * z1);
    }
    F32x16* const coordinates[4] = {&out.x, &out.y, &out.z, &out.w};
    const F32x16 reflected[4] = {reflection.x, reflection.y, reflection.z, F32x16(1.0f)};
    const F32x16 normal[4] = {source.normal.x, source.normal.y, source.normal.z, F32x16(1.0f)};
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
                *coordinates[c] = reflected[c] * sphere_scale + F32x16(0.5f);
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
