// Drawables that are current in several threads at a time, and what threads destroy under each other's feet
// (GLX 1.4 §2.7, §3.3.7). Run by on_display.py, and once more with the thread sanitizer.
#include <gtest/gtest.h>  // before Xlib, whose macros are words that others use

#define GLX_GLXEXT_PROTOTYPES
#include <GL/glx.h>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "drawing.h"
#include "x_window.h"

namespace terrazzo::test {
namespace {

constexpr int kTurns = 4000;

class SharedWindow : public testing::Test {
  protected:
    SharedWindow() {
        XInitThreads();
        x = XOpenDisplay(nullptr);
        int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, 0};
        visual = x ? glXChooseVisual(x, DefaultScreen(x), attributes) : nullptr;
    }
    ~SharedWindow() override {
        if (visual) XFree(visual);
        if (x) XCloseDisplay(x);
    }

    // Each body in a thread of its own, all at the same time, `turns` times; it is given its context.
    void run(int turns, const std::vector<std::function<void(GLXContext)>>& bodies) {
        std::atomic<std::size_t> waiting = bodies.size();
        std::vector<std::thread> threads;
        for (const auto& body : bodies) {
            threads.emplace_back([&] {
                const GLXContext context = glXCreateContext(x, visual, nullptr, 1);
                --waiting;
                while (waiting != 0) std::this_thread::yield();
                for (int turn = 0; turn < turns; ++turn) body(context);
                EXPECT_TRUE(glXMakeCurrent(x, 0, nullptr));
                glXDestroyContext(x, context);
            });
        }
        for (std::thread& thread : threads) thread.join();
    }

    // What a thread's context does in a turn with what it has.
    static void draw_and_read(int turn) {
        draw_diagonal();
        glDrawBuffer(turn % 3 == 0 ? GL_FRONT : GL_BACK);
        glClear(GL_DEPTH_BUFFER_BIT);
        std::vector<GLubyte> pixels(4 * 64 * 64);
        glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 32, 32, 0);
        if (turn % 5 == 0) glFlush();
    }

    Display* x = nullptr;
    XVisualInfo* visual = nullptr;
};

int ignore_error(Display*, XErrorEvent*) {
    return 0;
}

TEST_F(SharedWindow, IsMadeCurrentWhileAnotherThreadShowsPictures) {
    ASSERT_NE(visual, nullptr);
    const XWindow window(x, *visual, 64, 64);
    const GLXContext draws = glXCreateContext(x, visual, nullptr, 1),
                     loads = glXCreateContext(x, visual, draws, 1);
    ASSERT_TRUE(glXMakeCurrent(x, window.id(), draws));
    int made_current = 0;
    std::thread loader([&] {
        for (int i = 0; i < kTurns; ++i) {
            made_current += glXMakeCurrent(x, window.id(), loads);
            glFinish();
            glXMakeCurrent(x, 0, nullptr);
        }
    });
    for (int i = 0; i < kTurns; ++i) {
        glClearColor(0, 1, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glXSwapBuffers(x, window.id());
    }
    loader.join();
    EXPECT_EQ(made_current, kTurns);
    glDrawBuffer(GL_BACK);
    glReadBuffer(GL_BACK);
    glClear(GL_COLOR_BUFFER_BIT);
    GLubyte pixel[4] = {};
    glReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[1], 255);
    glXMakeCurrent(x, 0, nullptr);
    glXDestroyContext(x, loads);
    glXDestroyContext(x, draws);
}

TEST_F(SharedWindow, IsDrawnToReadAndShownWhileItsSizeChanges) {
    ASSERT_NE(visual, nullptr);
    const XWindow window(x, *visual, 64, 64);
    std::atomic<int> turns = 0;
    const auto draws = [&](GLXContext context) {
        const int turn = ++turns;
        ASSERT_TRUE(glXMakeCurrent(x, window.id(), context));
        draw_and_read(turn);
        if (turn % 2 == 0) glXSwapBuffers(x, window.id());
        if (turn % 7 == 0) glXCopySubBufferMESA(x, window.id(), 3, 3, 20, 20);
        if (turn % 3 == 0) glXWaitX();
        unsigned value = 0;
        glXQueryDrawable(x, window.id(), GLX_WIDTH, &value);
        glXQueryDrawable(x, window.id(), GLX_BACK_BUFFER_AGE_EXT, &value);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    };
    const auto resizes = [&](GLXContext) {
        const int turn = ++turns;
        XResizeWindow(x, window.id(), static_cast<unsigned>(1 + turn * 37 % 150),
                      static_cast<unsigned>(1 + turn * 53 % 130));
        XSync(x, 0);
    };
    run(300, {draws, draws, resizes});
}

