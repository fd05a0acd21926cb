// What bitmaps and pixel rectangles get from the current raster position, where the reference does other than
// GL 1.5 says and no comparison can tell (§3.6.4, §3.6.5, §3.7, §4.3.3).
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gmock/gmock.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr int kSize = 16;
using Pixel = std::array<GLubyte, 4>;

class PixelRects : public GlTest {
  protected:
    PixelRects() {
        attach_picture(ctx(), kSize, kSize);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    }

    static Pixel pixel(int x, int y) {
        Pixel out;
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
        return out;
    }
    static GLuint depth(int x, int y) {
        GLuint out;
        glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &out);
        return out;
    }
    static GLubyte stencil(int x, int y) {
        GLubyte out;
        glReadPixels(x, y, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &out);
        return out;
    }
};

constexpr GLubyte kAll[4] = {0xf0, 0xf0, 0xf0, 0xf0};  // 4x4 set pixels

TEST_F(PixelRects, BitmapsAreFoggedByTheDistanceOfTheRasterPosition) {
    const GLfloat fog[4] = {0, 0, 1, 1};
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 0);
    glFogf(GL_FOG_END, 1);
    glFogfv(GL_FOG_COLOR, fog);
    glEnable(GL_FOG);
    glColor3f(1, 0, 0);
    glRasterPos3f(0, 0, -0.2f);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    EXPECT_THAT(pixel(9, 9), ElementsAre(204, 0, 51, 255));
}

TEST_F(PixelRects, TexturesAreSampledAtTheCoordinatesOfTheRasterPosition) {
    const GLubyte texels[8] = {255, 0, 0, 255, 0, 255, 0, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glTexCoord4f(1.5f, 1, 0, 2);  // projected to 0.75
    glRasterPos2f(0, 0);
    glTexCoord2f(0, 0);  // not what counts
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    EXPECT_THAT(pixel(8, 8), ElementsAre(0, 255, 0, 255));
    const std::vector<GLubyte> gray(4 * 4, 128);
    glDrawPixels(4, 4, GL_LUMINANCE, GL_UNSIGNED_BYTE, gray.data());
    EXPECT_THAT(pixel(8, 8), ElementsAre(0, 128, 0, 255));
}

// Nothing but the raster position changes from bitmap to bitmap.
TEST_F(PixelRects, CoordinatesOfBitmapsMayProjectOrNot) {
    const GLubyte texels[4][4] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_1D);
    const auto expect_texel = [&](GLfloat s, GLfloat q, int texel) {
        glTexCoord4f(s, 0, 0, q);
        glRasterPos2f(0, 0);
        glBitmap(4, 4, 0, 0, 0, 0, kAll);
        EXPECT_THAT(pixel(9, 9), testing::ElementsAreArray(texels[texel])) << s << " / " << q;
    };
    for (int round = 0; round < 2; ++round) {
        expect_texel(0.6f, 1, 2);
        expect_texel(0.6f, 2, 1);
        expect_texel(0.6f, 4, 0);
        expect_texel(0.9f, 1, 3);
    }
}

TEST_F(PixelRects, EveryUnitTexturesBitmapsAtItsCoordinates) {
    const GLubyte texels[8] = {255, 0, 0, 255, 0, 255, 255, 255};
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
        glActiveTexture(unit);
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_1D, texture);
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit == GL_TEXTURE0 ? GL_REPLACE : GL_ADD);
        glEnable(GL_TEXTURE_1D);
    }
    const auto draw = [](float first, float second) {
        glMultiTexCoord1f(GL_TEXTURE0, first);
        glMultiTexCoord1f(GL_TEXTURE1, second);
        glRasterPos2f(0, 0);
        glBitmap(4, 4, 0, 0, 0, 0, kAll);
        return pixel(9, 9);
    };
    EXPECT_THAT(draw(0.25f, 0.25f), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(draw(0.75f, 0.75f), ElementsAre(0, 255, 255, 255));
    EXPECT_THAT(draw(0.25f, 0.75f), ElementsAre(255, 255, 255, 255));
    glNewList(1, GL_COMPILE);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    glEndList();
    glMultiTexCoord1f(GL_TEXTURE0, 0.75f);
    glMultiTexCoord1f(GL_TEXTURE1, 0.75f);
    glRasterPos2f(0, 0);
    glMultiTexCoord1f(GL_TEXTURE0, 0.25f);  // after the position: of no account
    glCallList(1);
    EXPECT_THAT(pixel(9, 9), ElementsAre(0, 255, 255, 255));
}

