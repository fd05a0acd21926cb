// EGL as programs use it: platforms, configurations, contexts, surfaces, fences, errors. Run by
// on_display.py.
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "egl_fixture.h"

namespace terrazzo::test {
namespace {

TEST_F(Egl, WindowsAreSwapped) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto shown = window(chosen);
    const EGLSurface surface = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    const EGLContext ctx = context(chosen);
    ASSERT_NE(ctx, EGL_NO_CONTEXT);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    EXPECT_EQ(renderer.substr(0, 8), "Terrazzo");
    for (const Pixel& color : {kRed, kGreen}) {
        clear_to(color);
        glFlush();
        EXPECT_NE(shown->pixel(50, 40), color);
        ASSERT_TRUE(eglSwapBuffers(egl, surface));
        EXPECT_EQ(shown->pixel(50, 40), color);
        EXPECT_EQ(shown->pixel(99, 79), color);
    }
    shown->resize(200, 300);
    glViewport(0, 0, 200, 300);
    clear_to(kBlue);
    ASSERT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(shown->pixel(199, 299), kBlue);
    EGLint value = 0;
    EXPECT_TRUE(eglQuerySurface(egl, surface, EGL_WIDTH, &value));
    EXPECT_EQ(value, 200);
    EXPECT_TRUE(eglQuerySurface(egl, surface, EGL_BUFFER_AGE_EXT, &value));
    EXPECT_EQ(value, 1);
    const EGLint damage[] = {0, 0, 10, 10};
    clear_to(kRed);
    EXPECT_TRUE(command<EGLBoolean(EGLDisplay, EGLSurface, const EGLint*, EGLint)>(
        "eglSwapBuffersWithDamageKHR")(egl, surface, damage, 1));
    EXPECT_EQ(shown->pixel(0, 299), kRed);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
    EXPECT_EQ(eglGetCurrentContext(), ctx);
    EXPECT_EQ(eglGetCurrentDisplay(), egl);
    // A second surface of one window is refused.
    EXPECT_EQ(eglCreateWindowSurface(egl, chosen, shown->id(), nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    // Surface and context live until they are let go of.
    EXPECT_TRUE(eglDestroySurface(egl, surface));
    EXPECT_TRUE(eglDestroyContext(egl, ctx));
    clear_to(kGreen);
    EXPECT_EQ(read(3, 3), kGreen);
}

TEST_F(Egl, MultisampledSurfacesHaveSmoothEdges) {
    open_x();
    EGLint value = -1;
    EXPECT_TRUE(eglGetConfigAttrib(egl, config(EGL_WINDOW_BIT), EGL_SAMPLES, &value));
    EXPECT_EQ(value, 0);
    const EGLConfig chosen =
        config(EGL_WINDOW_BIT | EGL_PBUFFER_BIT, {EGL_SAMPLE_BUFFERS, 1, EGL_SAMPLES, 4});
    ASSERT_NE(chosen, nullptr);
    const auto shown = window(chosen, 80, 80);
    const EGLSurface surface = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr);
    const EGLSurface hidden = pbuffer(chosen, 80, 80);
    const EGLContext ctx = context(chosen);
    const Pixel half{128, 0, 0};
    for (const EGLSurface target : {hidden, surface}) {
        ASSERT_TRUE(eglMakeCurrent(egl, target, target, ctx));
        draw_diagonal();
        EXPECT_EQ(read(30, 49), half);
    }
    ASSERT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(shown->pixel(30, 30), half);
    EXPECT_EQ(shown->pixel(30, 31), kRed);
    EXPECT_EQ(shown->pixel(30, 29), kBlack);
}

TEST_F(Egl, SingleBufferedWindowsShowAtFlush) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto shown = window(chosen);
    const EGLAttrib single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    Window name = shown->id();
    const EGLSurface surface = eglCreatePlatformWindowSurface(egl, chosen, &name, single);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    const EGLContext ctx = context(chosen);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    EGLint buffer = 0;
    EXPECT_TRUE(eglQueryContext(egl, ctx, EGL_RENDER_BUFFER, &buffer));
    EXPECT_EQ(buffer, EGL_SINGLE_BUFFER);
    clear_to(kGreen);
    glFlush();
    EXPECT_EQ(shown->pixel(50, 40), kGreen);
}

TEST_F(Egl, PbuffersWithoutAWindowSystem) {
    open_surfaceless();
    const EGLConfig chosen = config(EGL_PBUFFER_BIT, {EGL_ALPHA_SIZE, 8, EGL_STENCIL_SIZE, 8});
    ASSERT_NE(chosen, nullptr);
    const EGLSurface surface = pbuffer(chosen);
    const EGLContext ctx = context(chosen);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 20);
    clear_to(kRed);
    glColor3f(0, 1, 0);
    glRectf(-1, -1, 0, 1);
    EXPECT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(read(2, 2), kGreen);
    EXPECT_EQ(read(15, 2), kRed);
    EXPECT_EQ(config(EGL_WINDOW_BIT), nullptr);
}

