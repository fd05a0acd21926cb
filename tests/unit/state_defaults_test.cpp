// The initial values of GL 1.5 tables 6.5-6.30, and the minimum limits of tables 6.31-6.35.
#include "state_fixture.h"

namespace terrazzo::test {
namespace {

using StateDefaults = StateTest;

struct Default {
    GLenum name;
    std::vector<double> values;
};

const std::vector<double> kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// Size of the context's buffer: StateTest's.
const Default kDefaults[] = {
    {GL_MODELVIEW_MATRIX, kIdentity},
    {GL_PROJECTION_MATRIX, kIdentity},
    {GL_TEXTURE_MATRIX, kIdentity},
    {GL_MODELVIEW_STACK_DEPTH, {1}},
    {GL_PROJECTION_STACK_DEPTH, {1}},
    {GL_TEXTURE_STACK_DEPTH, {1}},
    {GL_MATRIX_MODE, {GL_MODELVIEW}},
    {GL_VIEWPORT, {0, 0, 64, 32}},
    {GL_DEPTH_RANGE, {0, 1}},
    {GL_FOG_MODE, {GL_EXP}},
    {GL_FOG_COLOR, {0, 0, 0, 0}},
    {GL_FOG_DENSITY, {1}},
    {GL_FOG_START, {0}},
    {GL_FOG_END, {1}},
    {GL_FOG_INDEX, {0}},
    {GL_SHADE_MODEL, {GL_SMOOTH}},
    {GL_COLOR_MATERIAL_FACE, {GL_FRONT_AND_BACK}},
    {GL_COLOR_MATERIAL_PARAMETER, {GL_AMBIENT_AND_DIFFUSE}},
    {GL_LIGHT_MODEL_AMBIENT, {0.2f, 0.2f, 0.2f, 1}},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, {0}},
    {GL_LIGHT_MODEL_TWO_SIDE, {0}},
    {GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR}},
    {GL_POINT_SIZE, {1}},
    {GL_LINE_WIDTH, {1}},
    {GL_LINE_STIPPLE_PATTERN, {0xffff}},
    {GL_LINE_STIPPLE_REPEAT, {1}},
    {GL_CULL_FACE_MODE, {GL_BACK}},
    {GL_FRONT_FACE, {GL_CCW}},
    {GL_POLYGON_MODE, {GL_FILL, GL_FILL}},
    {GL_POLYGON_OFFSET_FACTOR, {0}},
    {GL_POLYGON_OFFSET_UNITS, {0}},
    {GL_TEXTURE_BINDING_1D, {0}},
    {GL_TEXTURE_BINDING_2D, {0}},
    {GL_SCISSOR_BOX, {0, 0, 64, 32}},
    {GL_ALPHA_TEST_FUNC, {GL_ALWAYS}},
    {GL_ALPHA_TEST_REF, {0}},
    {GL_STENCIL_FUNC, {GL_ALWAYS}},
    {GL_STENCIL_VALUE_MASK, {0xff}},
    {GL_STENCIL_REF, {0}},
    {GL_STENCIL_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_PASS, {GL_KEEP}},
    {GL_STENCIL_BACK_FUNC, {GL_ALWAYS}},
    {GL_STENCIL_BACK_VALUE_MASK, {0xff}},
    {GL_STENCIL_BACK_REF, {0}},
    {GL_STENCIL_BACK_FAIL, {GL_KEEP}},
    {GL_STENCIL_BACK_PASS_DEPTH_FAIL, {GL_KEEP}},
    {GL_STENCIL_BACK_PASS_DEPTH_PASS, {GL_KEEP}},
    {GL_STENCIL_BACK_WRITEMASK, {0xff}},
    {GL_ACTIVE_STENCIL_FACE_EXT, {GL_FRONT}},
    {GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, {0}},
    {GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, {0}},
    {GL_DEPTH_FUNC, {GL_LESS}},
    {GL_BLEND_SRC, {GL_ONE}},
    {GL_BLEND_DST, {GL_ZERO}},
    {GL_LOGIC_OP_MODE, {GL_COPY}},
    {GL_DRAW_BUFFER, {GL_FRONT}},
    {GL_READ_BUFFER, {GL_FRONT}},
    {GL_COLOR_WRITEMASK, {1, 1, 1, 1}},
    {GL_DEPTH_WRITEMASK, {1}},
    {GL_STENCIL_WRITEMASK, {0xff}},
    {GL_COLOR_CLEAR_VALUE, {0, 0, 0, 0}},
    {GL_DEPTH_CLEAR_VALUE, {1}},
    {GL_STENCIL_CLEAR_VALUE, {0}},
    {GL_ACCUM_CLEAR_VALUE, {0, 0, 0, 0}},
    {GL_PACK_ALIGNMENT, {4}},
    {GL_UNPACK_ALIGNMENT, {4}},
    {GL_UNPACK_ROW_LENGTH, {0}},
    {GL_RED_SCALE, {1}},
    {GL_ALPHA_BIAS, {0}},
    {GL_DEPTH_SCALE, {1}},
    {GL_ZOOM_X, {1}},
    {GL_FOG_HINT, {GL_DONT_CARE}},
    {GL_LIST_BASE, {0}},
    {GL_LIST_INDEX, {0}},
    {GL_LIST_MODE, {0}},
    {GL_ATTRIB_STACK_DEPTH, {0}},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, {0}},
    {GL_RENDER_MODE, {GL_RENDER}},
    {GL_RGBA_MODE, {1}},
    {GL_DOUBLEBUFFER, {0}},
};

