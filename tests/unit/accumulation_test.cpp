// The accumulation buffer belongs to the drawable (GL 1.5 §4.2.4): contexts share it, other buffers begin
// with zeros, and values stay in their range.
#include "gl/accumulation.h"

#include <gmock/gmock.h>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

using testing::ElementsAre;

constexpr Config kWithAccumulation{.accum_bits = 16};

class Accumulation : public testing::Test {
  protected:
    Accumulation() : m_ctx(create_context(kWithAccumulation, nullptr)) {
        attach_picture(*m_ctx, 8, 8);
        make_current(m_ctx.get());
    }
    ~Accumulation() override { make_current(nullptr); }

    Context& ctx() { return *m_ctx; }

    static void fill(float red) {
        glClearColor(red, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    static int red() {
        GLubyte pixel[4];
        glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return pixel[0];
    }

  private:
    std::unique_ptr<Context> m_ctx;
};

TEST_F(Accumulation, IsSharedByTheContextsOfADrawable) {
    fill(0.6f);
    glAccum(GL_LOAD, 1);
    const auto other = create_context(kWithAccumulation, nullptr);
    attach_drawables(*other, ctx().surface.draw, ctx().surface.draw);
    make_current(other.get());
    fill(0);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(red(), 153);
    make_current(&ctx());
}

TEST_F(Accumulation, StaysInItsRange) {
    fill(1);
    glAccum(GL_LOAD, 1);
    glAccum(GL_ACCUM, 1);
    glAccum(GL_MULT, 3);
    glAccum(GL_ADD, 1e30f);
    glAccum(GL_RETURN, 0.5f);
    EXPECT_EQ(red(), 128);
    glAccum(GL_MULT, -1e30f);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(red(), 0);
}

TEST_F(Accumulation, OtherBuffersBeginWithZeros) {
    fill(1);
    glAccum(GL_LOAD, 1);
    ctx().surface.draw->allocate(16, 16, {});
    follow_drawables(ctx());
    fill(1);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(red(), 0);
}

TEST_F(Accumulation, NeedsOneDrawableToDrawToAndReadFrom) {
    const auto other = std::make_shared<Drawable>(Buffering::kSingle);
    other->allocate(8, 8, {});
    attach_drawables(ctx(), ctx().surface.draw, other);
    glAccum(GL_LOAD, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    attach_drawables(ctx(), nullptr, nullptr);
    glAccum(GL_LOAD, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glClear(GL_ACCUM_BUFFER_BIT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Accumulation, ReturnsIntoFramesWithoutDrawingThem) {
    fill(0.2f);
    glAccum(GL_LOAD, 1);
    fill(0.8f);
    glAccum(GL_ACCUM, 0.5f);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 2, 2);
    glEnable(GL_BLEND);  // no matter
    glBlendFunc(GL_ZERO, GL_ONE);
    glAccum(GL_RETURN, 1);
    GLubyte pixels[4][4];
    glReadPixels(1, 1, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    EXPECT_EQ(pixels[0][0], 153);
    EXPECT_EQ(pixels[1][0], 204);
}

}  // namespace
}  // namespace terrazzo::gl
