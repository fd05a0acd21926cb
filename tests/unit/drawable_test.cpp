// Front and back buffers: which one is drawn to, read and shown, and what a switch between them keeps.
#define GL_GLEXT_PROTOTYPES
#include "gl/drawable.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "gl/context.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 100;  // more than one bin, and not a whole number of them
using Pixel = std::array<std::uint8_t, 4>;
constexpr Pixel kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255}, kShown{1, 2, 3, 4};

// A window whose screen is a picture in memory.
class Window : public Drawable {
  public:
    explicit Window(Buffering buffering) : Drawable(buffering), screen(kSize * kSize, kShown) {
        allocate(kSize, kSize, {});
    }
    void show_front(Context& ctx) override {
        ++shown;
        show(ctx, ColorBuffer::kFront);
    }
    void show(Context& ctx, ColorBuffer buffer) {
        copy_picture(ctx, *this, buffer, raster::PixelLayout::kRgba8,
                     reinterpret_cast<std::byte*>(screen.data()), kSize * 4);
    }

    std::vector<Pixel> screen;
    int shown = 0;

  protected:
    void load_front() override {
        const raster::TargetUse use(*target(), plane_of(ColorBuffer::kFront));
        for (int i = 0; i < target()->bin_count(); ++i) {
            target()->materialize(i);
            std::byte* const color = target()->bin(i).color;
            for (int p = 0; p < raster::kBinPixels; ++p) std::memcpy(color + 4 * p, kShown.data(), 4);
        }
    }
};

class DrawableTest : public testing::Test {
  protected:
    ~DrawableTest() override { make_current(nullptr); }

