// What bitmaps and pixel rectangles get from the current raster position, where the reference does other than
// GL 1.5 says and no comparison can tell (§3.6.4, §3.6.5, §3.7, §4.3.3).
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gmock/gmock.h>

#include <array>
#include <limits>
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