TEST_F(StateDefaults, AreThoseOfTheSpecification) {
    for (const Default& expected : kDefaults) {
        GLdouble values[16];
        gl.GetDoublev(expected.name, values);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR}) << std::hex << expected.name;
        EXPECT_EQ(std::vector(values, values + expected.values.size()), expected.values)
            << std::hex << expected.name;
    }
}

TEST_F(StateDefaults, OnlyDitheringIsEnabled) {
    for (GLenum capability : {GL_ALPHA_TEST,
                              GL_BLEND,
                              GL_CLIP_PLANE0,
                              GL_CLIP_PLANE5,
                              GL_COLOR_LOGIC_OP,
                              GL_COLOR_MATERIAL,
                              GL_CULL_FACE,
                              GL_DEPTH_TEST,
                              GL_FOG,
                              GL_LIGHT0,
                              GL_LIGHT7,
                              GL_LIGHTING,
                              GL_LINE_SMOOTH,
                              GL_LINE_STIPPLE,
                              GL_NORMALIZE,
                              GL_POINT_SMOOTH,
                              GL_POLYGON_SMOOTH,
                              GL_POLYGON_STIPPLE,
                              GL_POLYGON_OFFSET_FILL,
                              GL_SCISSOR_TEST,
                              GL_STENCIL_TEST,
                              GL_TEXTURE_1D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_GEN_S,
                              GL_TEXTURE_GEN_Q}) {
        EXPECT_FALSE(gl.IsEnabled(capability)) << std::hex << capability;
    }
    EXPECT_TRUE(gl.IsEnabled(GL_DITHER));
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(StateDefaults, TheFirstLightIsWhiteAndTheOthersAreBlack) {
    for (int light = 0; light < 8; ++light) {
        GLfloat diffuse[4], position[4], direction[3], cutoff;
        gl.GetLightfv(GL_LIGHT0 + light, GL_DIFFUSE, diffuse);
        gl.GetLightfv(GL_LIGHT0 + light, GL_POSITION, position);
        gl.GetLightfv(GL_LIGHT0 + light, GL_SPOT_DIRECTION, direction);
        gl.GetLightfv(GL_LIGHT0 + light, GL_SPOT_CUTOFF, &cutoff);
        EXPECT_EQ(diffuse[0], light == 0 ? 1 : 0);
        EXPECT_EQ(diffuse[3], 1);
        EXPECT_EQ(std::vector(position, position + 4), (std::vector<GLfloat>{0, 0, 1, 0}));
        EXPECT_EQ(std::vector(direction, direction + 3), (std::vector<GLfloat>{0, 0, -1}));
        EXPECT_EQ(cutoff, 180);
    }
}

TEST_F(StateDefaults, MaterialsOfBothFaces) {
    for (GLenum face : {GL_FRONT, GL_BACK}) {
        GLfloat ambient[4], diffuse[4], indexes[3], shininess = -1;
        gl.GetMaterialfv(face, GL_AMBIENT, ambient);
        gl.GetMaterialfv(face, GL_DIFFUSE, diffuse);
        gl.GetMaterialfv(face, GL_COLOR_INDEXES, indexes);
        gl.GetMaterialfv(face, GL_SHININESS, &shininess);
        EXPECT_EQ(std::vector(ambient, ambient + 4), (std::vector<GLfloat>{0.2f, 0.2f, 0.2f, 1}));
        EXPECT_EQ(std::vector(diffuse, diffuse + 4), (std::vector<GLfloat>{0.8f, 0.8f, 0.8f, 1}));
        EXPECT_EQ(std::vector(indexes, indexes + 3), (std::vector<GLfloat>{0, 1, 1}));
        EXPECT_EQ(shininess, 0);
    }
}

TEST_F(StateDefaults, LimitsReachTheMinimumOfTheSpecification) {
    struct Minimum {
        GLenum name;
        GLint value;
    };
    for (const auto& [name, value] :
         {Minimum{GL_MAX_LIGHTS, 8}, Minimum{GL_MAX_CLIP_PLANES, 6},
          Minimum{GL_MAX_MODELVIEW_STACK_DEPTH, 32}, Minimum{GL_MAX_PROJECTION_STACK_DEPTH, 2},
          Minimum{GL_MAX_TEXTURE_STACK_DEPTH, 2}, Minimum{GL_SUBPIXEL_BITS, 4},
          Minimum{GL_MAX_TEXTURE_SIZE, 64}, Minimum{GL_MAX_PIXEL_MAP_TABLE, 32},
          Minimum{GL_MAX_NAME_STACK_DEPTH, 64}, Minimum{GL_MAX_LIST_NESTING, 64},
          Minimum{GL_MAX_ATTRIB_STACK_DEPTH, 16}, Minimum{GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 16}}) {
        EXPECT_GE(integer(name), value) << std::hex << name;
    }
    GLint size[2] = {};
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, size);
    EXPECT_GE(size[0], 16384);
    EXPECT_GE(size[1], 16384);
}

TEST_F(StateDefaults, TheStringsName) {
    for (GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS}) {
        EXPECT_NE(gl.GetString(name), nullptr) << std::hex << name;
    }
    EXPECT_EQ(gl.GetString(GL_LIGHT0), nullptr);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
}

}  // namespace
}  // namespace terrazzo::test
