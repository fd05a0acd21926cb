// What tests of GLX have in common: a display, configurations, windows, contexts, X errors.
#pragma once

#define GLX_GLXEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#include <atomic>
#include <memory>
#include <vector>

// clang-format off: GoogleTest before Xlib, whose macros are words that others use.
#include <gtest/gtest.h>
#include <GL/gl.h>
#include <GL/glx.h>
// clang-format on

#include "drawing.h"

namespace terrazzo::test {

inline constexpr int kNone = 0;  // GLX lists end with X's None

template <class Function>
Function* command(const char* name) {
    return reinterpret_cast<Function*>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
}

inline std::atomic<int> last_x_error = 0;
inline std::atomic<XID> last_x_error_resource = 0;
inline std::atomic<int> last_x_error_request = 0;  // of GLX's

inline int note_error(Display*, XErrorEvent* event) {
    last_x_error = event->error_code;
    last_x_error_resource = event->resourceid;
    last_x_error_request = event->minor_code;
    return 0;
}

class Glx : public testing::Test {
  protected:
    Glx() {
        XSetErrorHandler(note_error);
        last_x_error = 0;
        display = XOpenDisplay(nullptr);
    }
    ~Glx() override {
        if (!display) return;
        glXMakeCurrent(display, 0, nullptr);
        XCloseDisplay(display);
    }
    void SetUp() override { ASSERT_NE(display, nullptr); }

    GLXFBConfig config(std::vector<int> list = {}) {
        for (const int value : {GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, kNone}) list.push_back(value);
        int count = 0;
        GLXFBConfig* const found = glXChooseFBConfig(display, DefaultScreen(display), list.data(), &count);
        if (!found) return nullptr;
        const GLXFBConfig first = found[0];
        XFree(found);
        return first;
    }
    GLXFBConfig double_buffered() { return config({GLX_DOUBLEBUFFER, 1}); }
    GLXFBConfig single_buffered() { return config({GLX_DOUBLEBUFFER, 0}); }

    std::unique_ptr<XWindow> window(GLXFBConfig of, int width = 100, int height = 80) {
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, of);
        auto out = std::make_unique<XWindow>(display, *visual, width, height);
        XFree(visual);
        return out;
    }
    GLXContext context(GLXFBConfig of, GLXContext share = nullptr) {
        return glXCreateNewContext(display, of, GLX_RGBA_TYPE, share, 1);
    }
    int take_x_error() {
        XSync(display, 0);
        return last_x_error.exchange(0);
    }

    Display* display;
};

}  // namespace terrazzo::test
