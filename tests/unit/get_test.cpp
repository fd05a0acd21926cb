// The conversions of queries (GL 1.5 §6.1.2) and what commands keep of what they are given.
#include "state_fixture.h"

namespace terrazzo::test {
namespace {

class Get : public StateTest {
  protected:
    std::vector<GLint> integers(GLenum pname, std::size_t count) {
        std::vector<GLint> values(16);
        gl.GetIntegerv(pname, values.data());
        values.resize(count);
        return values;
    }
    std::vector<GLfloat> floats(GLenum pname, std::size_t count) {
        std::vector<GLfloat> values(16);
        gl.GetFloatv(pname, values.data());
        values.resize(count);
        return values;
    }
    GLboolean boolean(GLenum pname) {
        GLboolean values[16] = {77};
        gl.GetBooleanv(pname, values);
        return values[0];
    }
};

constexpr GLint kLargest = 2147483647;
constexpr GLint kSmallest = -kLargest - 1;

TEST_F(Get, FloatsAreRoundedToTheNearestInteger) {
    gl.Fogf(GL_FOG_START, 2.6f);
    EXPECT_EQ(integer(GL_FOG_START), 3);
    gl.Fogf(GL_FOG_START, -2.6f);
    EXPECT_EQ(integer(GL_FOG_START), -3);
    gl.Translatef(1.75f, -1.75f, 0);
    EXPECT_EQ(integers(GL_MODELVIEW_MATRIX, 14)[12], 2);
    EXPECT_EQ(integers(GL_MODELVIEW_MATRIX, 14)[13], -2);
}

TEST_F(Get, FloatsBeyondTheIntegersBecomeTheNearestOne) {
    gl.Fogf(GL_FOG_START, 1e20f);
    EXPECT_EQ(integer(GL_FOG_START), kLargest);
    gl.Fogf(GL_FOG_START, -1e20f);
    EXPECT_EQ(integer(GL_FOG_START), kSmallest);
    gl.Fogf(GL_FOG_START, __builtin_nanf(""));
    EXPECT_EQ(integer(GL_FOG_START), 0);
}

TEST_F(Get, ColoursAndDepthsAreScaledToTheRangeOfIntegers) {
    gl.ClearColor(1, 0.5f, 0, 0.25f);
    // ((2^32 - 1) c - 1) / 2, to the nearest (GL 1.5 table 4.9).
    EXPECT_EQ(integers(GL_COLOR_CLEAR_VALUE, 4), (std::vector<GLint>{kLargest, 1073741823, 0, 536870911}));
    gl.DepthRange(1, 0);
    EXPECT_EQ(integers(GL_DEPTH_RANGE, 2), (std::vector<GLint>{kLargest, 0}));
    EXPECT_EQ(integer(GL_DEPTH_CLEAR_VALUE), kLargest);
    gl.ClearAccum(-1, 1, -0.5f, 0);
    EXPECT_EQ(integers(GL_ACCUM_CLEAR_VALUE, 4), (std::vector<GLint>{kSmallest, kLargest, -1073741824, 0}));
    gl.AlphaFunc(GL_LESS, 1);
    EXPECT_EQ(integer(GL_ALPHA_TEST_REF), kLargest);
    const GLfloat ambient[4] = {-1, 1, 0, 0};
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    EXPECT_EQ(integers(GL_LIGHT_MODEL_AMBIENT, 2), (std::vector<GLint>{kSmallest, kLargest}));
}

TEST_F(Get, AnythingButZeroIsTrue) {
    EXPECT_EQ(boolean(GL_FOG_START), GL_FALSE);
    gl.Fogf(GL_FOG_START, 1e-30f);
    EXPECT_EQ(boolean(GL_FOG_START), GL_TRUE);
    EXPECT_EQ(boolean(GL_FOG_MODE), GL_TRUE);
    EXPECT_EQ(boolean(GL_STENCIL_REF), GL_FALSE);
}

TEST_F(Get, BooleansAndCapabilitiesAreNumbersToo) {
    EXPECT_EQ(integer(GL_DEPTH_WRITEMASK), 1);
    gl.DepthMask(GL_FALSE);
    EXPECT_EQ(integer(GL_DEPTH_WRITEMASK), 0);
    gl.Enable(GL_FOG);
    EXPECT_EQ(integer(GL_FOG), 1);
    EXPECT_EQ(floats(GL_FOG, 1)[0], 1.0f);
    gl.ColorMask(0, 255, 1, 0);  // any true is GL_TRUE
    EXPECT_EQ(integers(GL_COLOR_WRITEMASK, 4), (std::vector<GLint>{0, 1, 1, 0}));
}

TEST_F(Get, IntegersOfParametersFollowTheSameRules) {
    const GLfloat diffuse[4] = {1, -1, 0.5f, 0};
    gl.Lightfv(GL_LIGHT2, GL_DIFFUSE, diffuse);
    GLint values[4];
    gl.GetLightiv(GL_LIGHT2, GL_DIFFUSE, values);
    EXPECT_EQ(std::vector(values, values + 4), (std::vector<GLint>{kLargest, kSmallest, 1073741823, 0}));
    const GLfloat position[4] = {1.6f, -1.6f, 0, 1};
    gl.Lightfv(GL_LIGHT2, GL_POSITION, position);
    gl.GetLightiv(GL_LIGHT2, GL_POSITION, values);
    EXPECT_EQ(std::vector(values, values + 4), (std::vector<GLint>{2, -2, 0, 1}));
}

TEST_F(Get, ParametersGivenAsIntegersAreColoursOrNumbers) {
    const GLint color[4] = {kLargest, kSmallest, 0, kLargest};
    gl.Fogiv(GL_FOG_COLOR, color);
    EXPECT_EQ(floats(GL_FOG_COLOR, 4), (std::vector<GLfloat>{1, 0, 0x1p-32f, 1}));  // clamped to 0..1
    gl.Fogi(GL_FOG_START, -7);
    EXPECT_EQ(floats(GL_FOG_START, 1)[0], -7.0f);
    const GLint position[4] = {1, 2, 3, 0};
    gl.Lightiv(GL_LIGHT0, GL_POSITION, position);
    GLfloat eye[4];
    gl.GetLightfv(GL_LIGHT0, GL_POSITION, eye);
    EXPECT_EQ(std::vector(eye, eye + 4), (std::vector<GLfloat>{1, 2, 3, 0}));
}

TEST_F(Get, ValuesAreClampedWhereTheSpecificationSaysSo) {
    gl.DepthRange(-1, 2);
    EXPECT_EQ(floats(GL_DEPTH_RANGE, 2), (std::vector<GLfloat>{0, 1}));
    gl.ClearDepth(3);
    EXPECT_EQ(floats(GL_DEPTH_CLEAR_VALUE, 1)[0], 1);
    gl.ClearColor(-1, 2, 0.5f, 1);
    EXPECT_EQ(floats(GL_COLOR_CLEAR_VALUE, 4), (std::vector<GLfloat>{0, 1, 0.5f, 1}));
    gl.ClearAccum(-2, 2, 0, 0);
    EXPECT_EQ(floats(GL_ACCUM_CLEAR_VALUE, 2), (std::vector<GLfloat>{-1, 1}));
    gl.AlphaFunc(GL_LESS, -3);
    EXPECT_EQ(floats(GL_ALPHA_TEST_REF, 1)[0], 0);
    gl.LineStipple(0, 0xaaaa);
    EXPECT_EQ(integer(GL_LINE_STIPPLE_REPEAT), 1);
    gl.LineStipple(1000, 0xaaaa);
    EXPECT_EQ(integer(GL_LINE_STIPPLE_REPEAT), 256);
    gl.StencilFunc(GL_EQUAL, 300, ~0u);
    EXPECT_EQ(integer(GL_STENCIL_REF), 255);
    gl.Viewport(0, 0, 100000, 100000);
    EXPECT_EQ(integers(GL_VIEWPORT, 4), (std::vector<GLint>{0, 0, 16384, 16384}));
}

TEST_F(Get, PositionsAndPlanesAreInEyeCoordinates) {
    gl.Translatef(10, 20, 30);
    gl.Scalef(2, 2, 2);
    const GLfloat position[4] = {1, 1, 1, 1}, direction[3] = {1, 0, 0};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    gl.LoadIdentity();
    GLfloat values[4];
    gl.GetLightfv(GL_LIGHT0, GL_POSITION, values);
    EXPECT_EQ(std::vector(values, values + 4), (std::vector<GLfloat>{12, 22, 32, 1}));
    gl.GetLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, values);
    EXPECT_EQ(std::vector(values, values + 3), (std::vector<GLfloat>{2, 0, 0}));