TEST_F(Egl, ContextsWithoutSurfacesOrConfigurations) {
    open_surfaceless();
    const EGLContext ctx = context(EGL_NO_CONFIG_KHR);
    ASSERT_NE(ctx, EGL_NO_CONTEXT);
    ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx));
    clear_to(kRed);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    read(0, 0);
    EXPECT_EQ(glGetError(), 0x0506u);  // GL_INVALID_FRAMEBUFFER_OPERATION
    const EGLSurface surface = pbuffer(config(EGL_PBUFFER_BIT));
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    clear_to(kGreen);
    EXPECT_EQ(read(0, 0), kGreen);
}

TEST_F(Egl, TheProcessorIsADevice) {
    const std::string extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EXPECT_NE(extensions.find("EGL_EXT_platform_device"), std::string::npos);
    const auto query = command<EGLBoolean(EGLint, EGLDeviceEXT*, EGLint*)>("eglQueryDevicesEXT");
    ASSERT_NE(query, nullptr);
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(query(1, &device, &count));
    ASSERT_EQ(count, 1);
    const char* const text =
        command<const char*(EGLDeviceEXT, EGLint)>("eglQueryDeviceStringEXT")(device, EGL_EXTENSIONS);
    ASSERT_NE(text, nullptr);
    EXPECT_NE(std::string(text).find("EGL_MESA_device_software"), std::string::npos);
    open(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    EGLAttrib same = 0;
    EXPECT_TRUE(command<EGLBoolean(EGLDisplay, EGLint, EGLAttrib*)>("eglQueryDisplayAttribEXT")(
        egl, EGL_DEVICE_EXT, &same));
    EXPECT_NE(same, 0);
}

TEST_F(Egl, ConfigurationsAreSortedAsSpecified) {
    open_x();
    EGLint count = 0;
    ASSERT_TRUE(eglGetConfigs(egl, nullptr, 0, &count));
    ASSERT_GE(count, 8);
    EGLint value = 0;
    EXPECT_TRUE(eglGetConfigAttrib(egl, config(EGL_WINDOW_BIT), EGL_DEPTH_SIZE, &value));
    EXPECT_EQ(value, 16);  // the smallest that will do
    EXPECT_TRUE(
        eglGetConfigAttrib(egl, config(EGL_WINDOW_BIT, {EGL_STENCIL_SIZE, 1}), EGL_STENCIL_SIZE, &value));
    EXPECT_EQ(value, 8);
    EXPECT_TRUE(
        eglGetConfigAttrib(egl, config(EGL_WINDOW_BIT, {EGL_ALPHA_SIZE, 8}), EGL_BUFFER_SIZE, &value));
    EXPECT_EQ(value, 32);
    const EGLint es[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT, EGL_NONE};
    EGLConfig found = nullptr;
    EXPECT_TRUE(eglChooseConfig(egl, es, &found, 1, &count));
    EXPECT_EQ(count, 0);
    // The list of xscreensaver's hacks, which then draw with OpenGL.
    const EGLint hacks[] = {EGL_SURFACE_TYPE,    EGL_WINDOW_BIT,    EGL_RED_SIZE, 8,
                            EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_NONE};
    EXPECT_TRUE(eglChooseConfig(egl, hacks, &found, 1, &count));
    EXPECT_EQ(count, 1);
    EXPECT_FALSE(eglBindAPI(EGL_OPENGL_ES_API));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLint unknown[] = {0x7777, 1, EGL_NONE};
    EXPECT_FALSE(eglChooseConfig(egl, unknown, &found, 1, &count));
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    EXPECT_FALSE(eglGetConfigAttrib(egl, config(EGL_WINDOW_BIT), 0x7777, &value));
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
}

TEST_F(Egl, ErrorsOfTheSpecification) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto nowhere = reinterpret_cast<void*>(0x12345670);
    EXPECT_FALSE(eglSwapBuffers(egl, nowhere));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
    EXPECT_EQ(eglCreateContext(egl, nowhere, nullptr, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
    EXPECT_EQ(eglCreateContext(egl, chosen, nowhere, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    EXPECT_EQ(eglCreateWindowSurface(egl, chosen, 0x1234567, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(eglCreatePixmapSurface(egl, chosen, 0x1234567, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    const EGLint negative[] = {EGL_WIDTH, -1, EGL_HEIGHT, 1, EGL_NONE};
    EXPECT_EQ(eglCreatePbufferSurface(egl, chosen, negative), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EXPECT_EQ(eglCreateContext(egl, chosen, nullptr, core), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_FALSE(eglBindAPI(EGL_OPENVG_API));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLContext ctx = context(chosen);
    const EGLSurface surface = pbuffer(chosen);
    EXPECT_FALSE(eglMakeCurrent(egl, surface, EGL_NO_SURFACE, ctx));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_FALSE(eglMakeCurrent(egl, surface, surface, EGL_NO_CONTEXT));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    std::thread([&] {
        EXPECT_FALSE(eglMakeCurrent(egl, surface, surface, ctx));
        EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
    }).join();
    EGLint value = 0;
    EXPECT_FALSE(eglQuerySurface(egl, surface, 0x7777, &value));
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    EXPECT_FALSE(eglBindTexImage(egl, surface, EGL_BACK_BUFFER));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_EQ(eglCreateImage(egl, ctx, EGL_GL_TEXTURE_2D, nullptr, nullptr), EGL_NO_IMAGE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_TRUE(eglTerminate(egl));
    EXPECT_FALSE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
}

TEST_F(Egl, Fences) {
    open_surfaceless();
    const EGLConfig chosen = config(EGL_PBUFFER_BIT);
    EXPECT_EQ(eglCreateSync(egl, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC);
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    const EGLSurface surface = pbuffer(chosen);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context(chosen)));
    const EGLSync sync = eglCreateSync(egl, EGL_SYNC_FENCE, nullptr);
    ASSERT_NE(sync, EGL_NO_SYNC);
    EXPECT_EQ(eglClientWaitSync(egl, sync, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    EGLAttrib status = 0;
    EXPECT_TRUE(eglGetSyncAttrib(egl, sync, EGL_SYNC_STATUS, &status));
    EXPECT_EQ(status, EGL_SIGNALED);
    EXPECT_TRUE(eglWaitSync(egl, sync, 0));
    EXPECT_TRUE(eglDestroySync(egl, sync));
    EXPECT_FALSE(eglDestroySync(egl, sync));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglCreateSync(egl, EGL_SYNC_CL_EVENT, nullptr), EGL_NO_SYNC);
    EXPECT_NE(command<EGLSyncKHR(EGLDisplay, EGLenum, const EGLint*)>("eglCreateSyncKHR")(
                  egl, EGL_SYNC_FENCE_KHR, nullptr),
              EGL_NO_SYNC_KHR);
}

TEST_F(Egl, SharedListsAndCopies) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const EGLSurface surface = pbuffer(chosen, 32, 16);
    const EGLContext one = context(chosen), two = context(chosen, one);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, one));
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glClear(GL_COLOR_BUFFER_BIT);
    glEndList();
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, two));
    glClearColor(0, 0, 1, 1);
    glCallList(list);
    EXPECT_EQ(read(5, 5), kBlue);
    const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 32, 16, 24);
    ASSERT_TRUE(eglCopyBuffers(egl, surface, pixmap));
    XImage* const image = XGetImage(x, pixmap, 31, 15, 1, 1, ~0ul, ZPixmap);
    EXPECT_EQ(XGetPixel(image, 0, 0) & 0xffffff, 0x0000fful);
    XDestroyImage(image);
    const Pixmap other = XCreatePixmap(x, DefaultRootWindow(x), 5, 5, 24);
    EXPECT_FALSE(eglCopyBuffers(egl, surface, other));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
}

TEST_F(Egl, TheDisplayIsClosedFirst) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    auto shown = window(chosen);
    const EGLSurface surface = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context(chosen)));
    clear_to(kRed);
    ASSERT_TRUE(eglSwapBuffers(egl, surface));
    shown->forget();
    XCloseDisplay(std::exchange(x, nullptr));
    clear_to(kGreen);
    EXPECT_EQ(read(1, 1), kGreen);
    EXPECT_FALSE(eglSwapBuffers(egl, surface));
    egl = EGL_NO_DISPLAY;
    open_x();
}

}  // namespace
}  // namespace terrazzo::test
