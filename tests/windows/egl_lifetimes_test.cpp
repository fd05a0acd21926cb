// What outlives what in EGL: displays terminated under their contexts, what there is without a window system,
// copies; and which contexts are made, and refused, for programs that bind no API.
#include "egl_fixture.h"

namespace terrazzo::test {
namespace {

class EglLife : public Egl {
  protected:
    void initialize() {
        ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
        chosen = config(EGL_PBUFFER_BIT);
        ASSERT_NE(chosen, nullptr);
    }
    void open_x() {
        Egl::open_x();
        initialize();
    }
    void open_surfaceless() {
        Egl::open_surfaceless();
        initialize();
    }
    EGLSurface pbuffer(int width, int height) { return Egl::pbuffer(chosen, width, height); }

    EGLConfig chosen = nullptr;
};

// EGL 1.5 §3.2: what is current stays until it is let go of, which works without the display.
TEST_F(EglLife, ADisplayIsTerminatedUnderAContext) {
    open_surfaceless();
    for (const bool with_surface : {false, true}) {
        initialize();
        const EGLContext ctx = eglCreateContext(egl, chosen, nullptr, nullptr);
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
    eglReleaseThread();  // which has bound one
    const auto create = [&](std::vector<EGLint> list) {
        list.push_back(EGL_NONE);
        return eglCreateContext(egl, chosen, nullptr, list.data());
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
    unsigned long nothing = 0;
    for (const EGLConfig any : {chosen, EGLConfig(nullptr)}) {
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
    ASSERT_TRUE(eglGetConfigAttrib(egl, chosen, EGL_SURFACE_TYPE, &types));
    EXPECT_EQ(types, EGL_PBUFFER_BIT);
    const EGLint windows[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NONE};
    EGLConfig none = nullptr;
    EXPECT_TRUE(eglChooseConfig(egl, windows, &none, 1, &count));
    EXPECT_EQ(count, 0);
    const EGLSurface surface = pbuffer(8, 8);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    const EGLContext ctx = eglCreateContext(egl, chosen, nullptr, nullptr);
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
    const EGLSurface surface = pbuffer(32, 16);
    const EGLContext ctx = eglCreateContext(egl, chosen, nullptr, nullptr);
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
