// Texture state of every unit.
#include "apply.h"

namespace terrazzo::states {
namespace {

// From a lamp beside the eye, near 1, far 6, seeing 90 degrees or so: a frustum after a translation.
constexpr float kLampProjection[16] = {1.25F, 0, 0,     0,  0,      1.25F,  0,      0,
                                       0,     0, -1.4F, -1, -0.75F, -0.75F, -2.68F, -0.2F};

void set_parameters(const kit::Gl& gl, const State& state, GLenum target, GLenum wrap) {
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(state.number(Axis::kFilter)));
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(state.number(Axis::kFilter, 1)));
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.TexParameteri(target, axis, static_cast<GLint>(wrap));
    if (wrap == GL_CLAMP || wrap == GL_CLAMP_TO_BORDER) {
        const float border[4] = {0.9F, 0.3F, 0.2F, 0.5F};
        gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border);
    }
    const auto anisotropy = static_cast<float>(state.number(Axis::kFilter, 2));
    if (anisotropy > 1 && target != GL_TEXTURE_3D)
        gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
}

GLuint make_texture(const kit::Gl& gl, const State& state, GLuint unit) {
    if (unit == 0) {
        const TextureKind kind = kind_of(state);
        const GLuint name = create_texture(gl, kind, 1);
        set_parameters(gl, state, kind.target, state.number(Axis::kWrap));
        if (state.is(Axis::kFormat, "depth-compare")) {
            gl.TexParameteri(kind.target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
            gl.TexParameteri(kind.target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        }
        gl.Enable(kind.target);
        return name;
    }
    constexpr int kEdge = 128;
    TextureKind kind;
    kind.width = kind.height = kEdge;
    kind.mipmapped = kind_of(state).mipmapped;
    const GLuint name = create_texture(gl, kind, 100 * unit);
    set_parameters(gl, state, kind.target, GL_REPEAT);
    gl.Enable(kind.target);
    return name;
}

void set_sources(const kit::Gl& gl, GLenum first, GLenum second) {
    const auto set = [&](GLenum name, GLenum value) {
        gl.TexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value));
    };
    set(GL_SOURCE0_RGB, first);
    set(GL_SOURCE1_RGB, second);
    set(GL_SOURCE2_RGB, GL_CONSTANT);
    set(GL_OPERAND0_RGB, GL_SRC_COLOR);
    set(GL_OPERAND1_RGB, GL_SRC_COLOR);
    set(GL_OPERAND2_RGB, GL_SRC_ALPHA);
    set(GL_COMBINE_ALPHA, GL_MODULATE);
    set(GL_SOURCE0_ALPHA, GL_TEXTURE);
    set(GL_SOURCE1_ALPHA, GL_PREVIOUS);
}

void set_environment(const kit::Gl& gl, const State& state) {
    const GLenum mode = state.number(Axis::kEnvironment);
    const float colour[4] = {0.9F, 0.7F, 0.3F, 0.6F};
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, colour);
    if (mode != GL_COMBINE) return;
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(state.number(Axis::kEnvironment, 1)));
    gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, static_cast<float>(state.number(Axis::kEnvironment, 2)));
    set_sources(gl, state.number(Axis::kEnvironment, 3), state.number(Axis::kEnvironment, 4));
}

// The units before the last: light maps and detail in turn, so that eight of them are neither black nor
// white.
void set_plain_environment(const kit::Gl& gl, GLuint unit) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit % 2 ? GL_COMBINE : GL_MODULATE);
    if (unit % 2 == 0) return;
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD_SIGNED);
    set_sources(gl, GL_TEXTURE, GL_PREVIOUS);
}

// Row of the matrix that takes the lamp's clip coordinates from [-1, 1] to [0, 1].
void lamp_plane(int row, float plane[4]) {
    for (int i = 0; i < 4; ++i) {
        const float* column = kLampProjection + 4 * i;
        plane[i] = row == 3 ? column[3] : 0.5F * (column[row] + column[3]);
    }
}

void set_generation(const kit::Gl& gl, const State& state) {
    constexpr GLenum kNames[4] = {GL_S, GL_T, GL_R, GL_Q};
    constexpr GLenum kEnables[4] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q};
    constexpr float kPlanes[4][4] = {
        {0.8F, 0.1F, 0.2F, 0.3F}, {-0.1F, 0.9F, 0.1F, 0.2F}, {0, 0, 0.5F, 2}, {0, 0, 0, 1}};
    const GLenum mode = state.number(Axis::kTexgen), which = state.number(Axis::kTexgen, 1);
    for (int i = 0; i < 4; ++i) {
        if (!(which & 1U << i)) continue;
        gl.TexGeni(kNames[i], GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
        float plane[4] = {kPlanes[i][0], kPlanes[i][1], kPlanes[i][2], kPlanes[i][3]};
        if (which & kQ) lamp_plane(i, plane);
        if (mode == GL_OBJECT_LINEAR) gl.TexGenfv(kNames[i], GL_OBJECT_PLANE, plane);
        if (mode == GL_EYE_LINEAR) gl.TexGenfv(kNames[i], GL_EYE_PLANE, plane);
        gl.Enable(kEnables[i]);
    }
}

}  // namespace

const float* lamp_projection() {
    return kLampProjection;
}

GLuint apply_textures(const kit::Gl& gl, const State& state) {
    const GLuint units = state.number(Axis::kUnits);
    GLuint first = 0;
    for (GLuint unit = units; unit-- > 0;) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        first = make_texture(gl, state, unit);
        if (unit == units - 1)
            set_environment(gl, state);
        else
            set_plain_environment(gl, unit);
    }
    if (units > 0) set_generation(gl, state);
    return first;
}

}  // namespace terrazzo::states
