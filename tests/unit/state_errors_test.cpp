// Every error rule of the state commands: the code that GL 1.5 names, and nothing changed.
#include <gmock/gmock.h>

#include <functional>

#include "state_fixture.h"

namespace terrazzo::test {
namespace {

struct BadCall {
    const char* text;
    GLenum error;
    std::function<void(const kit::Gl& gl)> call;
};

const GLfloat kVector[4] = {1, 2, 3, 4};
const GLdouble kPlane[4] = {1, 2, 3, 4};
const GLint kCounts[2] = {0, -1};
const void* const kNoIndices[2] = {nullptr, nullptr};

GLuint kNoNames[1] = {};

const BadCall kBadCalls[] = {
    {"Enable", GL_INVALID_ENUM, [](auto& gl) { gl.Enable(GL_TRIANGLES); }},
    {"Enable of a client array", GL_INVALID_ENUM, [](auto& gl) { gl.Enable(GL_VERTEX_ARRAY); }},
    {"Disable", GL_INVALID_ENUM, [](auto& gl) { gl.Disable(0xdead); }},
    {"Enable of a light too many", GL_INVALID_ENUM, [](auto& gl) { gl.Enable(GL_LIGHT0 + 8); }},
    {"Enable of a clip plane too many", GL_INVALID_ENUM, [](auto& gl) { gl.Enable(GL_CLIP_PLANE0 + 6); }},
    {"IsEnabled", GL_INVALID_ENUM, [](auto& gl) { gl.IsEnabled(GL_COPY); }},

    {"ClipControl, origin", GL_INVALID_ENUM, [](auto& gl) { gl.ClipControl(GL_LEFT, GL_ZERO_TO_ONE); }},
    {"ClipControl, depth", GL_INVALID_ENUM, [](auto& gl) { gl.ClipControl(GL_UPPER_LEFT, GL_LESS); }},
    {"MatrixMode", GL_INVALID_ENUM, [](auto& gl) { gl.MatrixMode(GL_COLOR_MATERIAL); }},
    {"PopMatrix of the last one", GL_STACK_UNDERFLOW, [](auto& gl) { gl.PopMatrix(); }},
    {"Frustum, near = 0", GL_INVALID_VALUE, [](auto& gl) { gl.Frustum(-1, 1, -1, 1, 0, 1); }},
    {"Frustum, far < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Frustum(-1, 1, -1, 1, 1, -1); }},
    {"Frustum, near = far", GL_INVALID_VALUE, [](auto& gl) { gl.Frustum(-1, 1, -1, 1, 2, 2); }},
    {"Frustum, left = right", GL_INVALID_VALUE, [](auto& gl) { gl.Frustum(1, 1, -1, 1, 1, 2); }},
    {"Frustum, bottom = top", GL_INVALID_VALUE, [](auto& gl) { gl.Frustum(-1, 1, 1, 1, 1, 2); }},
    {"Ortho, near = far", GL_INVALID_VALUE, [](auto& gl) { gl.Ortho(-1, 1, -1, 1, 2, 2); }},
    {"Ortho, left = right", GL_INVALID_VALUE, [](auto& gl) { gl.Ortho(1, 1, -1, 1, 1, 2); }},
    {"Ortho, bottom = top", GL_INVALID_VALUE, [](auto& gl) { gl.Ortho(-1, 1, 1, 1, 1, 2); }},
    {"ClipPlane", GL_INVALID_ENUM, [](auto& gl) { gl.ClipPlane(GL_CLIP_PLANE0 + 6, kPlane); }},
    {"ClipPlane of null", GL_INVALID_VALUE, [](auto& gl) { gl.ClipPlane(GL_CLIP_PLANE0, nullptr); }},
    {"Viewport, width < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Viewport(0, 0, -1, 1); }},
    {"Viewport, height < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Viewport(0, 0, 1, -1); }},

    {"Light of a light too many", GL_INVALID_ENUM,
     [](auto& gl) { gl.Lightfv(GL_LIGHT0 + 8, GL_AMBIENT, kVector); }},
    {"Light", GL_INVALID_ENUM, [](auto& gl) { gl.Lightfv(GL_LIGHT0, GL_SHININESS, kVector); }},
    {"Light, exponent < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1); }},
    {"Light, exponent > 128", GL_INVALID_VALUE,
     [](auto& gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129); }},
    {"Light, cutoff < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1); }},
    {"Light, cutoff 91", GL_INVALID_VALUE, [](auto& gl) { gl.Lighti(GL_LIGHT0, GL_SPOT_CUTOFF, 91); }},
    {"Light, attenuation < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -0.1f); }},
    {"LightModel", GL_INVALID_ENUM, [](auto& gl) { gl.LightModelf(GL_AMBIENT, 1); }},
    {"LightModel, colour control", GL_INVALID_ENUM,
     [](auto& gl) { gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_TRUE); }},
    {"Material, face", GL_INVALID_ENUM, [](auto& gl) { gl.Materialfv(GL_LEFT, GL_AMBIENT, kVector); }},
    {"Material", GL_INVALID_ENUM, [](auto& gl) { gl.Materialfv(GL_FRONT, GL_POSITION, kVector); }},
    {"Material, shininess < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Materialf(GL_FRONT, GL_SHININESS, -1); }},
    {"Material, shininess > 128", GL_INVALID_VALUE,
     [](auto& gl) { gl.Materialf(GL_FRONT, GL_SHININESS, 129); }},
    {"ColorMaterial, face", GL_INVALID_ENUM, [](auto& gl) { gl.ColorMaterial(GL_LEFT, GL_AMBIENT); }},
    {"ColorMaterial, mode", GL_INVALID_ENUM, [](auto& gl) { gl.ColorMaterial(GL_FRONT, GL_SHININESS); }},
    {"BlendFuncSeparate, source of alpha", GL_INVALID_ENUM,
     [](auto& gl) { gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ADD, GL_ONE); }},
    {"BlendFuncSeparate, destination of alpha", GL_INVALID_ENUM,
     [](auto& gl) { gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_SRC_ALPHA_SATURATE); }},
    {"BlendFunc, destination of colours", GL_INVALID_ENUM,
     [](auto& gl) { gl.BlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE); }},
    {"GenTextures, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.GenTextures(-1, kNoNames); }},
    {"DeleteTextures, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.DeleteTextures(-1, kNoNames); }},
    {"GenBuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.GenBuffers(-1, kNoNames); }},
    {"DeleteBuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.DeleteBuffers(-1, kNoNames); }},
    {"GenQueries, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.GenQueries(-1, kNoNames); }},
    {"DeleteQueries, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.DeleteQueries(-1, kNoNames); }},
    {"GenFramebuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.GenFramebuffers(-1, kNoNames); }},
    {"DeleteFramebuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.DeleteFramebuffers(-1, kNoNames); }},
    {"GenRenderbuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.GenRenderbuffers(-1, kNoNames); }},
    {"DeleteRenderbuffers, n < 0", GL_INVALID_VALUE, [](auto& gl) { gl.DeleteRenderbuffers(-1, kNoNames); }},
    {"CopyTexSubImage1D, -1", GL_INVALID_VALUE,
     [](auto& gl) { gl.CopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, -1); }},
    {"CopyTexSubImage2D, -1, 4", GL_INVALID_VALUE,
     [](auto& gl) { gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, -1, 4); }},
    {"CopyTexSubImage2D, 4, -1", GL_INVALID_VALUE,
     [](auto& gl) { gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, -1); }},
    {"CopyTexSubImage3D, -1, 4", GL_INVALID_VALUE,
     [](auto& gl) { gl.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, -1, 4); }},
    {"CopyTexSubImage3D, 4, -1", GL_INVALID_VALUE,
     [](auto& gl) { gl.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 4, -1); }},
    {"ShadeModel", GL_INVALID_ENUM, [](auto& gl) { gl.ShadeModel(GL_LINEAR); }},

    {"PointSize 0", GL_INVALID_VALUE, [](auto& gl) { gl.PointSize(0); }},
    {"PointSize < 0", GL_INVALID_VALUE, [](auto& gl) { gl.PointSize(-1); }},
    {"PointParameter", GL_INVALID_ENUM, [](auto& gl) { gl.PointParameterf(GL_POINT_SIZE, 1); }},
    {"PointParameter, size < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.PointParameterf(GL_POINT_SIZE_MIN, -1); }},
    {"PointParameter, threshold NaN", GL_INVALID_VALUE,
     [](auto& gl) { gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, __builtin_nanf("")); }},
    {"LineWidth 0", GL_INVALID_VALUE, [](auto& gl) { gl.LineWidth(0); }},
    {"LineWidth NaN", GL_INVALID_VALUE, [](auto& gl) { gl.LineWidth(__builtin_nanf("")); }},
    {"PolygonMode, face", GL_INVALID_ENUM, [](auto& gl) { gl.PolygonMode(GL_LEFT, GL_FILL); }},
    {"PolygonMode, mode", GL_INVALID_ENUM, [](auto& gl) { gl.PolygonMode(GL_FRONT, GL_SMOOTH); }},
    {"CullFace", GL_INVALID_ENUM, [](auto& gl) { gl.CullFace(GL_CW); }},
    {"FrontFace", GL_INVALID_ENUM, [](auto& gl) { gl.FrontFace(GL_FRONT); }},
    {"ActiveStencilFace, both", GL_INVALID_ENUM,
     [](auto& gl) { gl.ActiveStencilFaceEXT(GL_FRONT_AND_BACK); }},
    {"StencilFuncSeparate, front", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilFuncSeparateATI(GL_KEEP, GL_ALWAYS, 0, 1); }},
    {"StencilFuncSeparate, back", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilFuncSeparateATI(GL_ALWAYS, GL_KEEP, 0, 1); }},
    {"StencilOpSeparate, face", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilOpSeparateATI(GL_LEFT, GL_KEEP, GL_KEEP, GL_KEEP); }},
    {"StencilOpSeparate, stencil fails", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilOpSeparateATI(GL_FRONT, GL_LESS, GL_KEEP, GL_KEEP); }},
    {"StencilOpSeparate, depth fails", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilOpSeparateATI(GL_BACK, GL_KEEP, GL_LESS, GL_KEEP); }},
    {"StencilOpSeparate, both pass", GL_INVALID_ENUM,
     [](auto& gl) { gl.StencilOpSeparateATI(GL_FRONT_AND_BACK, GL_KEEP, GL_KEEP, GL_LESS); }},
    {"LockArrays, first < 0", GL_INVALID_VALUE, [](auto& gl) { gl.LockArraysEXT(-1, 4); }},
    {"LockArrays, none", GL_INVALID_VALUE, [](auto& gl) { gl.LockArraysEXT(0, 0); }},
    {"UnlockArrays, not locked", GL_INVALID_OPERATION, [](auto& gl) { gl.UnlockArraysEXT(); }},

    {"PolygonStipple of null", GL_INVALID_VALUE, [](auto& gl) { gl.PolygonStipple(nullptr); }},

    {"Fog", GL_INVALID_ENUM, [](auto& gl) { gl.Fogf(GL_AMBIENT, 1); }},
    {"Fog, mode", GL_INVALID_ENUM, [](auto& gl) { gl.Fogi(GL_FOG_MODE, GL_NEAREST); }},
    {"Fog, source of coordinates", GL_INVALID_ENUM,
     [](auto& gl) { gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_DENSITY); }},
    {"Fog, density < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Fogf(GL_FOG_DENSITY, -1); }},

    {"MultiDrawArrays, mode", GL_INVALID_ENUM,
     [](auto& gl) { gl.MultiDrawArrays(GL_POLYGON + 1, kCounts, kCounts, 0); }},
    {"MultiDrawArrays, drawcount < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.MultiDrawArrays(GL_LINES, kCounts, kCounts, -1); }},
    {"MultiDrawArrays, a count < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.MultiDrawArrays(GL_LINES, kCounts, kCounts, 2); }},
    {"MultiDrawElements, mode", GL_INVALID_ENUM,
     [](auto& gl) { gl.MultiDrawElements(GL_POLYGON + 1, kCounts, GL_UNSIGNED_BYTE, kNoIndices, 0); }},
    {"MultiDrawElements, type", GL_INVALID_ENUM,
     [](auto& gl) { gl.MultiDrawElements(GL_LINES, kCounts, GL_FLOAT, kNoIndices, 1); }},
    {"MultiDrawElements, a count < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.MultiDrawElements(GL_LINES, kCounts, GL_UNSIGNED_BYTE, kNoIndices, 2); }},

    {"ColorPointer, blue first in shorts", GL_INVALID_OPERATION,
     [](auto& gl) { gl.ColorPointer(GL_BGRA, GL_UNSIGNED_SHORT, 0, nullptr); }},
    {"SecondaryColorPointer, blue first in packed bytes", GL_INVALID_ENUM,
     [](auto& gl) { gl.SecondaryColorPointer(GL_BGRA, GL_2_BYTES, 0, nullptr); }},
    {"ColorPointer, blue first, stride < 0", GL_INVALID_VALUE,
     [](auto& gl) { gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, -4, nullptr); }},
    {"VertexPointer, blue first", GL_INVALID_VALUE,
     [](auto& gl) { gl.VertexPointer(GL_BGRA, GL_FLOAT, 0, nullptr); }},

    {"TexEnv, target", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_DECAL); }},
    {"TexEnv", GL_INVALID_ENUM, [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, GL_DECAL); }},
    {"TexEnv, mode", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR); }},
    {"TexEnv, combiner's function", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DECAL); }},
    {"TexEnv, dot product of alphas", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGBA); }},
    {"TexEnv, combiner's source", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE0 + 8); }},
    {"TexEnv, colour for alpha", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR); }},
    {"TexEnv, operand", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_DST_COLOR); }},
    {"TexEnv, scale 3", GL_INVALID_VALUE, [](auto& gl) { gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3); }},
    {"TexEnv, scale 1.5", GL_INVALID_VALUE,
     [](auto& gl) { gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 1.5f); }},
    {"TexEnv, bias of an environment", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, 1); }},
    {"TexEnv, coordinates half replaced", GL_INVALID_VALUE,
     [](auto& gl) { gl.TexEnvf(GL_POINT_SPRITE, GL_COORD_REPLACE, 0.5f); }},
    {"TexEnv, mode of a filter", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexEnvi(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, GL_DECAL); }},
    {"TexGen, coordinate", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexGeni(GL_Q + 1, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); }},
    {"TexGen", GL_INVALID_ENUM, [](auto& gl) { gl.TexGeni(GL_S, GL_TEXTURE_ENV_MODE, GL_EYE_LINEAR); }},
    {"TexGen, mode", GL_INVALID_ENUM, [](auto& gl) { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_LINEAR); }},
    {"TexGen, sphere map for r", GL_INVALID_ENUM,
     [](auto& gl) { gl.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }},

    {"Scissor, width < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Scissor(0, 0, -1, 1); }},
    {"Scissor, height < 0", GL_INVALID_VALUE, [](auto& gl) { gl.Scissor(0, 0, 1, -1); }},
    {"AlphaFunc", GL_INVALID_ENUM, [](auto& gl) { gl.AlphaFunc(GL_ONE, 0.5f); }},
    {"StencilFunc", GL_INVALID_ENUM, [](auto& gl) { gl.StencilFunc(GL_KEEP, 1, 1); }},
    {"StencilOp, fail", GL_INVALID_ENUM, [](auto& gl) { gl.StencilOp(GL_LESS, GL_ZERO, GL_ZERO); }},
    {"StencilOp, depth fail", GL_INVALID_ENUM, [](auto& gl) { gl.StencilOp(GL_ZERO, GL_LESS, GL_ZERO); }},
    {"StencilOp, pass", GL_INVALID_ENUM, [](auto& gl) { gl.StencilOp(GL_ZERO, GL_ZERO, GL_LESS); }},
    {"DepthFunc", GL_INVALID_ENUM, [](auto& gl) { gl.DepthFunc(GL_KEEP); }},
    {"BlendFunc, source", GL_INVALID_ENUM, [](auto& gl) { gl.BlendFunc(GL_LESS, GL_ONE); }},
    {"BlendFunc, destination", GL_INVALID_ENUM, [](auto& gl) { gl.BlendFunc(GL_ZERO, GL_LESS); }},
    {"LogicOp", GL_INVALID_ENUM, [](auto& gl) { gl.LogicOp(GL_SET + 1); }},
    {"DrawBuffer", GL_INVALID_ENUM, [](auto& gl) { gl.DrawBuffer(GL_RGBA); }},
    {"DrawBuffer of one that is not there", GL_INVALID_OPERATION, [](auto& gl) { gl.DrawBuffer(GL_AUX0); }},
    {"ReadBuffer", GL_INVALID_ENUM, [](auto& gl) { gl.ReadBuffer(GL_RGBA); }},
    {"ReadBuffer of one that is not there", GL_INVALID_OPERATION, [](auto& gl) { gl.ReadBuffer(GL_RIGHT); }},
    {"Hint, target", GL_INVALID_ENUM, [](auto& gl) { gl.Hint(GL_FOG, GL_NICEST); }},
    {"Hint, mode", GL_INVALID_ENUM, [](auto& gl) { gl.Hint(GL_FOG_HINT, GL_LINEAR); }},

    {"PopAttrib of nothing", GL_STACK_UNDERFLOW, [](auto& gl) { gl.PopAttrib(); }},
    {"PopClientAttrib of nothing", GL_STACK_UNDERFLOW, [](auto& gl) { gl.PopClientAttrib(); }},
};

