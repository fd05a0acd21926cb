// Feedback and selection of polygons that are drawn as lines and points, and tokens of lines (GL 1.5 §5.2,
// §5.3): what the reference leaves out.
#include "gl/render_mode.h"

#include <gmock/gmock.h>

#include <string>
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

// GL 1.5 table 5.1: what each type says of a vertex.
struct FeedbackType {
    GLenum name;
    int coordinates, colors, texture_coordinates;
    std::size_t values() const {
        return static_cast<std::size_t>(coordinates + colors + texture_coordinates);
    }
};
constexpr FeedbackType kTypes[] = {{GL_2D, 2, 0, 0},
                                   {GL_3D, 3, 0, 0},
                                   {GL_3D_COLOR, 3, 4, 0},
                                   {GL_3D_COLOR_TEXTURE, 3, 4, 4},
                                   {GL_4D_COLOR_TEXTURE, 4, 4, 4}};

class FeedbackTokens : public RenderMode, public testing::WithParamInterface<FeedbackType> {
  protected:
    // Vertices 0 to 4 lie in the view, each with values of its own in all its parts; w is 2.
    struct Vertex {
        GLfloat x, y, z, color, s;
    };
    static constexpr Vertex kVertices[] = {{-0.5f, -0.5f, 0, 0.25f, 1},
                                           {0.5f, -0.5f, 0.5f, 0.5f, 2},
                                           {0.5f, 0.5f, -0.5f, 0.75f, 3},
                                           {-0.5f, 0.5f, 0.25f, 1, 4},
                                           {-0.75f, 0, 0, 0, 5}};
    static constexpr GLfloat kW = 2;

    static void give(int number) {
        const Vertex& v = kVertices[number];
        glColor4f(v.color, 0, 1, 0.5f);
        glTexCoord4f(v.s, 0.5f, 0.25f, 1);
        glVertex4f(v.x * kW, v.y * kW, v.z * kW, kW);
    }
    static void give(GLenum mode, int count) {
        glBegin(mode);
        for (int i = 0; i < count; ++i) give(i);
        glEnd();
    }

    // What feedback says of a vertex.
    static std::vector<GLfloat> expected(int number) {
        const Vertex& v = kVertices[number];
        const std::vector<GLfloat> all = {(v.x + 1) * kSize / 2, (v.y + 1) * kSize / 2, (v.z + 1) / 2, kW};
        std::vector<GLfloat> out(all.begin(), all.begin() + GetParam().coordinates);
        if (GetParam().colors) out.insert(out.end(), {v.color, 0, 1, 0.5f});
        if (GetParam().texture_coordinates) out.insert(out.end(), {v.s, 0.5f, 0.25f, 1});
        return out;
    }
    // Tokens and numbers of vertices in turn, as one list of values. Vertices are written as -1 - number.
    static std::vector<GLfloat> values(const std::vector<int>& parts) {
        std::vector<GLfloat> out;
        for (const int part : parts) {
            if (part >= 0) {
                out.push_back(static_cast<GLfloat>(part));
            } else {
                const auto vertex = expected(-1 - part);
                out.insert(out.end(), vertex.begin(), vertex.end());
            }
        }
        return out;
    }
    static constexpr int v0 = -1, v1 = -2, v2 = -3, v3 = -4;

    template <typename Draw>
    static std::vector<GLfloat> feedback(Draw draw) {
        std::vector<GLfloat> buffer(1024);
        glFeedbackBuffer(1024, GetParam().name, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        buffer.resize(static_cast<std::size_t>(glRenderMode(GL_RENDER)));
        return buffer;
    }
    static std::vector<GLfloat> of(GLenum mode, int count) {
        return feedback([=] { give(mode, count); });
    }
    static void expect(const std::vector<GLfloat>& got, const std::vector<int>& parts) {
        EXPECT_THAT(got, testing::Pointwise(testing::FloatNear(1e-5f), values(parts)));
    }
};

TEST_P(FeedbackTokens, PointsAndLines) {
    expect(of(GL_POINTS, 2), {GL_POINT_TOKEN, v0, GL_POINT_TOKEN, v1});
    expect(of(GL_LINES, 4), {GL_LINE_RESET_TOKEN, v0, v1, GL_LINE_RESET_TOKEN, v2, v3});
    expect(of(GL_LINE_STRIP, 3), {GL_LINE_RESET_TOKEN, v0, v1, GL_LINE_TOKEN, v1, v2});
    expect(of(GL_LINE_LOOP, 3), {GL_LINE_RESET_TOKEN, v0, v1, GL_LINE_TOKEN, v1, v2, GL_LINE_TOKEN, v2, v0});
}

TEST_P(FeedbackTokens, TrianglesOfEveryKind) {
    expect(of(GL_TRIANGLES, 3), {GL_POLYGON_TOKEN, 3, v0, v1, v2});
    expect(of(GL_TRIANGLE_FAN, 4), {GL_POLYGON_TOKEN, 3, v0, v1, v2, GL_POLYGON_TOKEN, 3, v0, v2, v3});
    // The second of a strip is turned round; where it begins is open.
    const auto strip = of(GL_TRIANGLE_STRIP, 4);
    ASSERT_EQ(strip.size(), 2 * (2 + 3 * GetParam().values()));
    EXPECT_EQ(strip[0], GL_POLYGON_TOKEN);
    EXPECT_EQ(strip[2 + 3 * GetParam().values()], GL_POLYGON_TOKEN);
}

// Quads and polygons may come as they are or in triangles, with all their corners either way.
TEST_P(FeedbackTokens, QuadsAndPolygonsHaveAllTheirCorners) {
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
        const auto got = of(mode, 4);
        std::size_t corners = 0, at = 0;
        while (at < got.size()) {
            ASSERT_EQ(got[at], GL_POLYGON_TOKEN);
            const auto count = static_cast<std::size_t>(got[at + 1]);
            ASSERT_GE(count, 3u);
            corners += count - 2;
            at += 2 + count * GetParam().values();
        }
        EXPECT_EQ(at, got.size());
        EXPECT_EQ(corners, 2u) << mode;
    }
}

