// What outlives what: contexts destroyed while they are current, windows destroyed under their GLXWindow,
// displays terminated under their contexts; and which contexts GLX and EGL make, and refuse to make, for a
// list of attributes. Run by on_display.py, through libglvnd and without.
#include <atomic>
#include <memory>
#include <string>
#include <vector>

// GoogleTest before Xlib, whose macros are words that others use.
#include <gtest/gtest.h>

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glx.h>

#include "drawing.h"

namespace terrazzo::test {
namespace {

constexpr int kEnd = 0;  // of GLX's lists

// Of GLX's protocol: an error's number counts from the first that the server has set aside for GLX.
constexpr int kBadFBConfig = 9, kBadGlxWindow = 12, kBadProfile = 13;

std::atomic<int> last_x_error = 0;

int note_error(Display*, XErrorEvent* event) {
    last_x_error = event->error_code;
    return 0;
}

class GlxLife : public testing::Test {
  protected:
    GlxLife() {
        XSetErrorHandler(note_error);
        last_x_error = 0;
        display = XOpenDisplay(nullptr);
    }
    ~GlxLife() override {
        if (!display) return;
        glXMakeCurrent(display, 0, nullptr);
        XCloseDisplay(display);
    }
    void SetUp() override {
        ASSERT_NE(display, nullptr);
        const int list[] = {GLX_RED_SIZE, 8, GLX_DOUBLEBUFFER, 1, kEnd};
        int count = 0;
        GLXFBConfig* const found = glXChooseFBConfig(display, DefaultScreen(display), list, &count);
        ASSERT_NE(found, nullptr);
        config = found[0];
        XFree(found);
        int opcode = 0, event = 0;
        has_glx = XQueryExtension(display, "GLX", &opcode, &event, &first_error);
    }
    std::unique_ptr<XWindow> window() {
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, config);
        auto out = std::make_unique<XWindow>(display, *visual, 60, 50);
        XFree(visual);
        return out;
    }
    int take_x_error() {
        XSync(display, 0);
        return last_x_error.exchange(0);
    }
    // The number that the server has set aside for an error of GLX.
    int glx_error(int error) const { return first_error + error; }

    Display* display = nullptr;
    GLXFBConfig config = nullptr;
    bool has_glx = false;
    int first_error = 0;
};

// GLX 1.4 §3.3.7: it is destroyed when it is no longer current, and a context until then.
TEST_F(GlxLife, AContextDestroyedWhileCurrentIsOneUntilItIsLetGoOf) {
    const auto one = window();
    const GLXContext ctx = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, 1);
    ASSERT_TRUE(glXMakeCurrent(display, one->id(), ctx));
    clear_to(kRed);
    glXDestroyContext(display, ctx);
    ASSERT_TRUE(glXMakeCurrent(display, one->id(), ctx));
    clear_to(kGreen);
    EXPECT_EQ(read(1, 1), kGreen);
    glXSwapBuffers(display, one->id());
    EXPECT_EQ(one->pixel(1, 1), kGreen);
    EXPECT_TRUE(glXIsDirect(display, ctx));
    glXDestroyContext(display, ctx);  // once more
    EXPECT_EQ(take_x_error(), 0);
    EXPECT_EQ(glXGetCurrentContext(), ctx);
    clear_to(kBlue);
    EXPECT_EQ(read(1, 1), kBlue);
    ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
    EXPECT_EQ(take_x_error(), 0);
    // Now it is gone.
    EXPECT_FALSE(glXMakeCurrent(display, one->id(), ctx));
    EXPECT_NE(take_x_error(), 0);
}

// Windows are not counted as pixmaps are: the GLXWindow goes with its window.
TEST_F(GlxLife, AGlxWindowGoesWithItsWindow) {
    {
        const auto shown = window();
        const GLXWindow name = glXCreateWindow(display, config, shown->id(), nullptr);
        glXDestroyWindow(display, name);
        XWindowAttributes attributes;
        EXPECT_TRUE(XGetWindowAttributes(display, shown->id(), &attributes));
        EXPECT_EQ(take_x_error(), 0);
        glXDestroyWindow(display, name);
        EXPECT_NE(take_x_error(), 0);
    }
    auto shown = window();
    const GLXWindow name = glXCreateWindow(display, config, shown->id(), nullptr);
    shown.reset();
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyWindow(display, name);
    EXPECT_EQ(take_x_error(), has_glx ? glx_error(kBadGlxWindow) : BadWindow);
}

struct Attempt {
    const char* text;
    std::vector<int> list;
    int core_error, glx_error;  // -1: none
};