class StateErrors : public StateTest {};

TEST_F(StateErrors, RecordTheCodeOfTheSpecificationAndChangeNothing) {
    const auto before = dump();
    for (const BadCall& bad : kBadCalls) {
        bad.call(gl);
        EXPECT_EQ(take_error(), bad.error) << bad.text;
    }
    EXPECT_THAT(changed(before, dump()), testing::IsEmpty());
}

TEST_F(StateErrors, QueriesWriteNothing) {
    GLfloat floats[16];
    GLint integers[16];
    GLdouble doubles[16];
    GLboolean booleans[16];
    std::fill_n(floats, 16, 77.0f);
    std::fill_n(integers, 16, 77);
    std::fill_n(doubles, 16, 77.0);
    std::fill_n(booleans, 16, GLboolean{77});
    const std::function<void()> queries[] = {
        [&] { gl.GetFloatv(GL_TRIANGLES, floats); },
        [&] { gl.GetIntegerv(GL_TRIANGLES, integers); },
        [&] { gl.GetDoublev(0xdead, doubles); },
        [&] { gl.GetBooleanv(GL_ONE, booleans); },
        [&] { gl.GetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, floats); },
        [&] { gl.GetLightiv(GL_LIGHT0, GL_EMISSION, integers); },
        [&] { gl.GetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats); },
        [&] { gl.GetMaterialiv(GL_FRONT, GL_POSITION, integers); },
        [&] { gl.GetTexEnvfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, floats); },
        [&] { gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, integers); },
        [&] { gl.GetTexGendv(GL_S, GL_TEXTURE_ENV_MODE, doubles); },
        [&] { gl.GetTexGeniv(GL_Q + 1, GL_EYE_PLANE, integers); },
        [&] { gl.GetClipPlane(GL_CLIP_PLANE0 + 6, doubles); },
    };
    for (const auto& query : queries) {
        query();
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    }
    EXPECT_EQ(std::count(floats, floats + 16, 77.0f), 16);
    EXPECT_EQ(std::count(integers, integers + 16, 77), 16);
    EXPECT_EQ(std::count(doubles, doubles + 16, 77.0), 16);
    EXPECT_EQ(std::count(booleans, booleans + 16, GLboolean{77}), 16);
}

