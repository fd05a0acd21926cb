// Lighting of 16 vertices (GL 1.5 §2.14), operation for operation as the reference does it (doc/reference.md
// §2.4): a colour has the reference's bits.
#pragma once

#include "pipeline/geometry/program/fetch.h"
#include "pipeline/geometry/vertex_state.h"
#include "simd/math.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;

struct Wide3 {
    F32x16 x, y, z;
};
TERRAZZO_INLINE Wide3 wide3(const float v[3]) {
    return {v[0], v[1], v[2]};
}
// Last component first, as the reference's shaders add them.
TERRAZZO_INLINE F32x16 dot(const Wide3& a, const Wide3& b) {
    return a.z * b.z + a.y * b.y + a.x * b.x;
}
TERRAZZO_INLINE Wide3 scale(const Wide3& v, F32x16 f) {
    return {v.x * f, v.y * f, v.z * f};
}
TERRAZZO_INLINE Wide3 normalize(const Wide3& v) {
    return scale(v, F32x16(1.0f) / sqrt(dot(v, v)));
}
TERRAZZO_INLINE Wide3 operator-(const Wide3& a, const Wide3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// The material of one face where it differs from vertex to vertex: what glMaterial set between Begin and End,
// and what follows the vertex colour. Elsewhere the constants of Lighting hold.
struct VaryingMaterial {
    bool has_ambient, has_diffuse, has_specular, has_emission;
    Wide4 ambient, diffuse, specular, emission;
    F32x16 shininess;
};

inline VaryingMaterial varying_material(const Lighting& lighting, int face, const VertexInput& input,
                                        const ElementBatch& batch, const Wide4& color) {
    const ColorMaterial& follows = lighting.color_material[face];
    const int first = face == 0 ? kFrontAmbient : kBackAmbient;
    VaryingMaterial m;
    const auto get = [&](int offset, bool from_color, bool& has, Wide4& value) {
        const bool streamed = input.streamed & bit(first + offset);
        has = from_color || streamed;
        if (has) value = from_color ? color : fetch(input, first + offset, batch);
    };
    get(0, follows.ambient, m.has_ambient, m.ambient);
    get(1, follows.diffuse, m.has_diffuse, m.diffuse);
    get(2, follows.specular, m.has_specular, m.specular);
    get(3, follows.emission, m.has_emission, m.emission);
    m.shininess = input.streamed & bit(first + 4) ? fetch(input, first + 4, batch).x
                                                  : F32x16(lighting.materials[face].shininess);
    return m;
}

struct LitColor {
    Wide4 color;     // alpha is the material's diffuse alpha
    Wide3 specular;  // apart from `color` only where secondary colours are separate
};

// What a light is to the vertices, whichever way they face.
struct LightGeometry {
    Wide3 to_light, half_vector;
    F32x16 attenuation;
    bool attenuates;
};

inline LightGeometry light_geometry(const Lighting& lighting, const Light& light, const Wide3& eye) {
    const F32x16 zero(0.0f), one(1.0f);
    LightGeometry g;
    g.to_light = wide3(light.position);
    g.attenuates = light.spot || light.attenuated;
    F32x16 distance2(0.0f), distance(0.0f), inverse(0.0f);
    if (light.positional) {
        g.to_light = g.to_light - eye;
        distance2 = dot(g.to_light, g.to_light);
        distance = sqrt(distance2);
        inverse = one / distance;
        g.to_light = scale(g.to_light, inverse);
    }
    if (light.spot) {
        const F32x16 cosine = -dot(g.to_light, wide3(light.direction));
        const F32x16 intensity = pow_fused(abs(cosine), F32x16(light.spot_exponent));
        g.attenuation = select(F32x16(light.spot_cos_cutoff) < cosine, one, zero) * intensity;
    }
    if (light.attenuated) {
        const float* const k = light.attenuation;
        const F32x16 falloff =
            one / (distance * F32x16(k[1]) + distance2 * F32x16(k[2]) + distance * inverse * F32x16(k[0]));
        g.attenuation = light.spot ? falloff * g.attenuation : falloff;
    }
    if (lighting.no_shininess) return g;
    if (lighting.local_viewer) {
        g.half_vector = normalize(g.to_light - normalize(eye));
    } else if (light.positional) {
        g.half_vector = normalize({g.to_light.x, g.to_light.y, g.to_light.z + one});
    } else {
        g.half_vector = wide3(light.half_vector);
    }
    return g;
}

TERRAZZO_INLINE Wide3 product(bool varies, const Wide4& material, const float light[3],
                              const float constant[3]) {
    if (!varies) return wide3(constant);
    return {material.x * F32x16(light[0]), material.y * F32x16(light[1]), material.z * F32x16(light[2])};
}
TERRAZZO_INLINE Wide3 multiply_add(const Wide3& a, F32x16 f, const Wide3& b) {
    return {f * a.x + b.x, f * a.y + b.y, f * a.z + b.z};
}
TERRAZZO_INLINE bool is_black(const float c[3]) {
    return c[0] == 0 && c[1] == 0 && c[2] == 0;
}

// Adds one light to the colours of one face, whose normal is `normal`.
inline void add_light(const Lighting& lighting, const Light& light, const LightGeometry& g, int face,
                      const VaryingMaterial& material, const Wide3& normal, Wide3& color, Wide3& specular) {
    const F32x16 zero(0.0f), one(1.0f);
    const LitMaterial& lit = light.lit[face];
    const Wide3 ambient = product(material.has_ambient, material.ambient, light.ambient, lit.ambient);
    color = g.attenuates ? multiply_add(ambient, g.attenuation, color) : multiply_add(ambient, one, color);

    const F32x16 facing = dot(normal, g.to_light);
    const Mask16 faces = facing > zero;
    if (!any(faces)) return;
    F32x16 diffuse_share = max(facing, zero);
    if (g.attenuates) diffuse_share = diffuse_share * g.attenuation;
    color = multiply_add(product(material.has_diffuse, material.diffuse, light.diffuse, lit.diffuse),
                         diffuse_share, color);

    F32x16 shine = one;
    if (lighting.no_shininess) {
        // The reference's program takes the cosine for the exponent too where a light is attenuated.
        if (g.attenuates) shine = pow_fused(max(facing, zero), min(facing, F32x16(128.0f)));
    } else {
        const F32x16 highlight = max(dot(normal, g.half_vector), zero);
        // Up to this the power is finite, and times black it is nothing.
        const bool finite = !any(highlight > F32x16(1.9f));
        if (!material.has_specular && is_black(lit.specular) && finite) return;
        shine = pow_fused(highlight, max(min(material.shininess, F32x16(128.0f)), F32x16(-128.0f)));
    }
    shine = select(faces, shine, zero);
    if (g.attenuates) shine = g.attenuation * shine;
    Wide3& sum = lighting.separate_specular ? specular : color;
    sum = multiply_add(product(material.has_specular, material.specular, light.specular, lit.specular), shine,
                       sum);
}

// Light that needs no light source: model ambient and emission.
TERRAZZO_INLINE Wide3 scene_color(const Lighting& lighting, int face, const VaryingMaterial& material) {
    const Material& m = lighting.materials[face];
    if (!material.has_ambient && !material.has_emission) return wide3(m.scene_color);
    const Wide3 ambient = material.has_ambient
                              ? Wide3{material.ambient.x, material.ambient.y, material.ambient.z}
                              : wide3(m.ambient);
    const Wide3 emission = material.has_emission
                               ? Wide3{material.emission.x, material.emission.y, material.emission.z}
                               : wide3(m.emission);
    const float* const model = lighting.model_ambient;
    return {F32x16(model[0]) * ambient.x + emission.x, F32x16(model[1]) * ambient.y + emission.y,
            F32x16(model[2]) * ambient.z + emission.z};
}

// out[0] is the front's, out[1] the back's where lighting is two-sided.
inline void light_vertices(const Lighting& lighting, const VertexInput& input, const ElementBatch& batch,
                           const Wide4& color, const Wide3& eye, const Wide3& normal, LitColor out[2]) {
    const int faces = lighting.two_sided ? 2 : 1;
    const Wide3 normals[2] = {normal, {-normal.x, -normal.y, -normal.z}};
    VaryingMaterial materials[2];
    Wide3 sums[2];
    for (int face = 0; face < faces; ++face) {
        materials[face] = varying_material(lighting, face, input, batch, color);
        sums[face] = scene_color(lighting, face, materials[face]);
        out[face].specular = {0.0f, 0.0f, 0.0f};
    }
    for (int i = 0; i < lighting.light_count; ++i) {
        const Light& light = lighting.lights[static_cast<size_t>(i)];
        const LightGeometry g = light_geometry(lighting, light, eye);
        for (int face = 0; face < faces; ++face)
            add_light(lighting, light, g, face, materials[face], normals[face], sums[face],
                      out[face].specular);
    }
    for (int face = 0; face < faces; ++face) {
        const F32x16 alpha = materials[face].has_diffuse ? materials[face].diffuse.w
                                                         : F32x16(lighting.materials[face].diffuse[3]);
        out[face].color = {sums[face].x, sums[face].y, sums[face].z, alpha};
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
