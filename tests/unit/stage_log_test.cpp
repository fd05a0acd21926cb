// TERRAZZO_DEBUG=stages: which stages are taken is told once, and counted until the end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <string>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"
#include "simd/environment.h"

namespace terrazzo::gl {
namespace {

using testing::HasSubstr;
using testing::Not;

// Before the library looks, which it does once.
const int kSet = setenv("TERRAZZO_DEBUG", "stages", 1);
constexpr int kSize = 16;

class StageLogTest : public GlTest {
  protected:
    StageLogTest() {
        attach_picture(ctx(), kSize, kSize, {});
        glViewport(0, 0, kSize, kSize);
    }

    static void draw() {
        glRectf(-1, -1, 1, 1);
        glFinish();
    }
    static void draw_textured() {
        const GLubyte texels[2 * 2 * 4] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        glTexCoord2f(0.25f, 0.25f);
        draw();
        glDisable(GL_TEXTURE_2D);
    }
    template <typename Calls>
    static std::string log_of(Calls calls) {
        testing::internal::CaptureStderr();
        calls();
        return testing::internal::GetCapturedStderr();
    }
};

TEST(DebugWishes, AreWordsBetweenCommas) {
    const auto wishes = [](const char* text) {
        const DebugWishes found = parse_debug_wishes(text);
        return std::string(found.errors ? "errors" : "") + (found.stages ? "stages" : "");
    };
    EXPECT_EQ(wishes(nullptr), "");
    EXPECT_EQ(wishes(""), "");
    EXPECT_EQ(wishes("0"), "");
    EXPECT_EQ(wishes("1"), "errors");
    EXPECT_EQ(wishes("yes"), "errors");
    EXPECT_EQ(wishes("stages"), "stages");
    EXPECT_EQ(wishes("stages,"), "stages");
    EXPECT_EQ(wishes("1,stages"), "errorsstages");
    EXPECT_EQ(wishes("stages,1"), "errorsstages");
    EXPECT_EQ(wishes("0,stages"), "stages");
}

TEST_F(StageLogTest, NamesTheStagesOnce) {
    ASSERT_EQ(kSet, 0);
    const std::string log = log_of(draw_textured);
    EXPECT_THAT(log, HasSubstr("terrazzo: stages: "));
    EXPECT_THAT(log, HasSubstr(" texels0=nearest "));
    EXPECT_THAT(log, HasSubstr(" output=store\n"));
    EXPECT_THAT(log, Not(HasSubstr("(slow)")));
    EXPECT_THAT(log, Not(HasSubstr("unnamed")));
    EXPECT_EQ(log_of(draw_textured), "");
}

TEST_F(StageLogTest, MarksWhatReadsTheStateAsItRuns) {
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    EXPECT_THAT(log_of(draw_textured), HasSubstr(" output=general(slow)\n"));
    glEnable(GL_POLYGON_STIPPLE);
    EXPECT_THAT(log_of(draw_textured), HasSubstr("stages: test=general(slow) "));
}

TEST_F(StageLogTest, NamesKernels) {
    const std::string log = log_of([] {
        glEnable(GL_LINE_SMOOTH);
        glEnable(GL_BLEND);
        glBegin(GL_LINES);
        glVertex2f(-1, -1);
        glVertex2f(1, 0.9f);
        glEnd();
        glFinish();
    });
    EXPECT_EQ(log, "terrazzo: stages: kernel=general(slow)\n");
}

TEST_F(StageLogTest, NamesWhatLeavesNoTrace) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_EQ(log_of(draw), "terrazzo: stages: nothing\n");
}

TEST_F(StageLogTest, ErrorsAreNotAskedFor) {
    EXPECT_EQ(log_of([] { glGenLists(-1); }), "");
}

TEST_F(StageLogTest, InTheEndCountsTilesAndFragments) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto draw_and_exit = [] {
        draw_textured();
        draw_textured();
        glEnable(GL_COLOR_LOGIC_OP);
        glLogicOp(GL_XOR);
        glScissor(0, 0, 4, 4);
        glEnable(GL_SCISSOR_TEST);
        draw_textured();
        std::exit(0);
    };
    // Both triangles of a rectangle have the tiles of its diagonal.
    EXPECT_EXIT(draw_and_exit(), testing::ExitedWithCode(0),
                "end: 40 tiles, 512 fragments: .*output=store\n.*"
                "end: 2 tiles, 16 fragments: .*output=general\\(slow\\)\n.*"
                "end: slow: 1 of 2 ways, 16 of 528 fragments\n");
}

}  // namespace
}  // namespace terrazzo::gl
