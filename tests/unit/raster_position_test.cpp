// The raster position's texture coordinates that are generated from the normal (GL 1.5 §2.11.4, §2.13), which
// is in eye coordinates whatever the modelview matrix is: the reference leaves it in object coordinates.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using Vector = std::array<GLfloat, 4>;

class RasterPositionTest : public GlTest {
  protected:
    RasterPositionTest() { attach_picture(ctx(), 8, 8); }

    // The position (0, 0, 0) with the normal (0.6, 0, 0.8) and the coordinates r = 0.25, q = 1.
    Vector generated(GLenum mode) {
        for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
            const bool possible = coordinate != GL_R || mode != GL_SPHERE_MAP;
            const auto value = static_cast<GLfloat>(mode);
            if (possible) tex_genfv(ctx(), coordinate, GL_TEXTURE_GEN_MODE, &value);
            const GLenum capability = GL_TEXTURE_GEN_S + coordinate - GL_S;
            possible ? enable(ctx(), capability) : disable(ctx(), capability);
        }
        normal3f(ctx(), 0.6f, 0, 0.8f);
        tex_coord4f(ctx(), 0, 0, 0.25f, 1);
        raster_pos4f(ctx(), 0, 0, 0, 1);
        Vector out{};
        get_floatv(ctx(), GL_CURRENT_RASTER_TEXTURE_COORDS, out.data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return out;
    }
};

void expect_near(const Vector& found, const Vector& expected) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
}

TEST_F(RasterPositionTest, TheNormalTurnsWithTheModelviewMatrix) {
    rotatef(ctx(), 90, 0, 0, 1);
    expect_near(generated(GL_NORMAL_MAP), {0, 0.6f, 0.8f, 1});
}

TEST_F(RasterPositionTest, TheNormalIsScaledAsTheInverseIs) {
    scalef(ctx(), 2, 2, 4);
    expect_near(generated(GL_NORMAL_MAP), {0.3f, 0, 0.2f, 1});
}

TEST_F(RasterPositionTest, NormalizeMakesTheLengthOne) {
    enable(ctx(), GL_NORMALIZE);
    scalef(ctx(), 2, 2, 4);
    const GLfloat length = std::hypot(0.3f, 0.2f);
    expect_near(generated(GL_NORMAL_MAP), {0.3f / length, 0, 0.2f / length, 1});
}

// By the length of the inverse's third row (GL 1.5 equation 2.2).
TEST_F(RasterPositionTest, RescalingUndoesAScaleThatIsAllAround) {
    enable(ctx(), GL_RESCALE_NORMAL);
    scalef(ctx(), 4, 4, 4);
    expect_near(generated(GL_NORMAL_MAP), {0.6f, 0, 0.8f, 1});
    load_identity(ctx());
    scalef(ctx(), 2, 2, 4);
    expect_near(generated(GL_NORMAL_MAP), {1.2f, 0, 0.8f, 1});
}

// Seen from the origin along (0, 0, -1), the ray is reflected to (0.96, 0, 0.28).
TEST_F(RasterPositionTest, ReflectionsComeFromTheEye) {
    translatef(ctx(), 0, 0, -0.5f);
    expect_near(generated(GL_REFLECTION_MAP), {0.96f, 0, 0.28f, 1});
    const GLfloat m = 2 * std::hypot(0.96f, 1.28f);
    expect_near(generated(GL_SPHERE_MAP), {0.96f / m + 0.5f, 0.5f, 0.25f, 1});
}

// The eye itself has no direction to look in: nothing may become infinite.
TEST_F(RasterPositionTest, APositionInTheEyeHasCoordinates) {
    for (const GLfloat coordinate : generated(GL_SPHERE_MAP)) EXPECT_TRUE(std::isfinite(coordinate));
}

}  // namespace
}  // namespace terrazzo::gl