TEST_F(SharedWindow, PixmapsAndPbuffersAreDestroyedWhileOthersDrawToThem) {
    ASSERT_NE(visual, nullptr);
    int count = 0;
    const int list[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT | GLX_PIXMAP_BIT, GLX_DOUBLEBUFFER, 1, 0};
    GLXFBConfig* const configs = glXChooseFBConfig(x, visual->screen, list, &count);
    ASSERT_GT(count, 0);
    const auto handler = XSetErrorHandler(ignore_error);  // the handle may be nobody's by now
    const int size[] = {GLX_PBUFFER_WIDTH, 64, GLX_PBUFFER_HEIGHT, 64, 0};
    const Pixmap pixmap =
        XCreatePixmap(x, RootWindow(x, visual->screen), 64, 64, static_cast<unsigned>(visual->depth));
    std::atomic<GLXDrawable> pbuffer = glXCreatePbuffer(x, configs[0], size),
                             picture = glXCreatePixmap(x, configs[0], pixmap, nullptr);
    std::atomic<int> turns = 0;
    const auto draws = [&](GLXContext context) {
        const int turn = ++turns;
        const GLXDrawable to = turn % 2 == 0 ? pbuffer : picture;
        glXMakeCurrent(x, to, context);
        if (!glXGetCurrentContext()) return;
        draw_and_read(turn);
        glFinish();
        glXSwapBuffers(x, to);
    };
    const auto destroys = [&](GLXContext) {
        glXDestroyPbuffer(x, pbuffer.exchange(glXCreatePbuffer(x, configs[0], size)));
        glXDestroyPixmap(x, picture.exchange(glXCreatePixmap(x, configs[0], pixmap, nullptr)));
    };
    run(200, {draws, draws, destroys});
    XSync(x, 0);
    XSetErrorHandler(handler);
    glXDestroyPbuffer(x, pbuffer);
    glXDestroyPixmap(x, picture);
    XFreePixmap(x, pixmap);
    XFree(configs);
}

TEST_F(SharedWindow, WindowsComeAndGoInSeveralThreads) {
    ASSERT_NE(visual, nullptr);
    const auto body = [&](GLXContext context) {
        const XWindow window(x, *visual, 20, 20);
        ASSERT_TRUE(glXMakeCurrent(x, window.id(), context));
        draw_diagonal();
        glXSwapBuffers(x, window.id());
        ASSERT_TRUE(glXMakeCurrent(x, 0, nullptr));
    };
    run(150, {body, body, body});
}

// What is known of a display, and of its drawables, is looked up while others come and go.
TEST_F(SharedWindow, DrawablesAreFoundWhileOthersComeAndGo) {
    ASSERT_NE(visual, nullptr);
    int count = 0;
    const int list[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, 0};
    GLXFBConfig* const configs = glXChooseFBConfig(x, visual->screen, list, &count);
    ASSERT_GT(count, 0);
    const int size[] = {GLX_PBUFFER_WIDTH, 3, GLX_PBUFFER_HEIGHT, 1, 0};
    const GLXPbuffer stays = glXCreatePbuffer(x, configs[0], size);
    const auto finds = [&](GLXContext) {
        for (int i = 0; i < 10; ++i) {
            unsigned width = 0;
            glXQueryDrawable(x, stays, GLX_WIDTH, &width);
            ASSERT_EQ(width, 3u);
        }
    };
    const auto comes_and_goes = [&](GLXContext) {
        const GLXPbuffer made = glXCreatePbuffer(x, configs[0], size);
        ASSERT_NE(made, 0u);
        glXDestroyPbuffer(x, made);
    };
    run(2000, {finds, comes_and_goes});
    glXDestroyPbuffer(x, stays);
    XFree(configs);
}

