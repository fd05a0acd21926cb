// Lights, materials and the scaling of normals for the vertex program: everything that is the same for all
// vertices of a draw is worked out here, in the reference's order of operations (doc/reference.md §2.3).
#include <algorithm>
#include <cmath>

#include "gl/context.h"
#include "gl/validate.h"
#include "simd/trigonometry.h"

namespace terrazzo::gl {
namespace {

using pipeline::bit;

void normalize(float v[3]) {
    const float length2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (length2 == 0) return;
    const float scale = 1.0f / std::sqrt(length2);
    for (int i = 0; i < 3; ++i) v[i] *= scale;
}

bool is_attenuated(const Light& light) {
    return light.constant_attenuation != 1 || light.linear_attenuation != 0 ||
           light.quadratic_attenuation != 0;
}

// Whether lighting happens in eye coordinates. The reference moves the lights to object coordinates where
// nothing asks for more, which saves it the normals' transformation and changes the last bits of colours.
bool needs_eye_space(const Context& ctx, const pipeline::VertexState& vertex) {
    for (const pipeline::TextureCoordinates& unit : vertex.texture) {
        const auto looks = [](pipeline::TexgenMode mode) { return mode >= pipeline::TexgenMode::kEyeLinear; };
        if (unit.used && std::any_of(std::begin(unit.texgen), std::end(unit.texgen), looks)) return true;
    }
    const LightingState& state = ctx.lighting;
    if (ctx.rasterization.point.attenuated()) return true;
    if (!state.enabled) return false;
    if (state.model.local_viewer || state.model.color_control == GL_SEPARATE_SPECULAR_COLOR) return true;
    for (const Light& light : state.lights)
        if (light.enabled && (light.eye_position[3] != 0 || light.spot_cutoff != 180)) return true;
    return !preserves_length(ctx.matrix.modelview.top());
}

void scale_normals(const Context& ctx, pipeline::VertexState& out) {
    const StackMatrix& modelview = ctx.matrix.modelview.top();
    const Matrix4& inverse = modelview.inverse;
    const TransformState& transform = ctx.matrix.transform;
    out.normal_scaling = transform.normalize                         ? pipeline::NormalScaling::kNormalize
                         : out.eye_space == transform.rescale_normal ? pipeline::NormalScaling::kRescale
                                                                     : pipeline::NormalScaling::kNone;
    out.rescale_factor = 1;
    if (preserves_length(modelview)) return;
    const float length2 = inverse.at(2, 0) * inverse.at(2, 0) + inverse.at(2, 1) * inverse.at(2, 1) +
                          inverse.at(2, 2) * inverse.at(2, 2);
    out.rescale_factor = length2 < 1e-12f ? 1.0f : 1.0f / std::sqrt(length2);
}

void place_light(const Light& light, const StackMatrix& modelview, bool eye_space, pipeline::Light& out) {
    float position[4];
    for (int row = 0; row < 4; ++row) {
        const float* const m = modelview.inverse.m + row;
        const auto& p = light.eye_position;
        position[row] = eye_space ? p[static_cast<std::size_t>(row)]
                                  : m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12] * p[3];
    }
    std::copy_n(position, 3, out.position);
    out.positional = light.eye_position[3] != 0;
    if (out.positional) {
        const float inverse = 1.0f / position[3];
        for (float& p : out.position) p *= inverse;
        return;
    }
    normalize(out.position);
    const float* const m = modelview.value.m;
    const float towards_viewer[3] = {eye_space ? 0 : m[2], eye_space ? 0 : m[6], eye_space ? 1 : m[10]};
    for (int i = 0; i < 3; ++i) out.half_vector[i] = out.position[i] + towards_viewer[i];
    normalize(out.half_vector);
}

pipeline::Light make_light(const Light& light, const StackMatrix& modelview, bool eye_space) {
    pipeline::Light out;
    place_light(light, modelview, eye_space, out);
    out.spot = light.spot_cutoff != 180;
    std::copy_n(light.eye_spot_direction.data(), 3, out.direction);
    normalize(out.direction);
    normalize(out.direction);  // the reference does it twice
    out.spot_exponent = light.spot_exponent;
    const float radians = static_cast<float>(static_cast<double>(light.spot_cutoff) * M_PI / 180.0);
    out.spot_cos_cutoff = std::max(0.0f, simd::cosine(radians));
    out.attenuated = out.positional && is_attenuated(light);
    out.attenuation[0] = light.constant_attenuation;
    out.attenuation[1] = light.linear_attenuation;
    out.attenuation[2] = light.quadratic_attenuation;
    std::copy_n(light.ambient.data(), 3, out.ambient);
    std::copy_n(light.diffuse.data(), 3, out.diffuse);
    std::copy_n(light.specular.data(), 3, out.specular);
    return out;
}

void multiply(const float a[3], const Color4& b, float out[3]) {
    for (std::size_t i = 0; i < 3; ++i) out[i] = a[i] * b[i];
}

pipeline::Material make_material(const Material& material, const LightModel& model) {
    pipeline::Material out;
    std::copy_n(material.ambient.data(), 3, out.ambient);
    std::copy_n(material.diffuse.data(), 4, out.diffuse);
    std::copy_n(material.specular.data(), 3, out.specular);
    std::copy_n(material.emission.data(), 3, out.emission);
    for (std::size_t i = 0; i < 3; ++i)
        out.scene_color[i] = model.ambient[i] * material.ambient[i] + material.emission[i];
    out.shininess = material.shininess;
    return out;
}

pipeline::ColorMaterial make_color_material(const ColorMaterial& tracking, GLenum other_face) {
    if (!tracking.enabled || tracking.face == other_face) return {};
    const bool both = tracking.mode == GL_AMBIENT_AND_DIFFUSE;
    return {both || tracking.mode == GL_AMBIENT, both || tracking.mode == GL_DIFFUSE,
            tracking.mode == GL_SPECULAR, tracking.mode == GL_EMISSION};
}

}  // namespace

