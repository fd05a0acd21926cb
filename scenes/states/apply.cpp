// Vertex, raster and fragment state.
#include "apply.h"

namespace terrazzo::states {
namespace {

void set_enabled(const kit::Gl& gl, GLenum what, bool enabled) {
    enabled ? gl.Enable(what) : gl.Disable(what);
}

void apply_view(const kit::Gl& gl, const State& state) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (state.number(Axis::kView) == 0)
        gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 8);
    else
        gl.Ortho(-1.5, 1.5, -1.5, 1.5, 1, 8);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
}

void apply_light(const kit::Gl& gl, GLuint number, GLenum kinds, GLuint count) {
    const GLenum light = GL_LIGHT0 + number;
    const float side = number % 2 ? -1.0F : 1.0F, share = 1.0F / (0.5F + 0.5F * static_cast<float>(count));
    const bool is_positional = kinds & kPositional;
    const float position[4] = {side * (1 + 0.3F * static_cast<float>(number)),
                               1.5F - 0.4F * static_cast<float>(number), is_positional ? -1.0F : 2.0F,
                               is_positional ? 1.0F : 0.0F};
    const float diffuse[4] = {0.9F * share, (0.9F - 0.05F * static_cast<float>(number)) * share, 0.8F * share,
                              1};
    const float white[4] = {0.8F, 0.8F, 0.7F, 1}, black[4] = {0, 0, 0, 1};
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_DIFFUSE, diffuse);
    gl.Lightfv(light, GL_SPECULAR, kinds & kSpecular ? white : black);
    if (is_positional) gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.2F);
    if (kinds & kSpot) {
        const float direction[3] = {-0.4F, -0.5F, -1};
        gl.Lightfv(light, GL_SPOT_DIRECTION, direction);
        gl.Lightf(light, GL_SPOT_CUTOFF, 40);
        gl.Lightf(light, GL_SPOT_EXPONENT, 4);
    }
    gl.Enable(light);
}

void apply_lights(const kit::Gl& gl, const State& state) {
    const GLuint count = state.number(Axis::kLights);
    const GLenum kinds = state.number(Axis::kLights, 1);
    if (count == 0) return;
    for (GLuint i = 0; i < count; ++i) apply_light(gl, i, kinds, count);
    const float shine[4] = {0.6F, 0.6F, 0.6F, 1}, front[4] = {0.8F, 0.5F, 0.4F, 0.8F},
                back[4] = {0.3F, 0.5F, 0.8F, 0.6F};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, front);
    if (kinds & kTwoSided) gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    if (kinds & kSpecular) {
        gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
        gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 24);
    }
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, kinds & kTwoSided ? GL_TRUE : GL_FALSE);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, kinds & kLocalViewer ? GL_TRUE : GL_FALSE);
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                   kinds & kSeparate ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    if (const GLenum tracked = state.number(Axis::kMaterial)) {
        gl.ColorMaterial(GL_FRONT_AND_BACK, tracked);
        gl.Enable(GL_COLOR_MATERIAL);
    }
    gl.Enable(GL_LIGHTING);
}

void apply_clip_planes(const kit::Gl& gl, const State& state) {
    constexpr GLdouble kPlanes[2][4] = {{1, 0.3, 0, 0.9}, {-0.5, -1, 0, 1.1}};
    for (GLuint i = 0; i < state.number(Axis::kClip); ++i) {
        gl.ClipPlane(GL_CLIP_PLANE0 + i, kPlanes[i]);
        gl.Enable(GL_CLIP_PLANE0 + i);
    }
}

void apply_stipples(const kit::Gl& gl) {
    GLubyte pattern[128];
    for (int i = 0; i < 128; ++i) pattern[i] = i / 4 % 2 ? 0x33 : 0xCC;
    gl.PolygonStipple(pattern);
    gl.LineStipple(2, 0x3C5F);
}

void apply_fog(const kit::Gl& gl, const State& state) {
    const GLenum mode = state.number(Axis::kFog);
    if (mode == 0) return;
    const float colour[4] = {0.7F, 0.75F, 0.8F, 1};
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, static_cast<GLint>(mode));
    gl.Fogf(GL_FOG_START, 2);
    gl.Fogf(GL_FOG_END, 4.5F);
    gl.Fogf(GL_FOG_DENSITY, mode == GL_EXP ? 0.2F : 0.25F);
    gl.Fogfv(GL_FOG_COLOR, colour);
}