    gl.Translatef(0, 0, -5);
    const GLdouble plane[4] = {0, 0, 1, 0};  // z >= 0 in object coordinates is z >= -5 for the eye
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    GLdouble equation[4];
    gl.GetClipPlane(GL_CLIP_PLANE0, equation);
    EXPECT_EQ(std::vector(equation, equation + 4), (std::vector<GLdouble>{0, 0, 1, 5}));
    const GLfloat s_plane[4] = {0, 0, 1, 0};
    gl.TexGenfv(GL_S, GL_EYE_PLANE, s_plane);
    gl.TexGenfv(GL_S, GL_OBJECT_PLANE, s_plane);
    gl.GetTexGenfv(GL_S, GL_EYE_PLANE, values);
    EXPECT_EQ(std::vector(values, values + 4), (std::vector<GLfloat>{0, 0, 1, 5}));
    gl.GetTexGenfv(GL_S, GL_OBJECT_PLANE, values);
    EXPECT_EQ(std::vector(values, values + 4), (std::vector<GLfloat>{0, 0, 1, 0}));
}

TEST_F(Get, EachPointerIsItsArrays) {
    const GLubyte memory[16] = {};
    gl.VertexPointer(3, GL_FLOAT, 0, memory + 1);
    gl.NormalPointer(GL_FLOAT, 0, memory + 2);
    gl.ColorPointer(4, GL_FLOAT, 0, memory + 3);
    gl.SecondaryColorPointer(3, GL_FLOAT, 0, memory + 4);
    gl.FogCoordPointer(GL_FLOAT, 0, memory + 5);
    gl.IndexPointer(GL_FLOAT, 0, memory + 6);
    gl.TexCoordPointer(2, GL_FLOAT, 0, memory + 7);
    gl.EdgeFlagPointer(0, memory + 8);
    gl.ClientActiveTexture(GL_TEXTURE5);
    gl.TexCoordPointer(2, GL_FLOAT, 0, memory + 9);
    const auto offset = [&](GLenum name) {
        void* pointer = nullptr;
        gl.GetPointerv(name, &pointer);
        return static_cast<const GLubyte*>(pointer) - memory;
    };
    EXPECT_EQ(offset(GL_VERTEX_ARRAY_POINTER), 1);
    EXPECT_EQ(offset(GL_NORMAL_ARRAY_POINTER), 2);
    EXPECT_EQ(offset(GL_COLOR_ARRAY_POINTER), 3);
    EXPECT_EQ(offset(GL_SECONDARY_COLOR_ARRAY_POINTER), 4);
    EXPECT_EQ(offset(GL_FOG_COORDINATE_ARRAY_POINTER), 5);
    EXPECT_EQ(offset(GL_INDEX_ARRAY_POINTER), 6);
    EXPECT_EQ(offset(GL_EDGE_FLAG_ARRAY_POINTER), 8);
    EXPECT_EQ(offset(GL_TEXTURE_COORD_ARRAY_POINTER), 9);
    gl.ClientActiveTexture(GL_TEXTURE0);
    EXPECT_EQ(offset(GL_TEXTURE_COORD_ARRAY_POINTER), 7);
}

TEST_F(Get, SizeOfAnArrayWithBlueFirstIsItsOrder) {
    EXPECT_EQ(integer(GL_COLOR_ARRAY_SIZE), 4);
    gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, nullptr);
    EXPECT_EQ(integer(GL_COLOR_ARRAY_SIZE), GL_BGRA);
    gl.SecondaryColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, nullptr);
    EXPECT_EQ(integer(GL_SECONDARY_COLOR_ARRAY_SIZE), GL_BGRA);
    gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, nullptr);
    EXPECT_EQ(integer(GL_COLOR_ARRAY_SIZE), 3);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(Get, PolygonStippleComesBackAsItWasGiven) {
    std::vector<GLubyte> pattern(128), read(128);
    for (std::size_t i = 0; i < pattern.size(); ++i) pattern[i] = static_cast<GLubyte>(i * 37 + 11);
    gl.PolygonStipple(pattern.data());
    gl.GetPolygonStipple(read.data());
    EXPECT_EQ(read, pattern);
}

}  // namespace
}  // namespace terrazzo::test
