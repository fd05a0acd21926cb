// RasterPos and WindowPos (GL 1.5 §2.13): a point goes through the transformations of a vertex and becomes
// the current raster position, unless it is clipped.
//
// The position is computed as the reference computes it, with two matrix products one after the other: a last
// bit decides where texts and images stand. Colours come from the vertex program.
#include "gl/raster_position.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"
#include "pipeline/geometry/geometry_table.h"
#include "pipeline/schedule/float_environment.h"

namespace terrazzo::gl {
namespace {

using Vector4 = std::array<GLfloat, 4>;
using Vector3 = std::array<GLfloat, 3>;

Vector4 transform(const Matrix4& matrix, const Vector4& v) {
    Vector4 out;
    for (int row = 0; row < 4; ++row) {
        const float* const m = matrix.m + row;
        out[static_cast<std::size_t>(row)] = m[0] * v[0] + m[4] * v[1] + m[8] * v[2] + m[12] * v[3];
    }
    return out;
}

template <typename A, typename B>
GLfloat dot3(const A& a, const B& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

GLfloat dot4(const Vector4& a, const Vector4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

bool is_inside(const Context& ctx, const Vector4& clip) {
    const bool zero_to_one = ctx.matrix.transform.clip_depth_mode == GL_ZERO_TO_ONE;
    const std::size_t axes = ctx.matrix.transform.depth_clamp ? 2 : 3;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const GLfloat low = axis == 2 && zero_to_one ? 0.0f : -clip[3];
        if (!(clip[axis] >= low && clip[axis] <= clip[3])) return false;
    }
    for (const ClipPlane& plane : ctx.matrix.transform.clip_planes) {
        if (!plane.enabled) continue;
        Vector4 in_clip_space;
        transform_row(in_clip_space.data(), plane.eye_plane.data(), ctx.matrix.projection.top().inverse);
        if (dot4(clip, in_clip_space) < 0) return false;
    }
    return true;
}

// Window coordinates count upwards here (GL 1.5 §2.11.1).
Vector4 window_position(const ViewportState& viewport, const TransformState& transform, const Vector4& clip) {
    const GLfloat inverse = clip[3] == 0 ? 1.0f : 1.0f / clip[3];
    const GLfloat half_width = 0.5f * static_cast<float>(viewport.width),
                  half_height = 0.5f * static_cast<float>(viewport.height);
    const GLfloat up = transform.clip_origin == GL_UPPER_LEFT ? -half_height : half_height;
    const DepthMapping depth = depth_mapping(viewport, transform.clip_depth_mode);
    return {clip[0] * inverse * half_width + (half_width + static_cast<float>(viewport.x)),
            clip[1] * inverse * up + (half_height + static_cast<float>(viewport.y)),
            clip[2] * inverse * depth.scale + depth.translate, clip[3]};
}

void clamp_to_depth_range(const ViewportState& viewport, GLfloat& z) {
    const auto [low, high] = std::minmax(viewport.near_depth, viewport.far_depth);
    z = std::clamp(z, static_cast<GLfloat>(low), static_cast<GLfloat>(high));
}

Vector4 clamped(const Vector4& color) {
    Vector4 out;
    std::transform(color.begin(), color.end(), out.begin(),
                   [](GLfloat c) { return std::clamp(c, 0.0f, 1.0f); });
    return out;
}

// The fog coordinate takes the distance's place where fog comes from it.
GLfloat fog_distance(const Context& ctx, GLfloat distance) {
    return ctx.fog.coordinate_source == GL_FOG_COORDINATE
               ? ctx.vertex.current.values[pipeline::kFogCoordinate][0]
               : distance;
}

// Whether every vertex with the same attributes gets the same colours, wherever it is.
bool is_lit_from_afar(const pipeline::Lighting& lighting) {
    const auto first = lighting.lights.begin();
    return !lighting.local_viewer && std::none_of(first, first + lighting.light_count,
                                                  [](auto& light) { return light.positional || light.spot; });
}

// Takes over the current values of the attributes that lighting looks at; whether they were the same.
bool update_lit_attributes(const Context& ctx, pipeline::VertexInput& input) {
    bool same = true;
    const auto update = [&](int first, int last) {
        const auto begin = static_cast<std::size_t>(first),
                   count = static_cast<std::size_t>(last - first + 1);
        const auto* const values = &ctx.vertex.current.values[begin];
        if (std::memcmp(&input.constants[begin], values, count * sizeof *values) == 0) return;
        std::copy_n(values, count, &input.constants[begin]);
        same = false;
    };
    update(pipeline::kNormal, pipeline::kColor);
    update(pipeline::kFrontAmbient, pipeline::kBackShininess);
    return same;
}

// What lighting makes of the point as a vertex, front side up.
void light_position(Context& ctx, const Vector4& object, RasterPosition& out) {
    Drawing& drawing = ctx.drawing;
    pipeline::VertexInput& input = drawing.raster_input;
    LitColors& lit = drawing.raster_lit;
    const pipeline::VertexState& state = drawing.state.vertex;
    const bool is_valid = ctx.dirty == 0 && lit.lighting == drawing.lighting_made;
    const bool same = is_valid && update_lit_attributes(ctx, input);
    if (!is_valid) input.constants = ctx.vertex.current.values;
    input.constants[pipeline::kPosition] = object;
    if (!same || !is_lit_from_afar(state.lighting)) {
        lit.lighting = 0;  // until there are new ones
        if (!is_valid) validate(ctx, input);
        pipeline::ShadedVertices& vertices = drawing.raster_vertices;
        vertices.reserve(pipeline::kFirstVarying + 2 * state.varyings.count);
        const pipeline::FloatEnvironment environment;
        pipeline::geometry().shade_vertices(state, input, nullptr, 0, 1, vertices);
        const auto read = [&](int varying) { return vertices.column(pipeline::kFirstVarying + varying)[0]; };
        for (int c = 0; c < 4; ++c) lit.color[static_cast<std::size_t>(c)] = read(state.varyings.color + c);
        lit.secondary = {0, 0, 0, 1};
        if (state.varyings.secondary >= 0)
            for (int c = 0; c < 3; ++c)
                lit.secondary[static_cast<std::size_t>(c)] = read(state.varyings.secondary + c);
        lit.lighting = drawing.lighting_made;
    }
    out.color = lit.color;
    out.secondary_color = lit.secondary;
}

Vector3 normalize(const Vector3& v) {
    const GLfloat length2 = dot3(v, v);
    if (length2 == 0) return v;
    const GLfloat scale = 1.0f / std::sqrt(length2);
    return {v[0] * scale, v[1] * scale, v[2] * scale};
}

Vector3 eye_normal(Context& ctx) {
    const StackMatrix& modelview = ctx.matrix.modelview.top();
    const float* const m = modelview.inverse.m;
    const auto& n = ctx.vertex.current.values[pipeline::kNormal];
    Vector3 normal{dot3(n, m), dot3(n, m + 4), dot3(n, m + 8)};
    if (ctx.matrix.transform.normalize) return normalize(normal);
    const GLfloat length2 = m[2] * m[2] + m[6] * m[6] + m[10] * m[10];
    if (!ctx.matrix.transform.rescale_normal || preserves_length(modelview) || length2 < 1e-12f)
        return normal;
    const GLfloat scale = 1.0f / std::sqrt(length2);
    return {normal[0] * scale, normal[1] * scale, normal[2] * scale};
}

// Texture coordinate generation (GL 1.5 §2.11.4) for one point.
Vector4 generate_coordinates(Context& ctx, const TexgenState& texgen, const Vector4& object,
                             const Vector4& eye, Vector4 coordinates) {
    const Vector3 normal = eye_normal(ctx), ray = normalize({eye[0], eye[1], eye[2]});
    const GLfloat twice = 2.0f * dot3(normal, ray);
    const Vector3 reflected{ray[0] - normal[0] * twice, ray[1] - normal[1] * twice,
                            ray[2] - normal[2] * twice};
    const GLfloat m2 = reflected[0] * reflected[0] + reflected[1] * reflected[1] +
                       (reflected[2] + 1.0f) * (reflected[2] + 1.0f);
    const GLfloat share = m2 > 0 ? 0.5f * (1.0f / std::sqrt(m2)) : 0.0f;
    for (std::size_t c = 0; c < 4; ++c) {
        const TexgenCoordinate& generator = texgen.coordinates[c];
        if (!generator.enabled) continue;
        switch (generator.mode) {
            case GL_OBJECT_LINEAR:
                coordinates[c] = dot4(object, generator.object_plane);
                break;
            case GL_EYE_LINEAR:
                coordinates[c] = dot4(eye, generator.eye_plane);
                break;
            case GL_SPHERE_MAP:
                coordinates[c] = reflected[c % 3] * share + 0.5f;
                break;
            case GL_REFLECTION_MAP:
                coordinates[c] = reflected[c % 3];
                break;
            case GL_NORMAL_MAP:
                coordinates[c] = normal[c % 3];
                break;
        }
    }
    return coordinates;
}

void transform_texture_coordinates(Context& ctx, const Vector4& object, const Vector4& eye,
                                   RasterPosition& out) {
    for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
        Vector4 coordinates = ctx.vertex.current.values[pipeline::kTexture0 + unit];
        const TexgenState& texgen = ctx.texture.units[unit].texgen;
        if (std::any_of(texgen.coordinates.begin(), texgen.coordinates.end(),
                        [](auto& c) { return c.enabled; }))
            coordinates = generate_coordinates(ctx, texgen, object, eye, coordinates);
        out.texture_coordinates[unit] = transform(ctx.matrix.texture[unit].top().value, coordinates);
    }
}

}  // namespace

void raster_pos4f(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    settle(ctx.matrix.modelview.top());
    settle(ctx.matrix.projection.top());
    const Vector4 object{x, y, z, w}, eye = transform(ctx.matrix.modelview.top().value, object),
                                      clip = transform(ctx.matrix.projection.top().value, eye);
    if (!is_inside(ctx, clip)) {
        ctx.raster_position.valid = false;
        return;
    }
    RasterPosition made = ctx.raster_position;
    made.window = window_position(ctx.framebuffer.viewport, ctx.matrix.transform, clip);
    if (ctx.matrix.transform.depth_clamp) clamp_to_depth_range(ctx.framebuffer.viewport, made.window[2]);
    made.distance = fog_distance(ctx, std::sqrt(dot3(eye, eye)));
    made.index = ctx.vertex.current.index;
    made.color = clamped(ctx.vertex.current.color());
    made.secondary_color = clamped(ctx.vertex.current.values[pipeline::kSecondaryColor]);
    if (ctx.lighting.enabled) light_position(ctx, object, made);
    transform_texture_coordinates(ctx, object, eye, made);
    made.valid = true;
    ctx.raster_position = made;
    if (ctx.render_mode.mode == GL_SELECT) note_hit(ctx, made.window[2]);
}

void window_pos3f(Context& ctx, GLfloat x, GLfloat y, GLfloat z) {
    const ViewportState& viewport = ctx.framebuffer.viewport;
    const auto range = static_cast<float>(viewport.far_depth - viewport.near_depth);
    RasterPosition& raster = ctx.raster_position;
    raster.window = {x, y, std::clamp(z, 0.0f, 1.0f) * range + static_cast<float>(viewport.near_depth), 1};
    raster.distance = fog_distance(ctx, 0);
    raster.index = ctx.vertex.current.index;
    raster.color = clamped(ctx.vertex.current.color());
    raster.secondary_color = clamped(ctx.vertex.current.values[pipeline::kSecondaryColor]);
    for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit)
        raster.texture_coordinates[unit] = ctx.vertex.current.values[pipeline::kTexture0 + unit];
    raster.valid = true;
    if (ctx.render_mode.mode == GL_SELECT) note_hit(ctx, raster.window[2]);
}

}  // namespace terrazzo::gl