void apply_blend(const kit::Gl& gl, const State& state) {
    const GLenum kind = state.number(Axis::kBlend);
    if (kind == 0) return;
    gl.Enable(kind);
    if (kind == GL_COLOR_LOGIC_OP) {
        gl.LogicOp(state.number(Axis::kBlend, 1));
        return;
    }
    gl.BlendFunc(state.number(Axis::kBlend, 1), state.number(Axis::kBlend, 2));
    gl.BlendEquation(state.number(Axis::kBlend, 3));
    gl.BlendColor(0.6F, 0.5F, 0.4F, 0.55F);
}

void apply_alpha(const kit::Gl& gl, const State& state) {
    const GLenum function = state.number(Axis::kAlpha);
    if (function == 0) return;
    gl.Enable(GL_ALPHA_TEST);
    gl.AlphaFunc(function, static_cast<float>(state.number(Axis::kAlpha, 1)) / 255.0F);
}

}  // namespace

void apply_vertex_state(const kit::Gl& gl, const State& state) {
    apply_view(gl, state);
    apply_lights(gl, state);
    apply_clip_planes(gl, state);
    gl.ShadeModel(state.number(Axis::kShade));
    gl.Color4f(0.85F, 0.9F, 0.8F, 0.7F);
}

void apply_raster_state(const kit::Gl& gl, const State& state) {
    const auto size = static_cast<float>(state.number(Axis::kPrimitive, 1));
    gl.LineWidth(size);
    gl.PointSize(size);
    if (const GLenum enabled = state.number(Axis::kPrimitive, 2)) {
        apply_stipples(gl);
        gl.Enable(enabled);
    }
    gl.PolygonMode(GL_FRONT_AND_BACK, state.number(Axis::kPrimitive, 3));
    if (const GLenum face = state.number(Axis::kCull)) {
        gl.CullFace(face);
        gl.Enable(GL_CULL_FACE);
    }
    if (state.number(Axis::kOffset)) {
        gl.PolygonOffset(1.5F, 2);
        for (const GLenum of : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
            gl.Enable(of);
    }
    apply_fog(gl, state);
}

void apply_masks(const kit::Gl& gl, const State& state) {
    GLboolean mask[4];
    for (std::size_t i = 0; i < 4; ++i) mask[i] = static_cast<GLboolean>(state.number(Axis::kMask, i));
    gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
    const GLenum function = state.number(Axis::kDepth);
    set_enabled(gl, GL_DEPTH_TEST, function != 0);
    if (function) gl.DepthFunc(function);
    gl.DepthMask(static_cast<GLboolean>(state.number(Axis::kDepth, 1)));
}

void apply_stencil(const kit::Gl& gl, const State& state) {
    const GLenum kind = state.number(Axis::kStencil);
    set_enabled(gl, GL_STENCIL_TEST, kind != kNoStencil);
    gl.StencilFunc(kind == kMasked ? GL_EQUAL : GL_ALWAYS, 1, ~0U);
    if (kind == kMasked)
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    else if (kind == kReplaced)
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    else if (kind == kCounted)
        gl.StencilOp(GL_KEEP, GL_INVERT, GL_INCR);
    if (kind != kSides) return;
    gl.StencilOpSeparateATI(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_INCR_WRAP);
    gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_DECR_WRAP);
}

void apply_fragment_state(const kit::Gl& gl, const State& state) {
    apply_alpha(gl, state);
    apply_blend(gl, state);
    apply_masks(gl, state);
    if (state.number(Axis::kStencil) != kNoStencil) apply_stencil(gl, state);
}

Attributes attributes_of(const State& state) {
    Attributes attributes;
    const bool is_lit = state.number(Axis::kLights) > 0;
    const GLenum texgen = state.number(Axis::kTexgen);
    attributes.normals = is_lit || texgen == GL_SPHERE_MAP || texgen == GL_REFLECTION_MAP;
    if (!is_lit || state.number(Axis::kMaterial)) attributes.colours = state.number(Axis::kColour);
    const GLuint units = state.number(Axis::kUnits);
    for (GLuint unit = 1; unit < units; ++unit) attributes.units[unit].components = 2;
    if (units == 0) return attributes;
    const bool is_compared = state.is(Axis::kFormat, "depth-compare");
    const int wanted = is_compared ? 3 : static_cast<int>(state.number(Axis::kTarget, 1));
    const GLenum generated = state.number(Axis::kTexgen, 1);
    const bool all_generated = wanted == 3 ? (generated & kR) != 0 : generated != kNoTexgen;
    attributes.units[0].components = all_generated ? 0 : wanted;
    attributes.units[0].direction = state.is(Axis::kTarget, "cube");
    return attributes;
}

}  // namespace terrazzo::states