// A single value for a vector is its first component, the others are 0: the reference's rule, where GL 1.5
// leaves open what happens.
TEST_F(StateErrors, ASingleValueIsTheFirstOfAVector) {
    const auto expect_half = [&](const char* text, const std::function<void()>& set,
                                 const std::function<void(GLfloat*)>& get, int count = 4) {
        set();
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << text;
        GLfloat values[4] = {7, 7, 7, 7};
        get(values);
        EXPECT_FLOAT_EQ(values[0], 0.5f) << text;
        for (int i = 1; i < count; ++i) EXPECT_NEAR(values[i], 0, 1e-9) << text << ", component " << i;
    };
    const GLint half = 0x3fffffff;
    expect_half(
        "Light", [&] { gl.Lightf(GL_LIGHT0, GL_AMBIENT, 0.5f); },
        [&](GLfloat* v) { gl.GetLightfv(GL_LIGHT0, GL_AMBIENT, v); });
    expect_half(
        "Light of an integer", [&] { gl.Lighti(GL_LIGHT0, GL_DIFFUSE, half); },
        [&](GLfloat* v) { gl.GetLightfv(GL_LIGHT0, GL_DIFFUSE, v); });
    expect_half(
        "LightModel", [&] { gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 0.5f); },
        [&](GLfloat* v) { gl.GetFloatv(GL_LIGHT_MODEL_AMBIENT, v); });
    expect_half(
        "Material", [&] { gl.Materialf(GL_FRONT, GL_AMBIENT, 0.5f); },
        [&](GLfloat* v) { gl.GetMaterialfv(GL_FRONT, GL_AMBIENT, v); });
    expect_half(
        "Fog", [&] { gl.Fogf(GL_FOG_COLOR, 0.5f); }, [&](GLfloat* v) { gl.GetFloatv(GL_FOG_COLOR, v); });
    expect_half(
        "TexEnv", [&] { gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 0.5f); },
        [&](GLfloat* v) { gl.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v); });
    expect_half(
        "TexGen", [&] { gl.TexGenf(GL_S, GL_OBJECT_PLANE, 0.5f); },
        [&](GLfloat* v) { gl.GetTexGenfv(GL_S, GL_OBJECT_PLANE, v); });
    expect_half(
        "PointParameter", [&] { gl.PointParameterf(GL_POINT_DISTANCE_ATTENUATION, 0.5f); },
        [&](GLfloat* v) { gl.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, v); }, 3);
    // Textures refuse it at once and take it in lists.
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 0.5f);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    expect_half(
        "TexParameter in a list",
        [&] {
            gl.NewList(1, GL_COMPILE);
            gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 0.5f);
            gl.EndList();
            gl.CallList(1);
        },
        [&](GLfloat* v) { gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, v); });
}

