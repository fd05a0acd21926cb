// Evaluators where no comparison can tell (GL 1.5 §5.1): current values, domains that run backwards, maps of
// one point, lists between Begin and End.
#include "gl/evaluators.h"

#include <gmock/gmock.h>

#include <vector>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::Each;
using testing::ElementsAre;

class Evaluators : public GlTest {
  protected:
    Evaluators() { attach_picture(ctx(), 16, 16); }

    static std::vector<GLfloat> feedback(GLenum type, void (*draw)()) {
        std::vector<GLfloat> buffer(512);
        glFeedbackBuffer(512, type, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        buffer.resize(static_cast<std::size_t>(glRenderMode(GL_RENDER)));
        return buffer;
    }
};

constexpr GLfloat kSquare[12] = {-1, -1, 0, -1, 1, 0, 1, -1, 0, 1, 1, 0};

TEST_F(Evaluators, LeaveTheCurrentValues) {
    const GLfloat colors[8] = {1, 0, 0, 1, 0, 0, 1, 1};
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, colors);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kSquare);
    glEnable(GL_MAP1_COLOR_4);
    glEnable(GL_MAP1_VERTEX_3);
    glColor4f(0, 1, 0, 1);
    const auto values = feedback(GL_3D_COLOR, [] {
        glBegin(GL_POINTS);
        glEvalCoord1f(0);
        glVertex2f(0, 0);
        glEnd();
    });
    ASSERT_EQ(values.size(), 16u);
    EXPECT_EQ(values[4], 1);
    EXPECT_EQ(values[8 + 4], 0);
    EXPECT_EQ(values[8 + 5], 1);
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_THAT(color, ElementsAre(0, 1, 0, 1));
}

// The light is where the viewer is: a normal that points away leaves the square black.
TEST_F(Evaluators, AutomaticNormalsOfReversedDomains) {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_MAP2_VERTEX_3);
    for (const float v1 : {0.0f, 1.0f}) {
        glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, v1, 1 - v1, 3, 2, kSquare);
        glMapGrid2f(1, 0, 1, 1, v1, 1 - v1);
        glClear(GL_COLOR_BUFFER_BIT);
        glEvalMesh2(GL_FILL, 0, 1, 0, 1);
        GLubyte pixel[4];
        glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        // In the scaled parameters both are the same; in those of the program the second faces away.
        EXPECT_EQ(pixel[0] > 100, v1 == 0) << v1;
    }
}

TEST_F(Evaluators, OrdersOfOneHaveNoTangent) {
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_MAP2_VERTEX_3);
    for (int order = 1; order <= 4; ++order) {
        const std::vector<GLfloat> points(12, 0.5f);
        for (const bool along_u : {false, true}) {
            glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, along_u ? order : 1, 0, 1, 3, along_u ? 1 : order,
                    points.data());
            const auto values = feedback(GL_2D, [] {
                glBegin(GL_POINTS);
                glEvalCoord2f(0.3f, 0.6f);
                glEnd();
            });
            EXPECT_THAT(values, ElementsAre(GLfloat{GL_POINT_TOKEN}, 12, 12)) << order;
        }
    }
}

TEST_F(Evaluators, InListsBetweenBeginAndEnd) {
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kSquare);
    glNewList(1, GL_COMPILE);
    glEnable(GL_MAP1_VERTEX_3);
    glMapGrid1f(2, 0, 1);
    glBegin(GL_LINE_STRIP);
    glEvalCoord1f(0);
    glEvalPoint1(1);
    glVertex2f(1, 1);
    glEnd();
    glEndList();
    const auto values = feedback(GL_2D, [] { glCallList(1); });
    EXPECT_THAT(values,
                ElementsAre(GLfloat{GL_LINE_RESET_TOKEN}, 0, 0, 0, 8, GLfloat{GL_LINE_TOKEN}, 0, 8, 16, 16));
    glCallList(1);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(Evaluators, ListsKeepControlPoints) {
    std::vector<GLfloat> points(kSquare, kSquare + 12);
    glNewList(1, GL_COMPILE);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, points.data());
    glMap2f(GL_MAP2_VERTEX_4, 0, 1, 1, 2, 0, 1, 3, 2, points.data());  // a stride too short
    glEndList();
    points.assign(12, 9);
    glCallList(1);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE});
    GLfloat kept[12];
    glGetMapfv(GL_MAP2_VERTEX_3, GL_COEFF, kept);
    EXPECT_THAT(kept, testing::ElementsAreArray(kSquare));
}

}  // namespace
}  // namespace terrazzo::gl
