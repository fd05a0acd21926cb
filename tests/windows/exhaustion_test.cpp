// Memory that runs out in GLX and EGL: each function is called again and again, the first allocation failing,
// then the second and so on, until a call needs no more than it gets. It may fail, with its error; nothing
// may leave it, and the next call works.
#include <functional>
#include <utility>

// GoogleTest before Xlib, whose macros are words that others use.
#include <gtest/gtest.h>

#define GLX_GLXEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glx.h>

#include "failing_memory.h"
#include "x_window.h"

namespace terrazzo::test {
namespace {

constexpr int kNone = 0;
int x_errors = 0;

int count_error(Display*, XErrorEvent*) {
    ++x_errors;
    return 0;
}

// Calls with ever more memory, each after `prepare`, until a call has all it asks for; that one has to work.
// Returns how many calls went without.
template <class Prepared>
int with_ever_more_memory(const std::function<Prepared()>& prepare,
                          const std::function<bool(Prepared&)>& call) {
    constexpr int kMost = 2000;
    eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);  // loads the library
    if (Display* const display = XOpenDisplay(nullptr)) {
        glXQueryExtensionsString(display, 0);
        XCloseDisplay(display);
    }
    if (!watch_library("/libterrazzo.so")) {
        ADD_FAILURE() << "the library is not there";
        return 0;
    }
    for (int n = 0; n < kMost; ++n) {
        Prepared prepared = prepare();
        fail_allocations(n, kAllBehind);
        const bool worked = call(prepared);
        if (stop_failing().failed == 0) {
            EXPECT_TRUE(worked);
            return n;
        }
        EXPECT_TRUE(call(prepared)) << "after allocation " << n << " failed";
    }
    ADD_FAILURE() << "there is no end of it";
    return kMost;
}

struct XDisplay {
    XDisplay() : display(XOpenDisplay(nullptr)) {}
    ~XDisplay() {
        if (display) XCloseDisplay(display);
    }
    XDisplay(XDisplay&& other) noexcept : display(std::exchange(other.display, nullptr)) {}
    XDisplay& operator=(XDisplay&&) = delete;
    Display* display;
};

// Each function is the first that a display meets.
class GlxExhaustion : public testing::Test {
  protected:
    static void exhaust(const std::function<bool(Display*)>& call) {
        XSetErrorHandler(count_error);
        const int failed = with_ever_more_memory<XDisplay>([] { return XDisplay(); },
                                                           [&](XDisplay& x) { return call(x.display); });
        EXPECT_GT(failed, 0);
    }

    static XVisualInfo default_visual(Display* display) {
        XVisualInfo info{};
        info.visualid = XVisualIDFromVisual(DefaultVisual(display, 0));
        info.visual = DefaultVisual(display, 0);
        return info;
    }

    // The first configuration; null when memory runs out.
    static GLXFBConfig first_config(Display* display) {
        int count = 0;
        GLXFBConfig* const configs = glXGetFBConfigs(display, 0, &count);
        if (!configs) return nullptr;
        const GLXFBConfig first = configs[0];
        XFree(configs);
        return first;
    }
};

TEST_F(GlxExhaustion, ChooseVisual) {
    exhaust([](Display* display) {
        int wishes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, kNone};
        XVisualInfo* const visual = glXChooseVisual(display, 0, wishes);
        const bool found = visual != nullptr;
        if (visual) XFree(visual);
        return found;
    });
}

TEST_F(GlxExhaustion, ChooseFBConfig) {
    exhaust([](Display* display) {
        const int wishes[] = {GLX_RED_SIZE, 8, kNone};
        int count = 0;
        GLXFBConfig* const configs = glXChooseFBConfig(display, 0, wishes, &count);
        const bool found = configs != nullptr;
        EXPECT_EQ(found, count > 0);
        if (configs) XFree(configs);
        return found;
    });
}

TEST_F(GlxExhaustion, GetFBConfigs) {
    exhaust([](Display* display) { return first_config(display) != nullptr; });
}

TEST_F(GlxExhaustion, GetConfig) {
    exhaust([](Display* display) {
        XVisualInfo visual = default_visual(display);
        int value = 0;
        return glXGetConfig(display, &visual, GLX_USE_GL, &value) == 0 && value != 0;
    });
}

TEST_F(GlxExhaustion, ContextsOfVisuals) {
    exhaust([](Display* display) {
        XVisualInfo visual = default_visual(display);
        const GLXContext context = glXCreateContext(display, &visual, nullptr, 1);
        if (context) glXDestroyContext(display, context);
        return context != nullptr;
    });
}

TEST_F(GlxExhaustion, ContextsOfConfigurations) {
    exhaust([](Display* display) {
        const GLXFBConfig config = first_config(display);
        const GLXContext context =
            config ? glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, 1) : nullptr;
        if (context) glXDestroyContext(display, context);
        return context != nullptr;
    });
}

// What can be drawn to, drawing, waiting and letting go.
TEST_F(GlxExhaustion, Drawing) {
    exhaust([](Display* display) {
        const GLXFBConfig config = first_config(display);
        if (!config) return false;
        const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, 1);
        const int size[] = {GLX_PBUFFER_WIDTH, 16, GLX_PBUFFER_HEIGHT, 16, kNone};
        const GLXPbuffer pbuffer = glXCreatePbuffer(display, config, size);
        bool drew = false;
        if (context && pbuffer && glXMakeCurrent(display, pbuffer, context)) {
            glRecti(0, 0, 1, 1);
            glXWaitGL();
            glXSwapBuffers(display, pbuffer);
            drew = glGetError() == GL_NO_ERROR;
            EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr) || allocations().failed != 0);
        }
        stop_failing();
        glXMakeCurrent(display, 0, nullptr);
        if (pbuffer) glXDestroyPbuffer(display, pbuffer);
        if (context) glXDestroyContext(display, context);
        return drew;
    });
}

struct Nothing {};

TEST(EglExhaustion, DisplaysOfPlatforms) {
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    ASSERT_NE(get_platform_display, nullptr);
    const int failed = with_ever_more_memory<XDisplay>(
        [] { return XDisplay(); },
        [&](XDisplay& x) {
            const EGLint screen[] = {EGL_PLATFORM_X11_SCREEN_EXT, 0, EGL_NONE};
            return get_platform_display(EGL_PLATFORM_X11_EXT, x.display, screen) != EGL_NO_DISPLAY;
        });
    EXPECT_GT(failed, 0);
}

TEST(EglExhaustion, Drawing) {
    const int failed = with_ever_more_memory<Nothing>(
        [] { return Nothing{}; },
        [](Nothing&) {
            const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
            bool drew = false;
            if (display && eglInitialize(display, nullptr, nullptr)) {
                const EGLint wishes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_BIT, EGL_NONE};
                const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
                EGLConfig config = nullptr;
                EGLint count = 0;
                eglBindAPI(EGL_OPENGL_API);
                eglChooseConfig(display, wishes, &config, 1, &count);
                const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
                const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
                if (context && surface && eglMakeCurrent(display, surface, surface, context)) {
                    glRecti(0, 0, 1, 1);
                    drew = eglWaitClient() && eglSwapBuffers(display, surface) && glGetError() == GL_NO_ERROR;
                }
            }
            EXPECT_TRUE(drew || allocations().failed != 0);
            stop_failing();
            eglReleaseThread();
            if (display) eglTerminate(display);
            return drew;
        });
    EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace terrazzo::test
