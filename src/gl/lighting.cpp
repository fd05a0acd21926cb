// Commands of lighting (GL 1.5 §2.14): Light, LightModel, Material, ColorMaterial, ShadeModel and their
// queries.
//
// Positions and spot directions are transformed to eye coordinates here, with the arithmetic of OSMesa:
// single precision, terms added in the order x, y, z, w.
#include "gl/lighting.h"

#include <algorithm>

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

std::array<GLfloat, 4> transform_point(const Matrix4& matrix, const GLfloat* p) {
    const float* m = matrix.m;
    std::array<GLfloat, 4> result;
    for (int row = 0; row < 4; ++row) {
        result[row] = m[row] * p[0] + m[row + 4] * p[1] + m[row + 8] * p[2] + m[row + 12] * p[3];
    }
    return result;
}

std::array<GLfloat, 3> transform_direction(const Matrix4& matrix, const GLfloat* d) {
    const float* m = matrix.m;
    std::array<GLfloat, 3> result;
    for (int row = 0; row < 3; ++row) result[row] = d[0] * m[row] + d[1] * m[row + 4] + d[2] * m[row + 8];
    return result;
}

Color4 color_at(const GLfloat* p) {
    return {p[0], p[1], p[2], p[3]};
}

Light* find_light(Context& ctx, GLenum light) {
    if (light - GL_LIGHT0 < static_cast<GLenum>(kMaxLights)) return &ctx.lighting.lights[light - GL_LIGHT0];
    record_error(ctx, GL_INVALID_ENUM, "no such light");
    return nullptr;
}

// The scalar of a light that `pname` names, null when it is none.
GLfloat* light_scalar(Light& light, GLenum pname) {
    switch (pname) {
        case GL_SPOT_EXPONENT:
            return &light.spot_exponent;
        case GL_SPOT_CUTOFF:
            return &light.spot_cutoff;
        case GL_CONSTANT_ATTENUATION:
            return &light.constant_attenuation;
        case GL_LINEAR_ATTENUATION:
            return &light.linear_attenuation;
        case GL_QUADRATIC_ATTENUATION:
            return &light.quadratic_attenuation;
    }
    return nullptr;
}

bool light_scalar_in_range(GLenum pname, GLfloat value) {
    switch (pname) {
        case GL_SPOT_EXPONENT:
            return value >= 0 && value <= kMaxSpotExponent;
        case GL_SPOT_CUTOFF:
            return (value >= 0 && value <= 90) || value == 180;
    }
    return value >= 0;
}

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

// What glColorMaterial(face, `mode`) names, as parameters of glMaterial.
bool names(GLenum mode, GLenum pname) {
    return mode == pname || (mode == GL_AMBIENT_AND_DIFFUSE && (pname == GL_AMBIENT || pname == GL_DIFFUSE));
}

// A parameter that follows the current colour cannot be set by glMaterial (GL 1.5 §2.14.3).
bool is_tracked(const ColorMaterial& tracking, GLenum face, GLenum pname) {
    return tracking.enabled && (tracking.face == face || tracking.face == GL_FRONT_AND_BACK) &&
           names(tracking.mode, pname);
}

Color4* material_color(Material& material, GLenum pname) {
    switch (pname) {
        case GL_AMBIENT:
            return &material.ambient;
        case GL_DIFFUSE:
            return &material.diffuse;
        case GL_SPECULAR:
            return &material.specular;
        case GL_EMISSION:
            return &material.emission;
    }
    return nullptr;
}

bool is_material_parameter(GLenum pname) {
    Material any;
    return material_color(any, pname) || pname == GL_AMBIENT_AND_DIFFUSE || pname == GL_SHININESS ||
           pname == GL_COLOR_INDEXES;
}

// The vertex attribute that stands for a material parameter while it varies between Begin and End.
int material_attribute(GLenum face, GLenum pname) {
    const int first = face == GL_FRONT ? pipeline::kFrontAmbient : pipeline::kBackAmbient;
    switch (pname) {
        case GL_AMBIENT:
            return first;
        case GL_DIFFUSE:
            return first + 1;
        case GL_SPECULAR:
            return first + 2;
        case GL_EMISSION:
            return first + 3;
        default:
            return first + 4;  // shininess
    }
}