// Generated coordinates and the texture matrix belong to the raster position as well.
TEST_F(PixelRects, TextureMatricesAndGeneratedCoordinatesReachBitmaps) {
    const GLubyte texels[8] = {255, 0, 0, 255, 0, 255, 0, 255};
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_1D);
    glMatrixMode(GL_TEXTURE);
    glTranslatef(0.5f, 0, 0);
    glTexCoord1f(0.25f);
    glRasterPos2f(0, 0);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    EXPECT_THAT(pixel(9, 9), ElementsAre(0, 255, 0, 255));
    glLoadIdentity();
    const GLfloat plane[4] = {1, 0, 0, 0.25f};
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
    glEnable(GL_TEXTURE_GEN_S);
    glRasterPos2f(0.5f, 0);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    EXPECT_THAT(pixel(13, 9), ElementsAre(0, 255, 0, 255));
    glRasterPos2f(0, 0);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    EXPECT_THAT(pixel(9, 9), ElementsAre(255, 0, 0, 255));
}

// Colour indices become colours by the maps: in every type, shifted and offset before, masked to the size of
// each map (GL 1.5 §3.6.4, §3.6.5).
template <typename T>
void draw_indices(GLenum type) {
    const T indices[4] = {T{0}, T{1}, T{2}, T{3}};
    glDrawPixels(4, 1, GL_COLOR_INDEX, type, indices);
}

TEST_F(PixelRects, ColorIndicesOfEveryTypeAreLookedUp) {
    const GLfloat red[4] = {0, 1, 0, 1}, green[2] = {0, 1}, blue[4] = {0, 0, 1, 1}, alpha[1] = {1};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, green);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, blue);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 1, alpha);
    const std::pair<GLenum, void (*)(GLenum)> kinds[] = {
        {GL_BYTE, draw_indices<GLbyte>},   {GL_UNSIGNED_BYTE, draw_indices<GLubyte>},
        {GL_SHORT, draw_indices<GLshort>}, {GL_UNSIGNED_SHORT, draw_indices<GLushort>},
        {GL_INT, draw_indices<GLint>},     {GL_UNSIGNED_INT, draw_indices<GLuint>},
        {GL_FLOAT, draw_indices<GLfloat>}};
    glRasterPos2f(-1, -1);
    for (const auto& [type, draw] : kinds) {
        glClear(GL_COLOR_BUFFER_BIT);
        draw(type);
        EXPECT_THAT(pixel(0, 0), ElementsAre(0, 0, 0, 255)) << type;
        EXPECT_THAT(pixel(1, 0), ElementsAre(255, 255, 0, 255)) << type;
        EXPECT_THAT(pixel(2, 0), ElementsAre(0, 0, 255, 255)) << type;
        EXPECT_THAT(pixel(3, 0), ElementsAre(255, 255, 255, 255)) << type;
        glPixelTransferi(GL_INDEX_SHIFT, 1);
        glPixelTransferi(GL_INDEX_OFFSET, 1);  // 1, 3, 5, 7
        draw(type);
        EXPECT_THAT(pixel(0, 0), ElementsAre(255, 255, 0, 255)) << type;
        EXPECT_THAT(pixel(1, 0), ElementsAre(255, 255, 255, 255)) << type;
        EXPECT_THAT(pixel(2, 0), ElementsAre(255, 255, 0, 255)) << type;
        glPixelTransferi(GL_INDEX_SHIFT, -1);
        glPixelTransferi(GL_INDEX_OFFSET, 0);  // 0, 0, 1, 1
        draw(type);
        EXPECT_THAT(pixel(1, 0), ElementsAre(0, 0, 0, 255)) << type;
        EXPECT_THAT(pixel(2, 0), ElementsAre(255, 255, 0, 255)) << type;
        glPixelTransferi(GL_INDEX_SHIFT, 0);
    }
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

