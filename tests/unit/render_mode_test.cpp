// Feedback and selection of polygons that are drawn as lines and points, and tokens of lines (GL 1.5 §5.2,
// §5.3): what the reference leaves out.
#include "gl/render_mode.h"

#include <gmock/gmock.h>

#include <vector>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::ElementsAre;

constexpr int kSize = 16;
constexpr GLfloat kLine = GL_LINE_TOKEN, kRestart = GL_LINE_RESET_TOKEN, kPoint = GL_POINT_TOKEN;

class RenderMode : public GlTest {
  protected:
    RenderMode() { attach_picture(ctx(), kSize, kSize); }

    // The first values after each token that feedback of `draw` leaves.
    template <typename Draw>
    static std::vector<GLfloat> feedback(Draw draw) {
        std::vector<GLfloat> buffer(256);
        glFeedbackBuffer(256, GL_2D, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        buffer.resize(static_cast<std::size_t>(glRenderMode(GL_RENDER)));
        return buffer;
    }
};

void square() {
    glBegin(GL_QUADS);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glEdgeFlag(GL_FALSE);
    glVertex2f(1, 1);
    glEdgeFlag(GL_TRUE);
    glVertex2f(-1, 1);
    glEnd();
}

TEST_F(RenderMode, OutlinesComeEdgeByEdge) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_THAT(feedback(square),
                ElementsAre(kRestart, 0, 16, 0, 0, kLine, 0, 0, 16, 0, kLine, 16, 0, 16, 16));
}

TEST_F(RenderMode, CornersComeOneByOne) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    EXPECT_THAT(feedback(square), ElementsAre(kPoint, 0, 0, kPoint, 0, 16, kPoint, 16, 0));
}

TEST_F(RenderMode, StripsBeginAnewAndSegmentsEachDo) {
    const auto draw = [](GLenum mode) {
        return feedback([mode] {
            glBegin(mode);
            for (const float x : {-1.0f, 0.0f, 1.0f, 0.5f}) glVertex2f(x, 0);
            glEnd();
        });
    };
    EXPECT_THAT(draw(GL_LINE_STRIP),
                ElementsAre(kRestart, 0, 8, 8, 8, kLine, 8, 8, 16, 8, kLine, 16, 8, 12, 8));
    EXPECT_THAT(draw(GL_LINES), ElementsAre(kRestart, 0, 8, 8, 8, kRestart, 16, 8, 12, 8));
}

TEST_F(RenderMode, FlatPolygonsHaveTheirLastVertexsColor) {
    std::vector<GLfloat> buffer(64);
    glShadeModel(GL_FLAT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(10, 1000);  // no matter for feedback
    glFeedbackBuffer(64, GL_3D_COLOR, buffer.data());
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_TRIANGLES);
    for (const float x : {0.0f, 0.5f, 1.0f}) {
        glColor3f(x, 0, 0);
        glVertex3f(x, x * x, x);
    }
    glEnd();
    ASSERT_EQ(glRenderMode(GL_RENDER), 2 + 3 * 7);
    for (const std::size_t vertex : {0u, 1u, 2u}) EXPECT_EQ(buffer[2 + 7 * vertex + 3], 1);
    EXPECT_EQ(buffer[2 + 2], 0.5f);
    EXPECT_EQ(buffer[2 + 7 + 2], 0.75f);
}

TEST_F(RenderMode, OutlinesHit) {
    GLuint buffer[16] = {};
    glSelectBuffer(16, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(5);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    square();
    EXPECT_EQ(glRenderMode(GL_RENDER), 1);
    EXPECT_EQ(buffer[0], 1u);
    EXPECT_EQ(buffer[1], 0x80000000u);
    EXPECT_EQ(buffer[3], 5u);
}

TEST_F(RenderMode, TheFarthestDepthIsTheLargestNumber) {
    GLuint buffer[8] = {};
    glSelectBuffer(8, buffer);
    glRenderMode(GL_SELECT);
    glRasterPos3f(0, 0, 1);
    EXPECT_EQ(glRenderMode(GL_RENDER), 1);
    EXPECT_EQ(buffer[2], 0xffffffffu);
}

TEST_F(RenderMode, ARefusedModeLeavesTheOldOneGoingOn) {
    GLfloat buffer[8] = {};
    glFeedbackBuffer(8, GL_2D, buffer);
    glRenderMode(GL_FEEDBACK);
    glRenderMode(GL_SELECT);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    glPassThrough(3);
    EXPECT_EQ(glRenderMode(GL_RENDER), 2);
}

}  // namespace
}  // namespace terrazzo::gl
