// What tests of EGL have in common: a display, configurations, windows, surfaces, contexts.
#pragma once

#include <memory>
#include <vector>

// GoogleTest before Xlib, whose macros are words that others use.
#include <gtest/gtest.h>

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include "drawing.h"

namespace terrazzo::test {

template <class Function>
Function* command(const char* name) {
    return reinterpret_cast<Function*>(eglGetProcAddress(name));
}

class Egl : public testing::Test {
  protected:
    ~Egl() override {
        if (egl) {
            eglMakeCurrent(egl, nullptr, nullptr, nullptr);
            eglTerminate(egl);
        }
        eglReleaseThread();
        if (x) XCloseDisplay(x);
    }

    void open(EGLDisplay display) {
        ASSERT_NE(display, EGL_NO_DISPLAY);
        egl = display;
        EGLint major = 0, minor = 0;
        ASSERT_TRUE(eglInitialize(egl, &major, &minor));
        ASSERT_EQ(major * 10 + minor, 15);
        ASSERT_STREQ(eglQueryString(egl, EGL_VENDOR), "Terrazzo");
        ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    }
    void open_x() {
        x = XOpenDisplay(nullptr);
        ASSERT_NE(x, nullptr);
        open(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x, nullptr));
        // However it is asked for, and once it is initialised.
        ASSERT_EQ(eglGetDisplay(x), egl);
        ASSERT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x, nullptr), egl);
    }
    void open_surfaceless() { open(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)); }

    EGLConfig config(int surface_type, std::vector<EGLint> list = {}) {
        for (const EGLint value : {EGL_SURFACE_TYPE, surface_type, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                   EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_NONE})
            list.push_back(value);
        EGLConfig found = nullptr;
        EGLint count = 0;
        EXPECT_TRUE(eglChooseConfig(egl, list.data(), &found, 1, &count));
        return found;
    }
    std::unique_ptr<XWindow> window(EGLConfig of, int width = 100, int height = 80) {
        EGLint id = 0;
        eglGetConfigAttrib(egl, of, EGL_NATIVE_VISUAL_ID, &id);
        XVisualInfo wanted{};
        wanted.visualid = static_cast<VisualID>(id);
        int count = 0;
        XVisualInfo* const visual = XGetVisualInfo(x, VisualIDMask, &wanted, &count);
        auto out = std::make_unique<XWindow>(x, *visual, width, height);
        XFree(visual);
        return out;
    }
    EGLContext context(EGLConfig of, EGLContext share = EGL_NO_CONTEXT) {
        return eglCreateContext(egl, of, share, nullptr);
    }
    EGLSurface pbuffer(EGLConfig of, int width = 20, int height = 10) {
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        return eglCreatePbufferSurface(egl, of, size);
    }

    Display* x = nullptr;
    EGLDisplay egl = EGL_NO_DISPLAY;
};

}  // namespace terrazzo::test
