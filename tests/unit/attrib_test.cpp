// The attribute stacks: each bit saves its group and nothing else (GL 1.5 §6.1.14, tables 6.5-6.30).
#include <gmock/gmock.h>

#include <functional>

#include "state_fixture.h"

namespace terrazzo::test {
namespace {

using testing::IsEmpty;

struct Group {
    GLbitfield bit;
    const char* name;
    std::function<void(const kit::Gl& gl)> change;  // every value that the bit saves
};

const GLfloat kColor[4] = {0.1f, 0.2f, 0.3f, 0.4f};
const GLdouble kPlane[4] = {1, 2, 3, 4};

// Without GL_COLOR_MATERIAL: enabling it also sets the materials, which this bit does not save.
void change_enables(const kit::Gl& gl) {
    for (GLenum capability : {GL_ALPHA_TEST,
                              GL_BLEND,
                              GL_CLIP_PLANE0,
                              GL_CLIP_PLANE5,
                              GL_COLOR_SUM,
                              GL_COLOR_LOGIC_OP,
                              GL_CULL_FACE,
                              GL_DEPTH_TEST,
                              GL_FOG,
                              GL_INDEX_LOGIC_OP,
                              GL_LIGHT0,
                              GL_LIGHT7,
                              GL_LIGHTING,
                              GL_LINE_SMOOTH,
                              GL_LINE_STIPPLE,
                              GL_NORMALIZE,
                              GL_POINT_SMOOTH,
                              GL_POINT_SPRITE,
                              GL_POLYGON_OFFSET_FILL,
                              GL_POLYGON_OFFSET_LINE,
                              GL_POLYGON_OFFSET_POINT,
                              GL_POLYGON_SMOOTH,
                              GL_POLYGON_STIPPLE,
                              GL_STENCIL_TEST_TWO_SIDE_EXT,
                              GL_RESCALE_NORMAL,
                              GL_SCISSOR_TEST,
                              GL_STENCIL_TEST,
                              GL_TEXTURE_1D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_GEN_S,
                              GL_TEXTURE_GEN_T,
                              GL_TEXTURE_GEN_R,
                              GL_TEXTURE_GEN_Q}) {
        gl.Enable(capability);
    }
    gl.Disable(GL_DITHER);
}

void change_lighting(const kit::Gl& gl) {
    gl.ShadeModel(GL_FLAT);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT7);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, kColor);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    for (GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION}) {
        gl.Lightfv(GL_LIGHT1, pname, kColor);
    }
    gl.Lightf(GL_LIGHT7, GL_SPOT_EXPONENT, 2);
    gl.Lightf(GL_LIGHT7, GL_SPOT_CUTOFF, 45);
    gl.Lightf(GL_LIGHT7, GL_LINEAR_ATTENUATION, 3);
    for (GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_COLOR_INDEXES}) {
        gl.Materialfv(GL_FRONT_AND_BACK, pname, kColor);
    }
    gl.Materialf(GL_BACK, GL_SHININESS, 5);
    gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
    gl.Enable(GL_COLOR_MATERIAL);
}

void change_texture(const kit::Gl& gl) {
    gl.Enable(GL_TEXTURE_1D);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_TEXTURE_GEN_S);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, kColor);
    gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 2);
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 3);
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, GL_TEXTURE3);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_ONE_MINUS_SRC_ALPHA);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 4);
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    gl.TexGenfv(GL_R, GL_OBJECT_PLANE, kColor);
    gl.TexGenfv(GL_Q, GL_EYE_PLANE, kColor);
}