// GL_MAP_COLOR maps indices to indices only where indices are stored; scale and bias are of colours that came
// as such.
TEST_F(PixelRects, ColorIndicesAreNeitherScaledNorMappedAgain) {
    const GLfloat red[2] = {0.25f, 0.5f}, to_one[2] = {1, 1};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, to_one);
    glPixelTransferf(GL_RED_SCALE, 0);
    glPixelTransferf(GL_RED_BIAS, 1);
    glPixelTransferi(GL_MAP_COLOR, 1);
    glRasterPos2f(-1, -1);
    draw_indices<GLubyte>(GL_UNSIGNED_BYTE);
    glPixelTransferf(GL_RED_SCALE, 1);
    glPixelTransferf(GL_RED_BIAS, 0);
    glPixelTransferi(GL_MAP_COLOR, 0);
    EXPECT_EQ(pixel(0, 0)[0], 64);
    EXPECT_EQ(pixel(1, 0)[0], 128);
}

TEST_F(PixelRects, BitmapsOfColorIndicesAreLookedUp) {
    const GLfloat red[2] = {0.25f, 1}, green[2] = {1, 0};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, green);
    const GLubyte bits[4] = {0b10100000, 0b10000000, 0b01000000, 0};  // two rows of 9
    glRasterPos2f(-1, -1);
    glDrawPixels(9, 2, GL_COLOR_INDEX, GL_BITMAP, bits);
    const Pixel set{255, 0, 0, 0}, clear{64, 255, 0, 0};
    EXPECT_EQ(pixel(0, 0), set);
    EXPECT_EQ(pixel(1, 0), clear);
    EXPECT_EQ(pixel(2, 0), set);
    EXPECT_EQ(pixel(8, 0), set);
    EXPECT_EQ(pixel(1, 1), set);
    EXPECT_EQ(pixel(8, 1), clear);
    glPixelStorei(GL_UNPACK_LSB_FIRST, 1);
    glDrawPixels(9, 2, GL_COLOR_INDEX, GL_BITMAP, bits);
    EXPECT_EQ(pixel(0, 0), clear);
    EXPECT_EQ(pixel(5, 0), set);
    EXPECT_EQ(pixel(7, 0), set);
    EXPECT_EQ(pixel(8, 0), clear);
    EXPECT_EQ(pixel(6, 1), set);
}

// In lists the maps count as they are when the list is called.
TEST_F(PixelRects, ColorIndicesInListsAreLookedUpByTheCall) {
    const GLubyte index = 1;
    glNewList(1, GL_COMPILE);
    glDrawPixels(1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &index);
    glEndList();
    const GLfloat red[2] = {0, 1};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
    glRasterPos2f(-1, -1);
    glCallList(1);
    EXPECT_EQ(pixel(0, 0)[0], 255);
}

TEST_F(PixelRects, EveryColorMapIsUsed) {
    const GLfloat to_one[2] = {1, 1}, to_zero[2] = {0, 0};
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, to_zero);
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 2, to_one);
    glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, to_one);
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 2, to_zero);
    glPixelTransferi(GL_MAP_COLOR, 1);
    const std::vector<GLubyte> gray(4, 128);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, gray.data());
    glPixelTransferi(GL_MAP_COLOR, 0);
    EXPECT_THAT(pixel(0, 0), ElementsAre(0, 255, 255, 0));
}

TEST_F(PixelRects, StencilValuesAreShiftedOffsetAndMapped) {
    const GLfloat map[4] = {9, 8, 7, 6};
    const GLubyte value = 1;
    glPixelTransferi(GL_INDEX_SHIFT, 3);
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    EXPECT_EQ(stencil(0, 0), 10);
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 4, map);
    glPixelTransferi(GL_MAP_STENCIL, 1);
    glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
    glPixelTransferi(GL_MAP_STENCIL, 0);
    EXPECT_EQ(stencil(0, 0), 8);
}