// The specification leaves open where an outline begins: with the last edge, as in the reference.
TEST_P(FeedbackTokens, OutlinesAndCornersOfPolygons) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    expect(of(GL_TRIANGLES, 3), {GL_LINE_RESET_TOKEN, v2, v0, GL_LINE_TOKEN, v0, v1, GL_LINE_TOKEN, v1, v2});
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    expect(of(GL_TRIANGLES, 3), {GL_POINT_TOKEN, v0, GL_POINT_TOKEN, v1, GL_POINT_TOKEN, v2});
}

TEST_P(FeedbackTokens, CulledAndClippedPrimitivesLeaveNothing) {
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    EXPECT_TRUE(of(GL_TRIANGLES, 3).empty());
    glDisable(GL_CULL_FACE);
    glMatrixMode(GL_PROJECTION);
    glTranslatef(4, 0, 0);
    for (const GLenum mode : {GL_POINTS, GL_LINES, GL_TRIANGLES, GL_POLYGON})
        EXPECT_TRUE(of(mode, 3).empty()) << mode;
}

TEST_P(FeedbackTokens, RastersAndPassThroughAreInTheirOrder) {
    static const GLubyte image[4] = {};
    const auto position = [] {
        const Vertex& v = kVertices[0];
        glColor4f(v.color, 0, 1, 0.5f);
        glTexCoord4f(v.s, 0.5f, 0.25f, 1);
        glRasterPos4f(v.x * kW, v.y * kW, v.z * kW, kW);
    };
    glPassThrough(1);  // no feedback is going on
    const auto draw = [&] {
        glPassThrough(7);
        position();
        glBitmap(1, 1, 0, 0, 0, 0, image);
        give(GL_POINTS, 1);
        glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, image);
        glPassThrough(8);
        glCopyPixels(0, 0, 1, 1, GL_COLOR);
        give(GL_LINES, 2);
        glPassThrough(9);
    };
    const std::vector<int> parts = {GL_PASS_THROUGH_TOKEN,
                                    7,
                                    GL_BITMAP_TOKEN,
                                    v0,
                                    GL_POINT_TOKEN,
                                    v0,
                                    GL_DRAW_PIXEL_TOKEN,
                                    v0,
                                    GL_PASS_THROUGH_TOKEN,
                                    8,
                                    GL_COPY_PIXEL_TOKEN,
                                    v0,
                                    GL_LINE_RESET_TOKEN,
                                    v0,
                                    v1,
                                    GL_PASS_THROUGH_TOKEN,
                                    9};
    expect(feedback(draw), parts);
    glNewList(1, GL_COMPILE);
    draw();
    glEndList();
    expect(feedback([] { glCallList(1); }), parts);
    // From an invalid position nothing comes.
    expect(feedback([] {
               glRasterPos2f(5, 5);
               glBitmap(1, 1, 0, 0, 0, 0, image);
               glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, image);
               glCopyPixels(0, 0, 1, 1, GL_COLOR);
           }),
           {});
}

TEST_P(FeedbackTokens, WhatDoesNotFitIsCountedAndNotWritten) {
    std::vector<GLfloat> buffer(2 + GetParam().values(), -7);
    glFeedbackBuffer(static_cast<GLsizei>(1 + GetParam().values()), GetParam().name, buffer.data());
    glRenderMode(GL_FEEDBACK);
    give(GL_POINTS, 1);
    EXPECT_EQ(glRenderMode(GL_FEEDBACK), static_cast<GLint>(1 + GetParam().values()));
    give(GL_POINTS, 2);
    EXPECT_EQ(glRenderMode(GL_RENDER), -1);
    EXPECT_EQ(buffer.back(), -7);
}

INSTANTIATE_TEST_SUITE_P(Types, FeedbackTokens, testing::ValuesIn(kTypes),
                         [](const auto& info) { return std::to_string(info.param.values()) + "Values"; });

}  // namespace
}  // namespace terrazzo::gl