    void open(Buffering buffering) {
        Config config;
        config.double_buffered = buffering == Buffering::kDouble;
        context = create_context(config, nullptr);
        window = std::make_shared<Window>(buffering);
        attach_drawables(*context, window, window);
        make_current(context.get());
    }
    void clear_to(const Pixel& color) {
        glClearColor(color[0] / 255.0f, color[1] / 255.0f, color[2] / 255.0f, color[3] / 255.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    Pixel read(GLenum buffer, int x = 99, int y = 99) {
        glReadBuffer(buffer);
        Pixel pixel{};
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        return pixel;
    }

    std::unique_ptr<Context> context;
    std::shared_ptr<Window> window;
};

TEST_F(DrawableTest, DoubleBufferedDrawsToTheBack) {
    open(Buffering::kDouble);
    GLint buffer = 0;
    glGetIntegerv(GL_DRAW_BUFFER, &buffer);
    EXPECT_EQ(buffer, GL_BACK);
    GLboolean is_double = GL_FALSE;
    glGetBooleanv(GL_DOUBLEBUFFER, &is_double);
    EXPECT_TRUE(is_double);
    clear_to(kRed);
    glFlush();
    glFinish();
    EXPECT_EQ(window->shown, 0);
    EXPECT_EQ(read(GL_BACK), kRed);
    EXPECT_FALSE(window->has_front_pixels());
    EXPECT_EQ(read(GL_FRONT), kShown);
    EXPECT_EQ(read(GL_BACK, 0, 0), kRed);
}

TEST_F(DrawableTest, FrontIsSeenAtFlushAndWhenItIsLeft) {
    open(Buffering::kDouble);
    clear_to(kRed);
    glDrawBuffer(GL_FRONT);
    glScissor(0, 0, 50, kSize);
    glEnable(GL_SCISSOR_TEST);
    clear_to(kGreen);
    EXPECT_EQ(window->shown, 0);
    glFlush();
    EXPECT_EQ(window->shown, 1);
    EXPECT_EQ(window->screen[0], kGreen);
    EXPECT_EQ(window->screen[99], kShown);
    glFlush();
    EXPECT_EQ(window->shown, 1);
    clear_to(kBlue);
    glDrawBuffer(GL_BACK);
    EXPECT_EQ(window->shown, 2);
    EXPECT_EQ(window->screen[0], kBlue);
    EXPECT_EQ(read(GL_BACK, 0, 0), kRed);
    EXPECT_EQ(read(GL_FRONT, 0, 0), kBlue);
}

TEST_F(DrawableTest, SwapExchangesThePixels) {
    open(Buffering::kDouble);
    clear_to(kRed);
    ASSERT_EQ(read(GL_FRONT), kShown);
    window->show(*context, ColorBuffer::kBack);
    window->swap_pixels();
    EXPECT_EQ(window->screen[0], kRed);
    EXPECT_EQ(read(GL_FRONT), kRed);
    clear_to(kGreen);
    EXPECT_EQ(read(GL_FRONT), kRed);
    EXPECT_EQ(read(GL_BACK), kGreen);
}

// Each buffer's own colours are blended with, and both see the same depths.
TEST_F(DrawableTest, FrontAndBackAreDrawnAlike) {
    open(Buffering::kDouble);
    clear_to(kRed);
    glDrawBuffer(GL_FRONT);
    clear_to(kGreen);
    glDrawBuffer(GL_FRONT_AND_BACK);
    EXPECT_EQ(read(GL_BACK), kRed);
    EXPECT_EQ(read(GL_FRONT), kGreen);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor4f(0, 0, 1, 0);
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    for (int twice = 0; twice < 2; ++twice) glRectf(-1, -1, 1, 1);  // the second is hidden: GL_LESS
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint samples = 0;
    glGetQueryObjectuiv(1, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, GLuint{kSize * kSize});
    glFlush();
    EXPECT_EQ(window->screen[0], (Pixel{0, 255, 255, 255}));
    EXPECT_EQ(read(GL_BACK), (Pixel{255, 0, 255, 255}));
    EXPECT_EQ(read(GL_FRONT), (Pixel{0, 255, 255, 255}));
    glDisable(GL_BLEND);
    clear_to(kBlue);
    EXPECT_EQ(read(GL_FRONT), kBlue);
    EXPECT_EQ(read(GL_BACK), kBlue);
    glDrawBuffer(GL_BACK);
    clear_to(kRed);
    EXPECT_EQ(read(GL_FRONT), kBlue);
    EXPECT_EQ(read(GL_BACK), kRed);
}

TEST_F(DrawableTest, DepthBelongsToBoth) {
    open(Buffering::kDouble);
    glClearDepth(0.25);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawBuffer(GL_FRONT);
    GLfloat depth = 0;
    glReadPixels(3, 3, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_NEAR(depth, 0.25, 1e-6);
}

TEST_F(DrawableTest, SingleBufferedHasNoBack) {
    open(Buffering::kSingle);
    GLint buffer = 0;
    glGetIntegerv(GL_DRAW_BUFFER, &buffer);
    EXPECT_EQ(buffer, GL_FRONT);
    glDrawBuffer(GL_BACK);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    clear_to(kRed);
    glFlush();
    EXPECT_EQ(window->shown, 1);
    EXPECT_EQ(window->screen[0], kRed);
}

TEST_F(DrawableTest, PopAttribGoesBackToTheBuffer) {
    open(Buffering::kDouble);
    clear_to(kRed);
    glPushAttrib(GL_COLOR_BUFFER_BIT);
    glDrawBuffer(GL_FRONT);
    clear_to(kBlue);
    glPopAttrib();
    EXPECT_EQ(read(GL_BACK), kRed);
    EXPECT_EQ(read(GL_FRONT), kBlue);
    clear_to(kGreen);
    EXPECT_EQ(read(GL_BACK), kGreen);
    EXPECT_EQ(read(GL_FRONT), kBlue);
}

// What window systems are asked for is the window's, also while a frame buffer object takes its place.
TEST_F(DrawableTest, TheWindowIsThereBehindAnObject) {
    for (const Buffering buffering : {Buffering::kSingle, Buffering::kDouble}) {
        open(buffering);
        const bool is_double = buffering == Buffering::kDouble;
        clear_to(kRed);
        glBindRenderbuffer(GL_RENDERBUFFER, 1);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 2 * kSize, 2 * kSize);
        glBindFramebuffer(GL_FRAMEBUFFER, 1);
        const int picture = window->shown;
        window->show(*context, ColorBuffer::kBack);  // nothing is attached yet
        EXPECT_EQ(window->screen[kSize * kSize - 1], kRed);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
        clear_to(kGreen);
        window->screen.assign(window->screen.size(), kShown);
        window->show(*context, ColorBuffer::kBack);
        EXPECT_EQ(window->screen[0], kRed);
        EXPECT_EQ(window->screen[kSize * kSize - 1], kRed);
        window->screen.assign(window->screen.size(), kShown);
        present_window(*context);
        EXPECT_EQ(window->shown, picture + !is_double);
        EXPECT_EQ(window->screen[0], is_double ? kShown : kRed);
        present_window(*context);
        EXPECT_EQ(window->shown, picture + !is_double) << "once";
        EXPECT_EQ(read(GL_COLOR_ATTACHMENT0), kGreen);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glFlush();
        EXPECT_EQ(window->shown, picture + !is_double);
        EXPECT_EQ(read(is_double ? GL_BACK : GL_FRONT), kRed);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST_F(DrawableTest, APictureThatWasShownBehindAnObjectIsOld) {
    open(Buffering::kDouble);
    clear_to(kRed);
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    picture_was_shown(*context, *window);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_FALSE(context->surface.drawn) << "the next picture begins with the window's size";
    clear_to(kRed);
    EXPECT_TRUE(context->surface.drawn);
    picture_was_shown(*context, *window);
    EXPECT_FALSE(context->surface.drawn);
}

TEST_F(DrawableTest, OtherDrawablesAndNone) {
    open(Buffering::kDouble);
    clear_to(kRed);
    const auto other = std::make_shared<Window>(Buffering::kDouble);
    attach_drawables(*context, other, window);  // draws what is queued for the first window
    clear_to(kGreen);
    EXPECT_EQ(read(GL_BACK), kRed);
    const auto status = [](GLenum target) { return glCheckFramebufferStatus(target); };
    EXPECT_EQ(status(GL_DRAW_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    attach_drawables(*context, other, nullptr);
    EXPECT_EQ(status(GL_DRAW_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    EXPECT_EQ(status(GL_READ_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_UNDEFINED});
    attach_drawables(*context, nullptr, nullptr);
    EXPECT_EQ(status(GL_DRAW_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_UNDEFINED});
    EXPECT_EQ(status(GL_READ_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_UNDEFINED});
    glBindFramebuffer(GL_FRAMEBUFFER, 9);
    EXPECT_EQ(status(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT});
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    clear_to(kBlue);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    read(GL_BACK);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_FRAMEBUFFER_OPERATION));
    attach_drawables(*context, other, other);
    EXPECT_EQ(read(GL_BACK), kGreen);
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], kSize);
    other->allocate(30, 20, {});
    follow_drawables(*context);
    EXPECT_EQ(context->surface.width, 30);
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], kSize);
}

TEST_F(DrawableTest, BlitsBetweenItsOwnBuffers) {
    open(Buffering::kDouble);
    const auto blit = [&](GLenum from, GLenum to, GLenum filter) {
        glReadBuffer(from);
        glDrawBuffer(to);
        glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, filter);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    };
    for (const GLenum filter : {GL_NEAREST, GL_LINEAR}) {
        glDrawBuffer(GL_BACK);
        clear_to(kGreen);
        blit(GL_BACK, GL_FRONT, filter);
        glDrawBuffer(GL_BACK);
        clear_to(kRed);
        EXPECT_EQ(read(GL_FRONT), kGreen);
        EXPECT_EQ(read(GL_FRONT, 0, 0), kGreen);
        EXPECT_EQ(read(GL_BACK), kRed);
        blit(GL_FRONT, GL_BACK, filter);
        EXPECT_EQ(read(GL_BACK), kGreen);
        EXPECT_EQ(read(GL_FRONT), kGreen);
    }
}

TEST_F(DrawableTest, BlitsReachBothBuffers) {
    open(Buffering::kDouble);
    glDrawBuffer(GL_BACK);
    clear_to(kGreen);
    glReadBuffer(GL_BACK);
    glDrawBuffer(GL_FRONT_AND_BACK);
    // The lower left pixels go to the upper right.
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 10, 10);
    clear_to(kBlue);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, 10, 10, kSize - 10, kSize - 10, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(read(GL_BACK), kBlue);
    EXPECT_EQ(read(GL_FRONT), kBlue);
    EXPECT_EQ(read(GL_BACK, 50, 50), kGreen);
    EXPECT_EQ(read(GL_FRONT, 50, 50), kShown);
}

}  // namespace
}  // namespace terrazzo::gl
