// Lighting of 16 vertices (GL 1.5 §2.14).
#pragma once

#include "pipeline/fetch.h"
#include "pipeline/vertex_state.h"
#include "simd/math.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;

struct Wide3 {
    F32x16 x, y, z;
};
TERRAZZO_INLINE F32x16 dot(const Wide3& a, const Wide3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
TERRAZZO_INLINE Wide3 scale(const Wide3& v, F32x16 f) {
    return {v.x * f, v.y * f, v.z * f};
}
TERRAZZO_INLINE Wide3 normalize(const Wide3& v) {
    return scale(v, F32x16(1.0f) / sqrt(dot(v, v)));
}

struct WideMaterial {
    Wide4 ambient, diffuse, specular, emission;
    F32x16 shininess;
};

TERRAZZO_INLINE Wide4 wide(const float v[4]) {
    return {v[0], v[1], v[2], v[3]};
}

// The material of one face: its constants, what glMaterial set per vertex, and what follows the vertex
// colour.
inline WideMaterial material_of(const Lighting& lighting, int face, const VertexInput& input,
                                const ElementBatch& batch, const Wide4& color) {
    const Material& m = lighting.materials[face];
    const ColorMaterial& follows = lighting.color_material[face];
    const int first = face == 0 ? kFrontAmbient : kBackAmbient;
    const auto value = [&](int offset, const float constant[4], bool from_color) {
        if (from_color) return color;
        if (input.streamed & bit(first + offset)) return fetch(input, first + offset, batch);
        return wide(constant);
    };
    WideMaterial out;
    out.ambient = value(0, m.ambient, follows.ambient);
    out.diffuse = value(1, m.diffuse, follows.diffuse);
    out.specular = value(2, m.specular, follows.specular);
    out.emission = value(3, m.emission, follows.emission);
    out.shininess = input.streamed & bit(first + 4) ? fetch(input, first + 4, batch).x : F32x16(m.shininess);
    return out;
}

struct LitColor {
    Wide4 color;     // alpha is the material's diffuse alpha
    Wide3 specular;  // apart from `color` only where secondary colours are separate
};

TERRAZZO_INLINE void add_scaled(Wide3& sum, const Wide4& a, const float b[4], F32x16 f) {
    sum.x = sum.x + a.x * F32x16(b[0]) * f;
    sum.y = sum.y + a.y * F32x16(b[1]) * f;
    sum.z = sum.z + a.z * F32x16(b[2]) * f;
}

inline void add_light(const Lighting& lighting, const Light& light, const Wide3& eye, const Wide3& normal,
                      const WideMaterial& material, Wide3& sum, Wide3& specular) {
    const F32x16 zero(0.0f), one(1.0f);
    Wide3 to_light{light.position[0], light.position[1], light.position[2]};
    F32x16 attenuation(1.0f);
    if (light.position[3] != 0) {
        const Wide3 offset{to_light.x - eye.x, to_light.y - eye.y, to_light.z - eye.z};
        const F32x16 distance2 = dot(offset, offset);
        const F32x16 inverse = one / sqrt(distance2);
        to_light = scale(offset, inverse);
        const float* const k = light.attenuation;
        if (k[0] != 1 || k[1] != 0 || k[2] != 0)
            attenuation =
                one / (F32x16(k[0]) + F32x16(k[1]) * (distance2 * inverse) + F32x16(k[2]) * distance2);
        if (light.spot_cos_cutoff != -1) {
            const F32x16 cosine =
                -dot(to_light, {light.direction[0], light.direction[1], light.direction[2]});
            const F32x16 intensity = pow(max(cosine, zero), F32x16(light.spot_exponent));
            attenuation = select(cosine < F32x16(light.spot_cos_cutoff), zero, attenuation * intensity);
        }
    }
    add_scaled(sum, material.ambient, light.ambient, attenuation);
    const F32x16 cosine = dot(normal, to_light);
    const Mask16 lit = cosine > zero;
    if (!any(lit)) return;
    add_scaled(sum, material.diffuse, light.diffuse, select(lit, cosine * attenuation, zero));

    Wide3 half = to_light;
    if (lighting.local_viewer) {
        const Wide3 view = normalize(eye);
        half = {half.x - view.x, half.y - view.y, half.z - view.z};
    } else {
        half.z = half.z + one;
    }
    const F32x16 highlight = max(dot(normal, normalize(half)), zero);
    const F32x16 shine = select(lit, pow(highlight, material.shininess) * attenuation, zero);
    add_scaled(specular, material.specular, light.specular, shine);
}

inline LitColor light_vertices(const Lighting& lighting, int face, const VertexInput& input,
                               const ElementBatch& batch, const Wide4& color, const Wide3& eye,
                               const Wide3& front_normal) {
    const WideMaterial material = material_of(lighting, face, input, batch, color);
    const Wide3 normal = face == 0 ? front_normal : Wide3{-front_normal.x, -front_normal.y, -front_normal.z};
    Wide3 sum{material.emission.x, material.emission.y, material.emission.z}, specular{0.0f, 0.0f, 0.0f};
    add_scaled(sum, material.ambient, lighting.model_ambient, F32x16(1.0f));
    for (int i = 0; i < lighting.light_count; ++i)
        add_light(lighting, lighting.lights[static_cast<size_t>(i)], eye, normal, material, sum, specular);
    if (!lighting.separate_specular) sum = {sum.x + specular.x, sum.y + specular.y, sum.z + specular.z};
    return {{sum.x, sum.y, sum.z, material.diffuse.w}, specular};
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