// GLX_ARB_create_context, ..._profile and ..._no_error.
TEST_F(GlxLife, ContextAttributesAreCheckedAsSpecified) {
    const auto create = reinterpret_cast<GLXContext (*)(Display*, GLXFBConfig, GLXContext, int, const int*)>(
        glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    ASSERT_NE(create, nullptr);
    constexpr int kMajor = GLX_CONTEXT_MAJOR_VERSION_ARB, kMinor = GLX_CONTEXT_MINOR_VERSION_ARB,
                  kFlags = GLX_CONTEXT_FLAGS_ARB, kMask = GLX_CONTEXT_PROFILE_MASK_ARB,
                  kCore = GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                  kCompatible = GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB,
                  kForward = GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB, kDebug = GLX_CONTEXT_DEBUG_BIT_ARB,
                  kRobust = GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB, kNoError = GLX_CONTEXT_OPENGL_NO_ERROR_ARB,
                  kReset = GLX_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB,
                  kRelease = GLX_CONTEXT_RELEASE_BEHAVIOR_ARB;
    const Attempt attempts[] = {
        {"nothing asked for", {}, -1, -1},
        {"the first version", {kMajor, 1, kMinor, 0}, -1, -1},
        {"the last version", {kMajor, 1, kMinor, 5}, -1, -1},
        {"only a major version", {kMajor, 1}, -1, -1},
        {"a debugged one", {kFlags, kDebug}, -1, -1},
        {"no flags", {kFlags, 0}, -1, -1},
        {"a profile before there were any", {kMask, kCore}, -1, -1},
        {"the other profile", {kMajor, 1, kMinor, 5, kMask, kCompatible}, -1, -1},
        {"render type", {GLX_RENDER_TYPE, GLX_RGBA_TYPE}, -1, -1},
        {"reset strategy", {kReset, GLX_LOSE_CONTEXT_ON_RESET_ARB}, -1, -1},
        {"release behaviour", {kRelease, GLX_CONTEXT_RELEASE_BEHAVIOR_NONE_ARB}, -1, -1},
        {"no errors wanted", {kNoError, 1}, -1, -1},

        {"an unknown attribute", {0x7777, 1}, BadValue, -1},
        {"an attribute of configurations", {GLX_SAMPLES, 4}, BadValue, -1},
        {"an unknown flag", {kFlags, 0x100}, BadValue, -1},
        {"an unknown reset strategy", {kReset, 1}, BadValue, -1},
        {"an unknown release behaviour", {kRelease, 77}, BadValue, -1},
        {"an unknown render type", {GLX_RENDER_TYPE, 77}, BadValue, -1},
        {"colour indices", {GLX_RENDER_TYPE, GLX_COLOR_INDEX_TYPE}, BadMatch, -1},
        {"no version 0", {kMajor, 0}, BadMatch, -1},
        {"no negative version", {kMajor, -1}, BadMatch, -1},
        {"no negative minor version", {kMajor, 1, kMinor, -1}, BadMatch, -1},
        {"no version 1.6", {kMajor, 1, kMinor, 6}, BadMatch, -1},
        {"no version 2.2", {kMajor, 2, kMinor, 2}, BadMatch, -1},
        {"no version 3.4", {kMajor, 3, kMinor, 4}, BadMatch, -1},
        {"no version 4.7", {kMajor, 4, kMinor, 7}, BadMatch, -1},
        {"no version 5", {kMajor, 5}, BadMatch, -1},
        {"forward compatible before there was any", {kFlags, kForward}, BadMatch, -1},
        {"no errors but debugging", {kNoError, 1, kFlags, kDebug}, BadMatch, -1},
        {"no errors but robust", {kNoError, 1, kFlags, kRobust}, BadMatch, -1},

        {"no profile", {kMajor, 3, kMinor, 2, kMask, 0}, -1, kBadProfile},
        {"both profiles", {kMajor, 3, kMinor, 2, kMask, kCore | kCompatible}, -1, kBadProfile},
        {"an unknown profile", {kMajor, 3, kMinor, 2, kMask, 0x100}, -1, kBadProfile},
        {"OpenGL ES", {kMajor, 2, kMinor, 0, kMask, 4}, -1, kBadProfile},
        {"no profile before there were any", {kMask, 0}, -1, kBadProfile},

        {"a version that is not there", {kMajor, 2, kMinor, 0}, -1, kBadFBConfig},
        {"one with profiles", {kMajor, 3, kMinor, 2, kMask, kCompatible}, -1, kBadFBConfig},
        {"the core of one", {kMajor, 4, kMinor, 6, kMask, kCore}, -1, kBadFBConfig},
        {"forward compatible", {kMajor, 3, kMinor, 0, kFlags, kForward}, -1, kBadFBConfig},
    };
    const auto shown = window();
    for (const Attempt& attempt : attempts) {
        SCOPED_TRACE(attempt.text);
        std::vector<int> list = attempt.list;
        list.push_back(kEnd);
        const GLXContext ctx = create(display, config, nullptr, 1, list.data());
        const int error = take_x_error();
        if (attempt.core_error < 0 && attempt.glx_error < 0) {
            ASSERT_NE(ctx, nullptr);
            EXPECT_EQ(error, 0);
            EXPECT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
            glXMakeCurrent(display, 0, nullptr);
            glXDestroyContext(display, ctx);
            continue;
        }
        EXPECT_EQ(ctx, nullptr);
        const int expected = attempt.core_error >= 0 ? attempt.core_error
                             : has_glx               ? glx_error(attempt.glx_error)
                                                     : BadValue;
        EXPECT_EQ(error, expected);
    }
    // What is shared with must be a context; null for a list is an empty one.
    EXPECT_EQ(create(display, config, reinterpret_cast<GLXContext>(0x12345670), 1, nullptr), nullptr);
    EXPECT_NE(take_x_error(), 0);
    const GLXContext plain = create(display, config, nullptr, 1, nullptr);
    EXPECT_NE(plain, nullptr);
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyContext(display, plain);
}

class EglLife : public testing::Test {
  protected:
    ~EglLife() override {
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
        initialize();
    }
    void initialize() {
        ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
        ASSERT_STREQ(eglQueryString(egl, EGL_VENDOR), "Terrazzo");
        const EGLint list[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 16,
                               EGL_NONE};
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(egl, list, &config, 1, &count));
        ASSERT_EQ(count, 1);
    }
    void open_x() {
        x = XOpenDisplay(nullptr);
        ASSERT_NE(x, nullptr);
        open(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x, nullptr));
    }
    void open_surfaceless() { open(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)); }
    EGLSurface pbuffer(int width, int height) {
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        return eglCreatePbufferSurface(egl, config, size);
    }

    Display* x = nullptr;
    EGLDisplay egl = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;
};