TEST_F(PixelRects, CopiedDepthsUndergoTheDepthTestAndStayTheSame) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    const GLuint depths[2] = {0x12345612, 0xfedcbafe};
    glDrawPixels(2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths);
    EXPECT_EQ(depth(0, 0), depths[0]);
    EXPECT_EQ(depth(1, 0), depths[1]);
    glDepthFunc(GL_LESS);
    glWindowPos2i(1, 0);
    glCopyPixels(0, 0, 1, 1, GL_DEPTH);
    EXPECT_EQ(depth(1, 0), depths[0]);
    glWindowPos2i(0, 0);
    glDepthFunc(GL_GREATER);
    glCopyPixels(1, 0, 1, 1, GL_DEPTH);
    EXPECT_EQ(depth(0, 0), depths[0]);
}

TEST_F(PixelRects, WhatIsOutsideTheWindowIsNotCopied) {
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const GLubyte green[4] = {0, 255, 0, 255};
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green);
    glWindowPos2i(4, 4);
    glCopyPixels(-2, -2, 4, 4, GL_COLOR);
    EXPECT_THAT(pixel(6, 6), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(pixel(5, 6), ElementsAre(255, 0, 0, 255));
    glCopyPixels(100, 0, 4, 4, GL_COLOR);
    glCopyPixels(-2147483647, -2147483647, 2147483647, 2147483647, GL_COLOR);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelRects, AnyZoomAndPositionIsHarmless) {
    const std::vector<GLubyte> image(64 * 64 * 4, 77);
    constexpr float kLarge = 3e38f;
    for (const float zoom : {0.0f, 1e-30f, -1e-30f, kLarge, -kLarge, std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity(), 1e4f}) {
        for (const float x : {0.0f, kLarge, -kLarge, std::numeric_limits<float>::quiet_NaN(), 2e9f}) {
            glPixelZoom(zoom, zoom);
            glWindowPos3f(x, x, x);
            glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
            glPixelZoom(1, zoom);
            glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
            glBitmap(32, 32, x, zoom, zoom, x, image.data());
            glCopyPixels(0, 0, 9, 9, GL_COLOR);
        }
    }
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelRects, CountInOcclusionQueries) {
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    glBitmap(4, 4, 0, 0, 0, 0, kAll);
    const std::vector<GLubyte> image(5 * 6 * 4, 77);
    glDrawPixels(5, 6, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint samples = 0;
    glGetQueryObjectuiv(1, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, 16u + 30u);
}

TEST_F(PixelRects, LitRasterColorsFollowWhatTheyDependOn) {
    const auto red = [](GLfloat x = 0) {
        glRasterPos2f(x, 0);
        GLfloat color[4];
        glGetFloatv(GL_CURRENT_RASTER_COLOR, color);
        return color[0];
    };
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glNormal3f(0, 0, 1);
    const GLfloat facing = red();
    EXPECT_GT(facing, 0.8f);
    EXPECT_EQ(red(0.5f), facing);
    glNormal3f(1, 0, 0);
    EXPECT_LT(red(), facing);
    glNormal3f(0, 0, 1);
    EXPECT_EQ(red(), facing);
    // A draw with colours and normals of its own in between.
    glBegin(GL_TRIANGLES);
    for (const GLfloat x : {-1.0f, 0.0f, 1.0f}) glNormal3f(x, 1, 0), glColor3f(x, 0, 1), glVertex2f(x, x * x);
    glEnd();
    glNormal3f(0, 0, 1);
    EXPECT_EQ(red(), facing);
    const GLfloat dim[] = {0.25f, 0.25f, 0.25f, 1}, near[] = {0.5f, 0, 0.1f, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, dim);
    EXPECT_LT(red(), facing);
    glMaterialfv(GL_FRONT, GL_EMISSION, dim);
    const GLfloat glowing = red();
    EXPECT_GT(glowing, 0.25f);
    glRotatef(80, 0, 1, 0);
    EXPECT_LT(red(), glowing);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, near);
    EXPECT_LT(red(-0.9f), red(0.5f));
}

}  // namespace
}  // namespace terrazzo::gl