TEST_F(StateErrors, BothBlendEquationsAreChecked) {
    using Separate = void (*)(GLenum colors, GLenum alpha);
    const auto separate =
        reinterpret_cast<Separate>(library().osmesa.GetProcAddress("glBlendEquationSeparateEXT"));
    ASSERT_NE(separate, nullptr);
    const auto before = dump();
    separate(GL_ADD, GL_MIN);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    separate(GL_MIN, GL_ADD);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    EXPECT_THAT(changed(before, dump()), testing::IsEmpty());
    separate(GL_MIN, GL_MAX);
    EXPECT_EQ(integer(GL_BLEND_EQUATION_RGB), GL_MIN);
    EXPECT_EQ(integer(GL_BLEND_EQUATION_ALPHA), GL_MAX);
}

// Every command that draws, clears, copies or reads (ARB_framebuffer_object §4.4.4.3), at once and in a list.
TEST_F(StateErrors, AnIncompleteFrameBufferIsRefused) {
    static const GLfloat corners[] = {0, 0, 1, 0, 0, 1};
    static const GLubyte indices[] = {0, 1, 2};
    static const GLint firsts[] = {0};
    static const GLsizei counts[] = {3};
    static const void* const offsets[] = {indices};
    static GLubyte pixels[4 * 4 * 4];
    const BadCall calls[] = {
        {"Begin", 0, [](auto& g) { g.Begin(GL_POINTS), g.Vertex2f(0, 0), g.End(); }},
        {"Rectf", 0, [](auto& g) { g.Rectf(0, 0, 1, 1); }},
        {"EvalMesh1", 0, [](auto& g) { g.EvalMesh1(GL_LINE, 0, 1); }},
        {"EvalMesh2", 0, [](auto& g) { g.EvalMesh2(GL_FILL, 0, 1, 0, 1); }},
        {"DrawArrays", 0, [](auto& g) { g.DrawArrays(GL_TRIANGLES, 0, 3); }},
        {"DrawElements", 0, [](auto& g) { g.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices); }},
        {"DrawRangeElements", 0,
         [](auto& g) { g.DrawRangeElements(GL_TRIANGLES, 0, 2, 3, GL_UNSIGNED_BYTE, indices); }},
        {"MultiDrawArrays", 0, [](auto& g) { g.MultiDrawArrays(GL_TRIANGLES, firsts, counts, 1); }},
        {"MultiDrawElements", 0,
         [](auto& g) { g.MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_BYTE, offsets, 1); }},
        {"DrawPixels", 0, [](auto& g) { g.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
        {"CopyPixels", 0, [](auto& g) { g.CopyPixels(0, 0, 2, 2, GL_COLOR); }},
        {"Bitmap", 0, [](auto& g) { g.Bitmap(8, 2, 0, 0, 0, 0, pixels); }},
        {"Clear", 0, [](auto& g) { g.Clear(GL_COLOR_BUFFER_BIT); }},
        {"CopyTexImage1D", 0, [](auto& g) { g.CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 2, 0); }},
        {"CopyTexImage2D", 0, [](auto& g) { g.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 2, 2, 0); }},
        {"CopyTexSubImage1D", 0, [](auto& g) { g.CopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, 1); }},
        {"CopyTexSubImage2D", 0, [](auto& g) { g.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1); }},
        {"CopyTexSubImage3D", 0, [](auto& g) { g.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 1, 1); }},
        {"BlitFramebuffer", 0,
         [](auto& g) { g.BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST); }},
        {"ReadPixels", 1, [](auto& g) { g.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
    };  // the number: the command is never part of a list
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    const GLfloat points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points);
    gl.Enable(GL_MAP1_VERTEX_3);
    gl.Enable(GL_MAP2_VERTEX_3);
    gl.VertexPointer(2, GL_FLOAT, 0, corners);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 1);  // to which nothing is attached
    ASSERT_EQ(take_error(), GLenum{GL_NO_ERROR});
    for (const BadCall& bad : calls) {
        bad.call(gl);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION}) << bad.text;
        if (bad.error) continue;
        gl.NewList(1, GL_COMPILE);
        bad.call(gl);
        gl.EndList();
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << bad.text << " while it is compiled";
        gl.CallList(1);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION}) << bad.text << " in a list";
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    for (const BadCall& call : calls) {
        call.call(gl);
        EXPECT_NE(take_error(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION}) << call.text << " to the window";
    }
}

