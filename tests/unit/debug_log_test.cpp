// The debug log names the call that broke a rule, and the rule (TERRAZZO_DEBUG=1).
#include <GL/gl.h>

#include <cstdlib>
#include <string>

#include "gl_fixture.h"

extern "C" void glTextureBarrierNV();  // shaders only: never ours

namespace terrazzo::gl {
namespace {

// Before the library looks, which it does once.
const int kSet = setenv("TERRAZZO_DEBUG", "1", 1);

class DebugLogTest : public GlTest {
  protected:
    template <typename Calls>
    static std::string log_of(Calls calls) {
        testing::internal::CaptureStderr();
        calls();
        return testing::internal::GetCapturedStderr();
    }
};

TEST_F(DebugLogTest, NamesTheCommandAndTheRule) {
    ASSERT_EQ(kSet, 0);
    const std::string log = log_of([] { glGenLists(-1); });
    EXPECT_EQ(log, "terrazzo: glGenLists: GL_INVALID_VALUE: range is negative\n");
    EXPECT_EQ(log_of([] { glGetError(); }), "");
}

TEST_F(DebugLogTest, NamesTheFormThatWasCalled) {
    const std::string log = log_of([] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1); });
    EXPECT_EQ(log, "terrazzo: glTexParameteri: GL_INVALID_ENUM: pname takes a vector\n");
}

TEST_F(DebugLogTest, EveryErrorIsLoggedThoughOneSticks) {
    const std::string log = log_of([] {
        glFogfv(GL_FOG_COLOR, nullptr);
        glEndList();
    });
    EXPECT_EQ(log,
              "terrazzo: glFogfv: GL_INVALID_VALUE: params is null\n"
              "terrazzo: glEndList: GL_INVALID_OPERATION: no list is being compiled\n");
}

TEST_F(DebugLogTest, BetweenBeginAndEnd) {
    const std::string log = log_of([] {
        glBegin(GL_POINTS);
        glListBase(1);
        glEnd();
        glEnd();
    });
    EXPECT_EQ(log,
              "terrazzo: glListBase: GL_INVALID_OPERATION: not allowed between glBegin and glEnd\n"
              "terrazzo: glEnd: GL_INVALID_OPERATION: not allowed outside glBegin and glEnd\n");
}

TEST_F(DebugLogTest, InListsTheCommandThatIsPlayed) {
    const std::string log = log_of([] {
        glNewList(1, GL_COMPILE);
        glDisable(GL_BLEND);
        glMatrixMode(GL_BLEND);
        glEndList();
        glCallList(1);
    });
    EXPECT_TRUE(log.starts_with("terrazzo: glMatrixMode: GL_INVALID_ENUM: ")) << log;
}

TEST_F(DebugLogTest, CommandsThatDoNotExist) {
    const std::string log = log_of([] { glTextureBarrierNV(); });
    EXPECT_EQ(log, "terrazzo: glTextureBarrierNV: GL_INVALID_OPERATION: not implemented\n");
}

TEST_F(DebugLogTest, WithoutContext) {
    make_current(nullptr);
    EXPECT_EQ(log_of([] { glFlush(); }), "terrazzo: glFlush: no context is current\n");
}

}  // namespace
}  // namespace terrazzo::gl
