// A window that is current in two threads: one draws and shows pictures, the other, as threads that load
// textures do, makes a context current with the same window again and again. Run by on_display.py.
#include <gtest/gtest.h>  // before Xlib, whose macros are words that others use

#define GLX_GLXEXT_PROTOTYPES
#include <GL/glx.h>

#include <thread>

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

    Display* x = nullptr;
    XVisualInfo* visual = nullptr;
};

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

}  // namespace
}  // namespace terrazzo::test