// Between Begin and End the vertices given so far keep the old value: it becomes an attribute of each vertex.
void vary_material(Context& ctx, int attribute, const Color4& before, const Color4& after) {
    if (!ctx.vertex.open || ctx.vertex.batch.count == 0) return;
    Color4& current = ctx.vertex.current.values[static_cast<std::size_t>(attribute)];
    if (!(ctx.vertex.batch.mask & pipeline::bit(attribute))) {
        current = before;
        stream_attribute(ctx, attribute);
    }
    current = after;
}

void set_material(Context& ctx, GLenum face, GLenum pname, const GLfloat* params) {
    Material& material = face == GL_FRONT ? ctx.lighting.front : ctx.lighting.back;
    if (pname == GL_AMBIENT_AND_DIFFUSE) {
        set_material(ctx, face, GL_AMBIENT, params);
        set_material(ctx, face, GL_DIFFUSE, params);
    } else if (pname == GL_SHININESS) {
        vary_material(ctx, material_attribute(face, pname), {material.shininess, 0, 0, 1},
                      {*params, 0, 0, 1});
        change(ctx, Dirty::kLighting, material.shininess, *params);
    } else if (pname == GL_COLOR_INDEXES) {
        change(ctx, Dirty::kLighting, material.color_indexes, std::array{params[0], params[1], params[2]});
    } else if (!is_tracked(ctx.lighting.color_material, face, pname)) {
        Color4& color = *material_color(material, pname);
        vary_material(ctx, material_attribute(face, pname), color, color_at(params));
        change(ctx, Dirty::kLighting, color, color_at(params));
    }
}

// Materials that a batch streams are again those of the state.
void restore_streamed_materials(Context& ctx) {
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        Material& material = face == GL_FRONT ? ctx.lighting.front : ctx.lighting.back;
        for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
            const int attribute = material_attribute(face, pname);
            if (!(ctx.vertex.batch.mask & pipeline::bit(attribute))) continue;
            const Color4* const color = material_color(material, pname);
            ctx.vertex.current.values[static_cast<std::size_t>(attribute)] =
                color ? *color : Color4{material.shininess, 0, 0, 1};
        }
    }
}

void latch(ColorMaterial tracking, GLenum face, Material& material, const Color4& color) {
    for (GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
        if (is_tracked(tracking, face, pname)) *material_color(material, pname) = color;
    }
}

}  // namespace

void lightfv(Context& ctx, GLenum light, GLenum pname, const GLfloat* params) {
    Light* target = find_light(ctx, light);
    if (!target) return;
    switch (pname) {
        case GL_AMBIENT:
            return change(ctx, Dirty::kLighting, target->ambient, color_at(params));
        case GL_DIFFUSE:
            return change(ctx, Dirty::kLighting, target->diffuse, color_at(params));
        case GL_SPECULAR:
            return change(ctx, Dirty::kLighting, target->specular, color_at(params));
        case GL_POSITION:
            return change(ctx, Dirty::kLighting, target->eye_position,
                          transform_point(ctx.matrix.modelview.top().value, params));
        case GL_SPOT_DIRECTION:
            // The reference works out the inverse here, without need; a singular matrix is another kind from
            // then on.
            settle(ctx.matrix.modelview.top());
            return change(ctx, Dirty::kLighting, target->eye_spot_direction,
                          transform_direction(ctx.matrix.modelview.top().value, params));
    }
    GLfloat* scalar = light_scalar(*target, pname);
    if (!scalar) return record_error(ctx, GL_INVALID_ENUM, "no such light parameter");
    if (!light_scalar_in_range(pname, *params)) {
        return record_error(ctx, GL_INVALID_VALUE, "the light parameter's value is out of range");
    }
    change(ctx, Dirty::kLighting, *scalar, *params);
}

void light_modelfv(Context& ctx, GLenum pname, const GLfloat* params) {
    LightModel& model = ctx.lighting.model;
    switch (pname) {
        case GL_LIGHT_MODEL_AMBIENT:
            return change(ctx, Dirty::kLighting, model.ambient, color_at(params));
        case GL_LIGHT_MODEL_LOCAL_VIEWER:
            return change(ctx, Dirty::kLighting, model.local_viewer, *params != 0);
        case GL_LIGHT_MODEL_TWO_SIDE:
            return change(ctx, Dirty::kLighting, model.two_side, *params != 0);
        case GL_LIGHT_MODEL_COLOR_CONTROL:
            if (*params != GL_SINGLE_COLOR && *params != GL_SEPARATE_SPECULAR_COLOR) {
                return record_error(ctx, GL_INVALID_ENUM, "no such colour control");
            }
            return change(ctx, Dirty::kLighting, model.color_control, *params);
    }
    record_error(ctx, GL_INVALID_ENUM, "no such light model parameter");
}