void make_lighting(const Context& ctx, const pipeline::VertexInput& input, pipeline::VertexState& vertex) {
    vertex.eye_space = needs_eye_space(ctx, vertex);
    scale_normals(ctx, vertex);
    const LightingState& state = ctx.lighting;
    pipeline::Lighting& out = vertex.lighting;
    out.enabled = state.enabled;
    vertex.fog_eye_z_alone = true;
    if (!state.enabled) return;
    out.two_sided = state.model.two_side;
    out.local_viewer = state.model.local_viewer;
    out.separate_specular = state.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
    std::copy_n(state.model.ambient.data(), 3, out.model_ambient);
    const Material* const materials[2] = {&state.front, &state.back};
    out.no_shininess = true;
    for (int face = 0; face < 2; ++face) {
        out.materials[face] = make_material(*materials[face], state.model);
        out.color_material[face] =
            make_color_material(state.color_material, static_cast<GLenum>(face == 0 ? GL_BACK : GL_FRONT));
        if (face == 1 && !out.two_sided) continue;
        const int stream = face == 0 ? pipeline::kFrontShininess : pipeline::kBackShininess;
        out.no_shininess =
            out.no_shininess && materials[face]->shininess == 0 && !(input.streamed & bit(stream));
    }
    out.light_count = 0;
    for (const Light& light : state.lights) {
        if (!light.enabled) continue;
        pipeline::Light& to = out.lights[static_cast<std::size_t>(out.light_count++)];
        to = make_light(light, ctx.matrix.modelview.top(), vertex.eye_space);
        for (int face = 0; face < 2; ++face) {
            multiply(to.ambient, materials[face]->ambient, to.lit[face].ambient);
            multiply(to.diffuse, materials[face]->diffuse, to.lit[face].diffuse);
            multiply(to.specular, materials[face]->specular, to.lit[face].specular);
        }
        if (to.positional || (out.local_viewer && !out.no_shininess)) vertex.fog_eye_z_alone = false;
    }
}

}  // namespace terrazzo::gl