TEST_F(SharedWindow, DisplaysComeAndGoInSeveralThreads) {
    ASSERT_NE(visual, nullptr);
    const auto opens = [&](GLXContext) {
        Display* const own = XOpenDisplay(nullptr);
        ASSERT_NE(own, nullptr);
        int count = 0;
        GLXFBConfig* const configs = glXGetFBConfigs(own, DefaultScreen(own), &count);
        EXPECT_GT(count, 0);
        const int size[] = {GLX_PBUFFER_WIDTH, 3, GLX_PBUFFER_HEIGHT, 1, 0};
        EXPECT_NE(glXCreatePbuffer(own, configs[0], size), 0u);
        XFree(configs);
        XCloseDisplay(own);
    };
    const auto asks = [&](GLXContext context) {
        for (int i = 0; i < 100; ++i) {
            int value = -1;
            EXPECT_EQ(glXQueryContext(x, context, GLX_RENDER_TYPE, &value), 0);
            EXPECT_EQ(value, GLX_RGBA_TYPE);
            EXPECT_EQ(glXGetConfig(x, visual, GLX_USE_GL, &value), 0);
            EXPECT_EQ(value, 1);
        }
    };
    run(50, {opens, opens, asks});
}

TEST_F(SharedWindow, ACopiedContextIsRefusedToNobody) {
    ASSERT_NE(visual, nullptr);
    const auto handler = XSetErrorHandler(ignore_error);  // BadAccess, where it is current
    const XWindow window(x, *visual, 20, 20);
    const GLXContext shared = glXCreateContext(x, visual, nullptr, 1);
    const auto uses = [&](GLXContext) {
        ASSERT_TRUE(glXMakeCurrent(x, window.id(), shared));
        glEnable(GL_LIGHTING);
        glLoadIdentity();
        draw_diagonal();
        glXMakeCurrent(x, 0, nullptr);
    };
    const auto copies = [&](GLXContext own) {
        glXCopyContext(x, shared, own, GL_ALL_ATTRIB_BITS);
        glXCopyContext(x, own, shared, GL_ALL_ATTRIB_BITS);
    };
    run(500, {uses, copies, copies});
    XSync(x, 0);
    XSetErrorHandler(handler);
    glXDestroyContext(x, shared);
}

// The pixmap has lost its name: closing the display must find it all the same.
TEST_F(SharedWindow, ADisplayIsClosedUnderADestroyedPixmapThatIsCurrent) {
    ASSERT_NE(visual, nullptr);
    Display* const other = XOpenDisplay(nullptr);
    int count = 0;
    const int list[] = {GLX_DRAWABLE_TYPE, GLX_PIXMAP_BIT, 0};
    GLXFBConfig* const configs = glXChooseFBConfig(other, DefaultScreen(other), list, &count);
    ASSERT_GT(count, 0);
    XVisualInfo* const its = glXGetVisualFromFBConfig(other, configs[0]);
    const Pixmap pixmap =
        XCreatePixmap(other, DefaultRootWindow(other), 64, 64, static_cast<unsigned>(its->depth));
    const GLXPixmap picture = glXCreatePixmap(other, configs[0], pixmap, nullptr);
    const GLXContext context = glXCreateNewContext(other, configs[0], GLX_RGBA_TYPE, nullptr, 1);
    ASSERT_TRUE(glXMakeCurrent(other, picture, context));
    draw_diagonal();
    glFinish();
    glXDestroyPixmap(other, picture);
    draw_diagonal();
    XFree(its);
    XFree(configs);
    XCloseDisplay(other);
    glFinish();
    // libglvnd takes a context away with its display.
    if (glGetString(GL_VERSION)) {
        EXPECT_EQ(read(1, 1), kRed);
    }
    EXPECT_TRUE(glXMakeCurrent(x, 0, nullptr));
}

}  // namespace
}  // namespace terrazzo::test