void materialfv(Context& ctx, GLenum face, GLenum pname, const GLfloat* params) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    if (!is_material_parameter(pname))
        return record_error(ctx, GL_INVALID_ENUM, "no such material parameter");
    if (pname == GL_SHININESS && !(*params >= 0 && *params <= kMaxShininess)) {
        return record_error(ctx, GL_INVALID_VALUE, "shininess is not in 0..128");
    }
    const Material front = ctx.lighting.front, back = ctx.lighting.back;
    try {
        if (face != GL_BACK) set_material(ctx, GL_FRONT, pname, params);
        if (face != GL_FRONT) set_material(ctx, GL_BACK, pname, params);
    } catch (...) {
        lose_open_primitives(ctx);
        ctx.lighting.front = front;
        ctx.lighting.back = back;
        restore_streamed_materials(ctx);
        throw;
    }
}

void color_material(Context& ctx, GLenum face, GLenum mode) {
    if (!is_face(face)) return record_error(ctx, GL_INVALID_ENUM, "no such face");
    Material any;
    if (!material_color(any, mode) && mode != GL_AMBIENT_AND_DIFFUSE) {
        return record_error(ctx, GL_INVALID_ENUM, "no such material colour");
    }
    ColorMaterial& tracking = ctx.lighting.color_material;
    if (tracking.face == face && tracking.mode == mode) return;
    begin_change(ctx, Dirty::kLighting);
    latch_color_material(ctx);
    tracking.face = face;
    tracking.mode = mode;
}

void shade_model(Context& ctx, GLenum mode) {
    if (mode != GL_FLAT && mode != GL_SMOOTH) {
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_FLAT or GL_SMOOTH");
    }
    change(ctx, Dirty::kLighting, ctx.lighting.shade_model, mode);
}

void get_lightfv(Context& ctx, GLenum light, GLenum pname, GLfloat* params) {
    Light* source = find_light(ctx, light);
    if (!source) return;
    switch (pname) {
        case GL_AMBIENT:
            std::ranges::copy(source->ambient, params);
            return;
        case GL_DIFFUSE:
            std::ranges::copy(source->diffuse, params);
            return;
        case GL_SPECULAR:
            std::ranges::copy(source->specular, params);
            return;
        case GL_POSITION:
            std::ranges::copy(source->eye_position, params);
            return;
        case GL_SPOT_DIRECTION:
            std::ranges::copy(source->eye_spot_direction, params);
            return;
    }
    const GLfloat* scalar = light_scalar(*source, pname);
    if (!scalar) return record_error(ctx, GL_INVALID_ENUM, "no such light parameter");
    *params = *scalar;
}

void get_materialfv(Context& ctx, GLenum face, GLenum pname, GLfloat* params) {
    if (face != GL_FRONT && face != GL_BACK) {
        return record_error(ctx, GL_INVALID_ENUM, "face is not GL_FRONT or GL_BACK");
    }
    latch_color_material(ctx);
    Material& material = face == GL_FRONT ? ctx.lighting.front : ctx.lighting.back;
    if (const Color4* color = material_color(material, pname)) {
        std::ranges::copy(*color, params);
    } else if (pname == GL_SHININESS) {
        *params = material.shininess;
    } else if (pname == GL_COLOR_INDEXES) {
        std::ranges::copy(material.color_indexes, params);
    } else {
        record_error(ctx, GL_INVALID_ENUM, "no such material parameter");
    }
}

void latch_color_material(Context& ctx) {
    const ColorMaterial& tracking = ctx.lighting.color_material;
    const Color4& color = ctx.vertex.current.color();
    latch(tracking, GL_FRONT, ctx.lighting.front, color);
    latch(tracking, GL_BACK, ctx.lighting.back, color);
}

}  // namespace terrazzo::gl