const Group kGroups[] = {
    {GL_ACCUM_BUFFER_BIT, "accum buffer", [](auto& gl) { gl.ClearAccum(0.1f, 0.2f, 0.3f, 0.4f); }},
    {GL_COLOR_BUFFER_BIT, "color buffer",
     [](auto& gl) {
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_LESS, 0.5f);
         gl.Enable(GL_BLEND);
         gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
         gl.Disable(GL_DITHER);
         gl.DrawBuffer(GL_NONE);
         gl.Enable(GL_COLOR_LOGIC_OP);
         gl.Enable(GL_INDEX_LOGIC_OP);
         gl.LogicOp(GL_XOR);
         gl.ColorMask(0, 1, 0, 1);
         gl.IndexMask(7);
         gl.ClearColor(0.1f, 0.2f, 0.3f, 0.4f);
         gl.ClearIndex(3);
     }},
    {GL_DEPTH_BUFFER_BIT, "depth buffer",
     [](auto& gl) {
         gl.Enable(GL_DEPTH_TEST);
         gl.DepthFunc(GL_ALWAYS);
         gl.DepthMask(GL_FALSE);
         gl.ClearDepth(0.25);
     }},
    {GL_ENABLE_BIT, "enable", change_enables},
    {GL_FOG_BIT, "fog",
     [](auto& gl) {
         gl.Enable(GL_FOG);
         gl.Fogi(GL_FOG_MODE, GL_LINEAR);
         gl.Fogf(GL_FOG_DENSITY, 2);
         gl.Fogf(GL_FOG_START, 3);
         gl.Fogf(GL_FOG_END, 4);
         gl.Fogf(GL_FOG_INDEX, 5);
         gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
         gl.Enable(GL_COLOR_SUM);
         gl.Fogfv(GL_FOG_COLOR, kColor);
     }},
    {GL_HINT_BIT, "hint",
     [](auto& gl) {
         for (GLenum hint : {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
                             GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT}) {
             gl.Hint(hint, GL_NICEST);
         }
     }},
    {GL_LIGHTING_BIT, "lighting", change_lighting},
    {GL_LINE_BIT, "line",
     [](auto& gl) {
         gl.LineWidth(3);
         gl.Enable(GL_LINE_SMOOTH);
         gl.Enable(GL_LINE_STIPPLE);
         gl.LineStipple(7, 0x1234);
     }},
    {GL_LIST_BIT, "list", [](auto& gl) { gl.ListBase(9); }},
    {GL_MULTISAMPLE_BIT, "multisample",
     [](auto& gl) {
         gl.Disable(GL_MULTISAMPLE);
         gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
         gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
         gl.Enable(GL_SAMPLE_COVERAGE);
         gl.SampleCoverage(0.5f, GL_TRUE);
     }},
    {GL_PIXEL_MODE_BIT, "pixel mode", [](auto& gl) { gl.ReadBuffer(GL_LEFT); }},
    {GL_POINT_BIT, "point",
     [](auto& gl) {
         gl.PointSize(3);
         gl.Enable(GL_POINT_SPRITE);
         gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
         gl.PointParameterf(GL_POINT_SIZE_MIN, 2);
         gl.PointParameterf(GL_POINT_SIZE_MAX, 4);
         gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3);
         gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, kColor);
         gl.Enable(GL_POINT_SMOOTH);
     }},
    {GL_POLYGON_BIT, "polygon",
     [](auto& gl) {
         gl.Enable(GL_CULL_FACE);
         gl.CullFace(GL_FRONT);
         gl.FrontFace(GL_CW);
         gl.PolygonMode(GL_FRONT, GL_LINE);
         gl.PolygonMode(GL_BACK, GL_POINT);
         gl.Enable(GL_POLYGON_SMOOTH);
         gl.Enable(GL_POLYGON_STIPPLE);
         gl.PolygonOffset(1, 2);
         gl.Enable(GL_POLYGON_OFFSET_FILL);
         gl.Enable(GL_POLYGON_OFFSET_LINE);
         gl.Enable(GL_POLYGON_OFFSET_POINT);
     }},
    {GL_POLYGON_STIPPLE_BIT, "polygon stipple",
     [](auto& gl) {
         const GLubyte pattern[128] = {0x55};
         gl.PolygonStipple(pattern);
     }},
    {GL_SCISSOR_BIT, "scissor",
     [](auto& gl) {
         gl.Enable(GL_SCISSOR_TEST);
         gl.Scissor(1, 2, 3, 4);
     }},
    {GL_STENCIL_BUFFER_BIT, "stencil buffer",
     [](auto& gl) {
         gl.Enable(GL_STENCIL_TEST);
         gl.ActiveStencilFaceEXT(GL_FRONT);
         gl.StencilFunc(GL_LESS, 3, 0x0f);
         gl.StencilOp(GL_INCR, GL_DECR, GL_INVERT);
         gl.StencilMask(0x77);
         gl.StencilFuncSeparateATI(GL_GREATER, GL_NOTEQUAL, 4, 0x1f);
         gl.StencilOpSeparateATI(GL_BACK, GL_ZERO, GL_REPLACE, GL_DECR);
         gl.ActiveStencilFaceEXT(GL_BACK);
         gl.StencilMask(0x55);
         gl.Enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
         gl.ClearStencil(5);
     }},
    {GL_TEXTURE_BIT, "texture", change_texture},
    {GL_TRANSFORM_BIT, "transform",
     [](auto& gl) {
         gl.MatrixMode(GL_TEXTURE);
         gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
         gl.ClipPlane(GL_CLIP_PLANE1, kPlane);
         gl.Enable(GL_CLIP_PLANE1);
         gl.Enable(GL_NORMALIZE);
         gl.Enable(GL_RESCALE_NORMAL);
     }},
    {GL_VIEWPORT_BIT, "viewport",
     [](auto& gl) {
         gl.Viewport(1, 2, 3, 4);
         gl.DepthRange(0.25, 0.75);
     }},
};

class Attrib : public StateTest {};

