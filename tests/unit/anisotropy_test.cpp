// Anisotropic filtering where the reference does other than the specification says, or nothing: depth
// comparisons, 1D textures, filters without levels, footprints without bounds.
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

constexpr int kSize = 16;

class Anisotropy : public GlTest {
  protected:
    Anisotropy() {
        attach_picture(ctx(), kSize, kSize);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    }

    static void filter(GLenum target, GLint min, GLfloat degree) {
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, min);
        glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree);
    }

    // A quad over the whole window, its coordinates from 0 to (s, t, r).
    static void draw(GLfloat s, GLfloat t, GLfloat r = 0) {
        glBegin(GL_QUADS);
        glTexCoord3f(0, 0, r), glVertex2f(-1, -1);
        glTexCoord3f(s, 0, r), glVertex2f(1, -1);
        glTexCoord3f(s, t, r), glVertex2f(1, 1);
        glTexCoord3f(0, t, r), glVertex2f(-1, 1);
        glEnd();
    }

    static std::vector<GLubyte> picture() {
        std::vector<GLubyte> pixels(4 * kSize * kSize);
        glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
};

TEST_F(Anisotropy, ResultsOfComparisonsAreWeighted) {
    const GLfloat depths[] = {0.2f, 0.8f};  // columns
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 2, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    filter(GL_TEXTURE_2D, GL_LINEAR, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glEnable(GL_TEXTURE_2D);
    draw(1, 1, 0.5f);  // r <= 0.2 is false, r <= 0.8 true
    const auto pixels = picture();
    EXPECT_EQ(pixels[0], 0);
    EXPECT_EQ(pixels[4 * (kSize - 1)], 255);
    EXPECT_GT(pixels[4 * 8], 64);
    EXPECT_LT(pixels[4 * 8], 192);
}

TEST_F(Anisotropy, OneDimensionHasNone) {
    const GLubyte texels[] = {0, 0, 0, 255, 255, 255, 255, 255};
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    filter(GL_TEXTURE_1D, GL_LINEAR, 1);
    glEnable(GL_TEXTURE_1D);
    draw(1, 1);
    const auto isotropic = picture();
    filter(GL_TEXTURE_1D, GL_LINEAR, 16);
    draw(1, 1);
    EXPECT_EQ(picture(), isotropic);
}

TEST_F(Anisotropy, FiltersWithoutLevelsStayAtTheBase) {
    const std::vector<GLubyte> red = {255, 0, 0, 255}, base(4 * 4 * 4, 128);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, base.data());
    glTexImage2D(GL_TEXTURE_2D, 2, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
    filter(GL_TEXTURE_2D, GL_LINEAR, 16);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    draw(64, 64);
    EXPECT_THAT(picture(), testing::Each(128));
}

// Every footprint is larger than the texture, some have no end or are nowhere.
TEST_F(Anisotropy, FootprintsAreBounded) {
    const std::vector<GLubyte> texels(4 * 64 * 64, 77);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    filter(GL_TEXTURE_2D, GL_LINEAR, 16);
    glEnable(GL_TEXTURE_2D);
    draw(1000, 3e5f);
    EXPECT_THAT(picture(), testing::Each(77));
    draw(3e30f, 3e38f);
    draw(std::numeric_limits<GLfloat>::infinity(), 1);
    draw(1, std::numeric_limits<GLfloat>::quiet_NaN());
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(Anisotropy, TheDegreeIsBounded) {
    const auto set = [](GLfloat degree) {
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree);
        GLfloat value;
        glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
        return value;
    };
    EXPECT_EQ(set(3.5f), 3.5f);
    EXPECT_EQ(set(1000), 16);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
    for (const GLfloat bad : {0.99f, -4.0f, std::numeric_limits<GLfloat>::quiet_NaN()}) {
        EXPECT_EQ(set(bad), 16);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE});
    }
}

}  // namespace
}  // namespace terrazzo::gl