TEST_F(StateErrors, NothingToNameOrForgetIsNoError) {
    gl.GenTextures(0, nullptr);
    gl.DeleteTextures(0, nullptr);
    gl.GenBuffers(0, nullptr);
    gl.DeleteBuffers(0, nullptr);
    gl.GenQueries(0, nullptr);
    gl.DeleteQueries(0, nullptr);
    gl.GenFramebuffers(0, nullptr);
    gl.DeleteFramebuffers(0, nullptr);
    gl.GenRenderbuffers(0, nullptr);
    gl.DeleteRenderbuffers(0, nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(StateErrors, MatrixStacksOverflowAtTheDepthTheyPromise) {
    struct Stack {
        GLenum mode, limit, depth;
    };
    for (const Stack& stack : {Stack{GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_STACK_DEPTH},
                               Stack{GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH},
                               Stack{GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH}}) {
        gl.MatrixMode(stack.mode);
        const GLint limit = integer(stack.limit);
        for (GLint depth = 1; depth < limit; ++depth) gl.PushMatrix();
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        gl.Translatef(1, 2, 3);
        const auto before = dump();
        gl.PushMatrix();
        EXPECT_EQ(take_error(), GLenum{GL_STACK_OVERFLOW});
        EXPECT_THAT(changed(before, dump()), testing::IsEmpty());
        EXPECT_EQ(integer(stack.depth), limit);
        for (GLint depth = 1; depth < limit; ++depth) gl.PopMatrix();
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        gl.PopMatrix();
        EXPECT_EQ(take_error(), GLenum{GL_STACK_UNDERFLOW});
    }
}

TEST_F(StateErrors, AttributeStacksOverflowAtTheDepthTheyPromise) {
    for (GLint i = integer(GL_MAX_ATTRIB_STACK_DEPTH); i > 0; --i) gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    for (GLint i = integer(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH); i > 0; --i) {
        gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    gl.PushAttrib(GL_FOG_BIT);
    EXPECT_EQ(take_error(), GLenum{GL_STACK_OVERFLOW});
    gl.PushClientAttrib(0);
    EXPECT_EQ(take_error(), GLenum{GL_STACK_OVERFLOW});
    EXPECT_EQ(integer(GL_ATTRIB_STACK_DEPTH), integer(GL_MAX_ATTRIB_STACK_DEPTH));
}

}  // namespace
}  // namespace terrazzo::test