TEST_F(Attrib, EachBitRestoresItsGroup) {
    const auto before = dump();
    for (const Group& group : kGroups) {
        gl.PushAttrib(group.bit);
        group.change(gl);
        EXPECT_FALSE(changed(before, dump()).empty()) << group.name;
        gl.PopAttrib();
        EXPECT_THAT(changed(before, dump()), IsEmpty()) << group.name;
    }
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(Attrib, EachBitLeavesTheOtherGroupsAlone) {
    for (const Group& group : kGroups) {
        const kit::OffscreenContext fresh(library(), {});
        gl.PushAttrib(group.bit);
        // Capabilities are saved by two bits each; what a group shares with GL_ENABLE_BIT is restored.
        for (const Group& other : kGroups) {
            if (other.bit != group.bit && other.bit != GL_ENABLE_BIT && group.bit != GL_ENABLE_BIT)
                other.change(gl);
        }
        gl.PopAttrib();
        const auto popped = dump();
        for (const Group& other : kGroups) {
            if (other.bit != group.bit && other.bit != GL_ENABLE_BIT && group.bit != GL_ENABLE_BIT)
                other.change(gl);
        }
        EXPECT_THAT(changed(popped, dump()), IsEmpty()) << group.name;  // they had all kept their changes
    }
}

TEST_F(Attrib, EnableBitSavesCapabilitiesAndNothingElse) {
    gl.PushAttrib(GL_ENABLE_BIT);
    change_enables(gl);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
    gl.PopAttrib();
    EXPECT_FALSE(gl.IsEnabled(GL_BLEND));
    EXPECT_TRUE(gl.IsEnabled(GL_DITHER));
    gl.PushAttrib(GL_ENABLE_BIT);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.PopAttrib();
    EXPECT_FALSE(gl.IsEnabled(GL_COLOR_MATERIAL));
    EXPECT_EQ(integer(GL_BLEND_SRC), GL_SRC_ALPHA);
}

TEST_F(Attrib, EveryUnitIsSaved) {
    const auto unit_state = [&](GLenum unit) {
        gl.ActiveTexture(unit);
        const auto state = dump();
        gl.ActiveTexture(GL_TEXTURE0);
        return state;
    };
    const auto first = unit_state(GL_TEXTURE0), last = unit_state(GL_TEXTURE7);
    gl.PushAttrib(GL_TEXTURE_BIT);
    for (GLenum unit : {GL_TEXTURE0, GL_TEXTURE7}) {
        gl.ActiveTexture(unit);
        change_texture(gl);
    }
    gl.PopAttrib();
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE0);
    EXPECT_THAT(changed(first, unit_state(GL_TEXTURE0)), IsEmpty());
    EXPECT_THAT(changed(last, unit_state(GL_TEXTURE7)), IsEmpty());
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.ClientActiveTexture(GL_TEXTURE7);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.PopClientAttrib();
    EXPECT_EQ(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE0);
    gl.ClientActiveTexture(GL_TEXTURE7);
    EXPECT_FALSE(gl.IsEnabled(GL_TEXTURE_COORD_ARRAY));
}

TEST_F(Attrib, NestedEntriesAreIndependent) {
    gl.PushAttrib(GL_FOG_BIT);
    gl.Fogf(GL_FOG_START, 2);
    gl.PushAttrib(GL_HINT_BIT);
    gl.Fogf(GL_FOG_START, 3);
    gl.PopAttrib();
    EXPECT_EQ(integer(GL_FOG_START), 3);  // the inner entry had not saved it
    gl.PopAttrib();
    EXPECT_EQ(integer(GL_FOG_START), 0);
}

TEST_F(Attrib, MatricesAreNotAttributes) {
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    gl.Translatef(1, 2, 3);
    gl.PopAttrib();
    GLfloat matrix[16];
    gl.GetFloatv(GL_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 1);
}

TEST_F(Attrib, EveryGroupAtOnce) {
    const auto before = dump();
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    for (const Group& group : kGroups) group.change(gl);
    gl.PopAttrib();
    EXPECT_THAT(changed(before, dump()), IsEmpty());
}

// A material keeps the last colour that it followed, whichever way it ceases to follow.
TEST_F(Attrib, PoppedColorMaterialLeavesTheLastColor) {
    const auto diffuse = [&] {
        GLfloat color[4] = {};
        gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, color);
        return color[0];
    };
    gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
    gl.Color4f(0.25f, 0, 0, 1);
    gl.PushAttrib(GL_ENABLE_BIT);
    gl.Enable(GL_COLOR_MATERIAL);
    EXPECT_EQ(diffuse(), 0.25f);
    gl.Color4f(0.5f, 0, 0, 1);
    gl.PopAttrib();
    EXPECT_EQ(diffuse(), 0.5f);
    gl.Color4f(0.75f, 0, 0, 1);
    EXPECT_EQ(diffuse(), 0.5f);
    gl.PushAttrib(GL_LIGHTING_BIT);
    gl.Enable(GL_COLOR_MATERIAL);
    EXPECT_EQ(diffuse(), 0.75f);
    gl.PopAttrib();
    EXPECT_EQ(diffuse(), 0.5f);
}

}  // namespace
}  // namespace terrazzo::test