// EGL 1.5 §3.2: what is current stays until it is let go of, which works without the display.
TEST_F(EglLife, ADisplayIsTerminatedUnderAContext) {
    open_surfaceless();
    for (const bool with_surface : {false, true}) {
        initialize();
        ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
        const EGLContext ctx = eglCreateContext(egl, config, nullptr, nullptr);
        const EGLSurface surface = with_surface ? pbuffer(8, 8) : EGL_NO_SURFACE;
        ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
        ASSERT_TRUE(eglTerminate(egl));
        if (with_surface) {
            clear_to(kGreen);
            EXPECT_EQ(read(3, 3), kGreen);
        }
        EGLint value = 0;
        EXPECT_FALSE(eglQueryContext(egl, ctx, EGL_CONFIG_ID, &value)) << "the names are gone";
        EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
        EXPECT_TRUE(eglMakeCurrent(egl, nullptr, nullptr, nullptr));
        EXPECT_EQ(eglGetError(), EGL_SUCCESS);
        EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
        EXPECT_TRUE(eglTerminate(egl)) << "of what is terminated";
    }
}

// Without eglBindAPI a program means OpenGL ES 1; what such a context may be asked for is less.
TEST_F(EglLife, AProgramThatBindsNoApiGetsAContextToDrawWith) {
    open_surfaceless();
    const auto create = [&](std::vector<EGLint> list) {
        list.push_back(EGL_NONE);
        return eglCreateContext(egl, config, nullptr, list.data());
    };
    for (const std::vector<EGLint>& list :
         {std::vector<EGLint>{}, {EGL_CONTEXT_CLIENT_VERSION, 1}, {EGL_CONTEXT_FLAGS_KHR, 0}}) {
        const EGLContext ctx = create(list);
        ASSERT_NE(ctx, EGL_NO_CONTEXT);
        const EGLSurface surface = pbuffer(8, 8);
        ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
        clear_to(kBlue);
        EXPECT_EQ(read(7, 7), kBlue);
    }
    for (const std::vector<EGLint>& list :
         {std::vector<EGLint>{EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR},
          {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR},
          {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT},
          {EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_TRUE},
          {0x7777, 1}}) {
        EXPECT_EQ(create(list), EGL_NO_CONTEXT);
        EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    }
    for (const EGLint version : {2, 3}) {
        EXPECT_EQ(create({EGL_CONTEXT_CLIENT_VERSION, version}), EGL_NO_CONTEXT);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    }
    // The same list for OpenGL.
    ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    const EGLContext ctx = create({EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
    EXPECT_NE(ctx, EGL_NO_CONTEXT);
}

TEST_F(EglLife, WithoutAWindowSystemThereArePbuffersAndNothingElse) {
    int something = 0;
    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, &something, nullptr), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLAttrib odd[] = {EGL_WIDTH, 3, EGL_NONE};
    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, odd), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    open_surfaceless();
    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), egl)
        << "the same again";
    ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    unsigned long nothing = 0;
    for (const EGLConfig any : {config, EGLConfig(nullptr)}) {
        EXPECT_EQ(eglCreatePlatformWindowSurface(egl, any, &nothing, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_EQ(eglCreateWindowSurface(egl, any, 1, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_EQ(eglCreatePlatformPixmapSurface(egl, any, &nothing, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
        EXPECT_EQ(eglCreatePixmapSurface(egl, any, 1, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    }
    EGLint types = 0, count = 0;
    ASSERT_TRUE(eglGetConfigAttrib(egl, config, EGL_SURFACE_TYPE, &types));
    EXPECT_EQ(types, EGL_PBUFFER_BIT);
    const EGLint windows[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NONE};
    EGLConfig none = nullptr;
    EXPECT_TRUE(eglChooseConfig(egl, windows, &none, 1, &count));
    EXPECT_EQ(count, 0);
    const EGLSurface surface = pbuffer(8, 8);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    const EGLContext ctx = eglCreateContext(egl, config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    clear_to(kRed);
    EXPECT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(read(0, 7), kRed);
    EXPECT_FALSE(eglCopyBuffers(egl, surface, 1));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    // A context needs no surface; what it has drawn elsewhere stays.
    ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx));
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    EXPECT_EQ(read(7, 0), kRed);
}

// EGL 1.5 §3.10.3: all that has been drawn is copied, as the surface has it, its first row at the top.
TEST_F(EglLife, CopiesShowWhatWasDrawnAndNobodyRead) {
    open_x();
    ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    const EGLSurface surface = pbuffer(32, 16);
    const EGLContext ctx = eglCreateContext(egl, config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 32, 16, 24);
    const auto at = [&](int column, int row) {
        XImage* const image = XGetImage(x, pixmap, column, row, 1, 1, ~0ul, ZPixmap);
        const unsigned long pixel = XGetPixel(image, 0, 0);
        XDestroyImage(image);
        return Pixel{static_cast<int>(pixel >> 16 & 255), static_cast<int>(pixel >> 8 & 255),
                     static_cast<int>(pixel & 255)};
    };
    clear_to(kRed);
    glColor3f(0, 1, 0);
    glRectf(-1, 0, 1, 1);  // the upper half, by a draw that is still queued
    ASSERT_TRUE(eglCopyBuffers(egl, surface, pixmap));
    EXPECT_EQ(at(0, 0), kGreen);
    EXPECT_EQ(at(31, 7), kGreen);
    EXPECT_EQ(at(0, 8), kRed);
    EXPECT_EQ(at(31, 15), kRed);
    // Vertices that wait, too, and the surface stays as it is.
    glColor3f(0, 0, 1);
    glRectf(-1, -1, 0, 1);
    ASSERT_TRUE(eglCopyBuffers(egl, surface, pixmap));
    EXPECT_EQ(at(15, 15), kBlue);
    EXPECT_EQ(at(16, 15), kRed);
    EXPECT_EQ(read(31, 0), kRed);

    EXPECT_FALSE(eglCopyBuffers(egl, EGL_NO_SURFACE, pixmap));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_FALSE(eglCopyBuffers(egl, surface, 0x1234567));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    const Pixmap other_size = XCreatePixmap(x, DefaultRootWindow(x), 32, 15, 24),
                 other_depth = XCreatePixmap(x, DefaultRootWindow(x), 32, 16, 1);
    for (const Pixmap other : {other_size, other_depth}) {
        EXPECT_FALSE(eglCopyBuffers(egl, surface, other));
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
        XFreePixmap(x, other);
    }
    XFreePixmap(x, pixmap);
    ASSERT_TRUE(eglTerminate(egl));
    EXPECT_FALSE(eglCopyBuffers(egl, surface, pixmap));
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
}

}  // namespace
}  // namespace terrazzo::test
