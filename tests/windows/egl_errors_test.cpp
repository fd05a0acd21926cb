// The errors of EGL 1.5 and of its extensions: a table of calls, what each returns and what eglGetError says
// of it.
#include <functional>
#include <string>
#include <thread>

#include "egl_fixture.h"

namespace terrazzo::test {
namespace {

class EglErrors : public Egl {
  protected:
    struct Case {
        const char* what;
        EGLint error;
        std::function<bool()> call;  // whether it worked
    };

    void check(const std::vector<Case>& cases) {
        for (const Case& c : cases) {
            eglGetError();
            EXPECT_EQ(c.call(), c.error == EGL_SUCCESS) << c.what;
            const EGLint error = eglGetError();
            EXPECT_EQ(error, c.error) << c.what << std::hex << ": 0x" << error << ", not 0x" << c.error;
            EXPECT_EQ(eglGetError(), EGL_SUCCESS) << c.what;
        }
    }
    using Ints = std::vector<EGLint>;
    bool chooses(Ints list) {
        list.push_back(EGL_NONE);
        EGLint count = 0;
        return eglChooseConfig(egl, list.data(), nullptr, 0, &count);
    }
    bool creates_context(EGLConfig of, Ints list, EGLContext share = EGL_NO_CONTEXT) {
        list.push_back(EGL_NONE);
        const EGLContext made = eglCreateContext(egl, of, share, list.data());
        if (made) eglDestroyContext(egl, made);
        return made != EGL_NO_CONTEXT;
    }
    bool creates_pbuffer(EGLConfig of, Ints list) {
        list.push_back(EGL_NONE);
        const EGLSurface made = eglCreatePbufferSurface(egl, of, list.data());
        if (made) eglDestroySurface(egl, made);
        return made != EGL_NO_SURFACE;
    }
    bool creates_window(EGLConfig of, EGLNativeWindowType id, Ints list = {}) {
        list.push_back(EGL_NONE);
        const EGLSurface made = eglCreateWindowSurface(egl, of, id, list.data());
        if (made) eglDestroySurface(egl, made);
        return made != EGL_NO_SURFACE;
    }
    bool creates_pixmap(EGLConfig of, EGLNativePixmapType id, Ints list = {}) {
        list.push_back(EGL_NONE);
        const EGLSurface made = eglCreatePixmapSurface(egl, of, id, list.data());
        if (made) eglDestroySurface(egl, made);
        return made != EGL_NO_SURFACE;
    }
    // Every call that takes a display.
    std::vector<Case> on_display(EGLDisplay display, EGLint error) {
        EGLint value = 0;
        static EGLAttrib attribute = 0;
        static EGLint integer = 0;
        static EGLConfig some = nullptr;
        (void)value;
        const auto damage =
            command<EGLBoolean(EGLDisplay, EGLSurface, const EGLint*, EGLint)>("eglSwapBuffersWithDamageKHR");
        return {
            {"eglGetConfigs", error, [=] { return eglGetConfigs(display, &some, 1, &integer); }},
            {"eglChooseConfig", error, [=] { return eglChooseConfig(display, nullptr, &some, 1, &integer); }},
            {"eglGetConfigAttrib", error,
             [=] { return eglGetConfigAttrib(display, some, EGL_RED_SIZE, &integer); }},
            {"eglCreateContext", error,
             [=] { return eglCreateContext(display, some, nullptr, nullptr) != nullptr; }},
            {"eglDestroyContext", error, [=] { return eglDestroyContext(display, nullptr); }},
            {"eglQueryContext", error,
             [=] { return eglQueryContext(display, nullptr, EGL_CONFIG_ID, &integer); }},
            {"eglMakeCurrent", error, [=] { return eglMakeCurrent(display, nullptr, nullptr, &some); }},
            {"eglCreateWindowSurface", error,
             [=] { return eglCreateWindowSurface(display, some, 0, nullptr) != nullptr; }},
            {"eglCreatePixmapSurface", error,
             [=] { return eglCreatePixmapSurface(display, some, 0, nullptr) != nullptr; }},
            {"eglCreatePbufferSurface", error,
             [=] { return eglCreatePbufferSurface(display, some, nullptr) != nullptr; }},
            {"eglCreatePlatformWindowSurface", error,
             [=] { return eglCreatePlatformWindowSurface(display, some, &some, nullptr) != nullptr; }},
            {"eglCreatePlatformPixmapSurface", error,
             [=] { return eglCreatePlatformPixmapSurface(display, some, &some, nullptr) != nullptr; }},
            {"eglCreatePbufferFromClientBuffer", error,
             [=] {
                 return eglCreatePbufferFromClientBuffer(display, EGL_OPENVG_IMAGE, nullptr, some, nullptr) !=
                        nullptr;
             }},
            {"eglDestroySurface", error, [=] { return eglDestroySurface(display, nullptr); }},
            {"eglQuerySurface", error,
             [=] { return eglQuerySurface(display, nullptr, EGL_WIDTH, &integer); }},
            {"eglSurfaceAttrib", error,
             [=] { return eglSurfaceAttrib(display, nullptr, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED); }},
            {"eglSwapBuffers", error, [=] { return eglSwapBuffers(display, nullptr); }},
            {"eglSwapBuffersWithDamageKHR", error, [=] { return damage(display, nullptr, nullptr, 0); }},
            {"eglCopyBuffers", error, [=] { return eglCopyBuffers(display, nullptr, 0); }},
            {"eglBindTexImage", error, [=] { return eglBindTexImage(display, nullptr, EGL_BACK_BUFFER); }},
            {"eglReleaseTexImage", error,
             [=] { return eglReleaseTexImage(display, nullptr, EGL_BACK_BUFFER); }},
            {"eglQueryString", error, [=] { return eglQueryString(display, EGL_VENDOR) != nullptr; }},
            {"eglCreateSync", error,
             [=] { return eglCreateSync(display, EGL_SYNC_FENCE, nullptr) != EGL_NO_SYNC; }},
            {"eglDestroySync", error, [=] { return eglDestroySync(display, nullptr); }},
            {"eglClientWaitSync", error,
             [=] { return eglClientWaitSync(display, nullptr, 0, 0) == EGL_CONDITION_SATISFIED; }},
            {"eglWaitSync", error, [=] { return eglWaitSync(display, nullptr, 0); }},
            {"eglGetSyncAttrib", error,
             [=] { return eglGetSyncAttrib(display, nullptr, EGL_SYNC_TYPE, &attribute); }},
            {"eglCreateImage", error,
             [=] {
                 return eglCreateImage(display, nullptr, EGL_GL_TEXTURE_2D, nullptr, nullptr) != EGL_NO_IMAGE;
             }},
            {"eglDestroyImage", error, [=] { return eglDestroyImage(display, nullptr); }},
        };
    }

    void* const nowhere = reinterpret_cast<void*>(0x12345670);
};

TEST_F(EglErrors, OfDisplays) {
    open_surfaceless();
    check(on_display(EGL_NO_DISPLAY, EGL_BAD_DISPLAY));
    check(on_display(nowhere, EGL_BAD_DISPLAY));
    EGLint major = 0;
    check({
        {"initialising nothing", EGL_BAD_DISPLAY,
         [&] { return eglInitialize(EGL_NO_DISPLAY, &major, nullptr); }},
        {"initialising what is none", EGL_BAD_DISPLAY,
         [&] { return eglInitialize(nowhere, &major, nullptr); }},
        {"terminating nothing", EGL_BAD_DISPLAY, [&] { return eglTerminate(EGL_NO_DISPLAY); }},
        {"letting go without a display", EGL_BAD_DISPLAY,
         [&] { return eglMakeCurrent(nowhere, nullptr, nullptr, nullptr); }},
        {"an unknown platform", EGL_BAD_PARAMETER,
         [&] { return eglGetPlatformDisplay(0x7777, nullptr, nullptr) != nullptr; }},
        {"a surfaceless platform's native display", EGL_BAD_PARAMETER,
         [&] { return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nowhere, nullptr) != nullptr; }},
        {"an unknown attribute of a platform", EGL_BAD_ATTRIBUTE,
         [&] {
             const EGLAttrib list[] = {0x7777, 1, EGL_NONE};
             return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, list) != nullptr;
         }},
        {"an unknown string", EGL_BAD_PARAMETER, [&] { return eglQueryString(egl, 0x7777) != nullptr; }},
        {"an unknown API", EGL_BAD_PARAMETER, [&] { return eglBindAPI(0x7777); }},
        {"no surface of that kind", EGL_BAD_PARAMETER,
         [&] { return eglGetCurrentSurface(0x7777) != nullptr; }},
        {"terminating", EGL_SUCCESS, [&] { return eglTerminate(egl); }},
        {"terminating twice", EGL_SUCCESS, [&] { return eglTerminate(egl); }},
        {"letting go on a display that is terminated", EGL_SUCCESS,
         [&] { return eglMakeCurrent(egl, nullptr, nullptr, nullptr); }},
    });
    check(on_display(egl, EGL_NOT_INITIALIZED));
    EXPECT_TRUE(eglInitialize(egl, nullptr, nullptr));
    EXPECT_NE(config(EGL_PBUFFER_BIT), nullptr);
}

TEST_F(EglErrors, OfConfigurations) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 8, 8, 24);
    EGLint value = 0;
    EGLConfig some = nullptr;
    std::vector<Case> cases = {
        {"no place for the count", EGL_BAD_PARAMETER, [&] { return eglGetConfigs(egl, &some, 1, nullptr); }},
        {"no place for the count of those chosen", EGL_BAD_PARAMETER,
         [&] { return eglChooseConfig(egl, nullptr, &some, 1, nullptr); }},
        {"a configuration that is none", EGL_BAD_CONFIG,
         [&] { return eglGetConfigAttrib(egl, nowhere, EGL_RED_SIZE, &value); }},
        {"an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] { return eglGetConfigAttrib(egl, chosen, 0x7777, &value); }},
        {"an unknown wish", EGL_BAD_ATTRIBUTE,
         [&] {
             return chooses({0x7777, 1});
         }},
        {"a level that does not matter", EGL_BAD_ATTRIBUTE,
         [&] {
             return chooses({EGL_LEVEL, EGL_DONT_CARE});
         }},
        {"a level below", EGL_SUCCESS,
         [&] {
             return chooses({EGL_LEVEL, -3});
         }},
        {"no configuration's number", EGL_BAD_ATTRIBUTE,
         [&] {
             return chooses({EGL_CONFIG_ID, -7});
         }},
        {"a pixmap that is none", EGL_BAD_ATTRIBUTE,
         [&] {
             return chooses({EGL_MATCH_NATIVE_PIXMAP, 0x1234567});
         }},
        {"a pixmap to go with", EGL_SUCCESS,
         [&] {
             return chooses({EGL_MATCH_NATIVE_PIXMAP, static_cast<EGLint>(pixmap)});
         }},
    };
    for (const EGLint size :
         {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE, EGL_BUFFER_SIZE, EGL_DEPTH_SIZE,
          EGL_STENCIL_SIZE, EGL_SAMPLES, EGL_SAMPLE_BUFFERS, EGL_LUMINANCE_SIZE}) {
        cases.push_back({"a size below zero", EGL_BAD_ATTRIBUTE, [=, this] { return chooses({size, -2}); }});
        cases.push_back({"a size that does not matter", EGL_SUCCESS, [=, this] {
                             return chooses({size, EGL_DONT_CARE});
                         }});
    }
    for (const EGLint choice : {EGL_CONFIG_CAVEAT, EGL_COLOR_BUFFER_TYPE, EGL_TRANSPARENT_TYPE,
                                EGL_NATIVE_RENDERABLE, EGL_BIND_TO_TEXTURE_RGB, EGL_BIND_TO_TEXTURE_RGBA}) {
        cases.push_back({"no such choice", EGL_BAD_ATTRIBUTE, [=, this] {
                             return chooses({choice, 0x7777});
                         }});
        cases.push_back({"any choice", EGL_SUCCESS, [=, this] { return chooses({choice, EGL_DONT_CARE}); }});
    }
    check(cases);
    // Only those whose pixmaps have this depth.
    const EGLint list[] = {EGL_MATCH_NATIVE_PIXMAP, static_cast<EGLint>(pixmap), EGL_SURFACE_TYPE,
                           EGL_PIXMAP_BIT, EGL_NONE};
    EGLConfig found[200];
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(egl, list, found, 200, &count));
    EXPECT_GT(count, 0);
    for (int i = 0; i < count; ++i) EXPECT_TRUE(creates_pixmap(found[i], pixmap)) << i;
    XFreePixmap(x, pixmap);
}

TEST_F(EglErrors, OfContexts) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const EGLContext ctx = context(chosen), other = context(chosen);
    const EGLSurface one = pbuffer(chosen), two = pbuffer(chosen);
    EGLint value = 0;
    constexpr EGLint kMajor = EGL_CONTEXT_MAJOR_VERSION, kMinor = EGL_CONTEXT_MINOR_VERSION;
    check({
        {"a context", EGL_SUCCESS, [&] { return creates_context(chosen, {}); }},
        {"a context of OpenGL 1.5", EGL_SUCCESS,
         [&] {
             return creates_context(chosen, {kMajor, 1, kMinor, 5});
         }},
        {"of a configuration that is none", EGL_BAD_CONFIG, [&] { return creates_context(nowhere, {}); }},
        {"sharing with nothing", EGL_BAD_CONTEXT, [&] { return creates_context(chosen, {}, nowhere); }},
        {"an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {0x7777, 1});
         }},
        {"version 0", EGL_BAD_MATCH,
         [&] {
             return creates_context(chosen, {kMajor, 0});
         }},
        {"version 1.-1", EGL_BAD_MATCH,
         [&] {
             return creates_context(chosen, {kMinor, -1});
         }},
        {"version 9.9", EGL_BAD_MATCH,
         [&] {
             return creates_context(chosen, {kMajor, 9, kMinor, 9});
         }},
        {"a forward compatible one of old", EGL_BAD_MATCH,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_TRUE});
         }},
        {"forward compatible or what", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, 7});
         }},
        {"not forward compatible", EGL_SUCCESS,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_FALSE});
         }},
        {"debug or what", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_OPENGL_DEBUG, 7});
         }},
        {"unknown flags", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_FLAGS_KHR, 0x700});
         }},
        {"unknown notification", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, 7});
         }},
        {"unknown release", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_context(chosen, {EGL_CONTEXT_RELEASE_BEHAVIOR_KHR, 7});
         }},
        {"destroying nothing", EGL_BAD_CONTEXT, [&] { return eglDestroyContext(egl, nowhere); }},
        {"destroying EGL_NO_CONTEXT", EGL_BAD_CONTEXT,
         [&] { return eglDestroyContext(egl, EGL_NO_CONTEXT); }},
        {"query of nothing", EGL_BAD_CONTEXT,
         [&] { return eglQueryContext(egl, nowhere, EGL_CONFIG_ID, &value); }},
        {"query of an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] { return eglQueryContext(egl, ctx, 0x7777, &value); }},
        {"query to nowhere", EGL_BAD_PARAMETER,
         [&] { return eglQueryContext(egl, ctx, EGL_CONFIG_ID, nullptr); }},
        {"nothing made current", EGL_BAD_CONTEXT, [&] { return eglMakeCurrent(egl, one, one, nowhere); }},
        {"surfaces without a context", EGL_BAD_MATCH,
         [&] { return eglMakeCurrent(egl, one, one, EGL_NO_CONTEXT); }},
        {"only to draw to", EGL_BAD_MATCH, [&] { return eglMakeCurrent(egl, one, EGL_NO_SURFACE, ctx); }},
        {"only to read from", EGL_BAD_MATCH, [&] { return eglMakeCurrent(egl, EGL_NO_SURFACE, one, ctx); }},
        {"to draw nowhere", EGL_BAD_SURFACE, [&] { return eglMakeCurrent(egl, nowhere, one, ctx); }},
        {"to read nowhere", EGL_BAD_SURFACE, [&] { return eglMakeCurrent(egl, one, nowhere, ctx); }},
        {"swap interval of nothing", EGL_BAD_CONTEXT, [&] { return eglSwapInterval(egl, 1); }},
        {"no surface", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx); }},
        {"swap interval of no surface", EGL_BAD_SURFACE, [&] { return eglSwapInterval(egl, 1); }},
        {"all is well", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, one, two, ctx); }},
        {"swap interval", EGL_SUCCESS, [&] { return eglSwapInterval(egl, 0); }},
        {"an unknown engine", EGL_BAD_PARAMETER, [&] { return eglWaitNative(0x7777); }},
    });
    std::thread([&] {
        eglBindAPI(EGL_OPENGL_API);
        const EGLSurface own = pbuffer(chosen);
        check({
            {"a context of another thread", EGL_BAD_ACCESS,
             [&] { return eglMakeCurrent(egl, own, own, ctx); }},
            {"a surface that another thread draws to", EGL_BAD_ACCESS,
             [&] { return eglMakeCurrent(egl, one, own, other); }},
            {"a surface that another thread reads from", EGL_BAD_ACCESS,
             [&] { return eglMakeCurrent(egl, own, two, other); }},
            {"surfaces of its own", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, own, own, other); }},
            {"nobody else's buffers are swapped", EGL_BAD_SURFACE, [&] { return eglSwapBuffers(egl, one); }},
        });
        // Its end lets go of all.
    }).join();
    check({
        {"the other's context", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, two, one, other); }},
        {"back again", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, one, one, ctx); }},
    });
    std::thread([&] {
        check({{"what the other thread has let go of", EGL_SUCCESS,
                [&] { return eglMakeCurrent(egl, two, two, other); }}});
    }).join();
    EXPECT_EQ(eglGetCurrentContext(), ctx);
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), one);
}

TEST_F(EglErrors, OfSurfaces) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT),
                    deep = config(EGL_WINDOW_BIT, {EGL_ALPHA_SIZE, 8, EGL_BUFFER_SIZE, 32});
    const auto shown = window(chosen);
    const Pixmap pixmap = XCreatePixmap(x, shown->id(), 8, 8, 24),
                 flat = XCreatePixmap(x, shown->id(), 8, 8, 1);
    Window no_window = 0x1234567;
    const EGLSurface surface = pbuffer(chosen),
                     taken = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr);
    ASSERT_NE(taken, EGL_NO_SURFACE);
    const auto other = window(chosen);
    EGLint value = 0;
    check({
        {"a window", EGL_SUCCESS, [&] { return creates_window(chosen, other->id()); }},
        {"a window of a configuration that is none", EGL_BAD_CONFIG,
         [&] { return creates_window(nowhere, other->id()); }},
        {"a window that is none", EGL_BAD_NATIVE_WINDOW, [&] { return creates_window(chosen, 0x1234567); }},
        {"a pixmap for a window", EGL_BAD_NATIVE_WINDOW, [&] { return creates_window(chosen, pixmap); }},
        {"a platform's window that is none", EGL_BAD_NATIVE_WINDOW,
         [&] { return eglCreatePlatformWindowSurface(egl, chosen, &no_window, nullptr) != nullptr; }},
        {"no window's address", EGL_BAD_NATIVE_WINDOW,
         [&] { return eglCreatePlatformWindowSurface(egl, chosen, nullptr, nullptr) != nullptr; }},
        {"a window that has a surface", EGL_BAD_ALLOC, [&] { return creates_window(chosen, shown->id()); }},
        {"an unknown attribute of a window", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_window(chosen, other->id(), {0x7777, 1});
         }},
        {"no buffer to draw to", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_window(chosen, other->id(), {EGL_RENDER_BUFFER, 0x7777});
         }},
        {"colours that are not linear", EGL_BAD_MATCH,
         [&] {
             return creates_window(chosen, other->id(), {EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB});
         }},
        {"a pixmap", EGL_SUCCESS, [&] { return creates_pixmap(chosen, pixmap); }},
        {"a pixmap of a configuration that is none", EGL_BAD_CONFIG,
         [&] { return creates_pixmap(nowhere, pixmap); }},
        {"a pixmap that is none", EGL_BAD_NATIVE_PIXMAP, [&] { return creates_pixmap(chosen, 0x1234567); }},
        {"a window for a pixmap", EGL_BAD_NATIVE_PIXMAP, [&] { return creates_pixmap(chosen, other->id()); }},
        {"a pixmap of another depth", EGL_BAD_MATCH, [&] { return creates_pixmap(chosen, flat); }},
        {"a pixmap asked for a back buffer", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_pixmap(chosen, pixmap, {EGL_RENDER_BUFFER, EGL_BACK_BUFFER});
         }},
        {"a pbuffer", EGL_SUCCESS,
         [&] {
             return creates_pbuffer(chosen, {EGL_WIDTH, 3, EGL_HEIGHT, 4});
         }},
        {"a pbuffer of a configuration that is none", EGL_BAD_CONFIG,
         [&] { return creates_pbuffer(nowhere, {}); }},
        {"a pbuffer of negative width", EGL_BAD_PARAMETER,
         [&] {
             return creates_pbuffer(chosen, {EGL_WIDTH, -1});
         }},
        {"a pbuffer of negative height", EGL_BAD_PARAMETER,
         [&] {
             return creates_pbuffer(chosen, {EGL_HEIGHT, -1});
         }},
        {"a pbuffer that is too wide", EGL_BAD_ALLOC,
         [&] {
             return creates_pbuffer(chosen, {EGL_WIDTH, 16385});
         }},
        {"a pbuffer that is too high", EGL_BAD_ALLOC,
         [&] {
             return creates_pbuffer(chosen, {EGL_HEIGHT, 16385});
         }},
        {"the largest that goes", EGL_SUCCESS,
         [&] {
             return creates_pbuffer(chosen, {EGL_WIDTH, 20000, EGL_HEIGHT, 1, EGL_LARGEST_PBUFFER, EGL_TRUE});
         }},
        {"a pbuffer as a texture", EGL_BAD_MATCH,
         [&] {
             return creates_pbuffer(chosen, {EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB});
         }},
        {"an unknown attribute of a pbuffer", EGL_BAD_ATTRIBUTE,
         [&] {
             return creates_pbuffer(chosen, {0x7777, 1});
         }},
        {"a client's buffer", EGL_BAD_PARAMETER,
         [&] {
             return eglCreatePbufferFromClientBuffer(egl, EGL_OPENVG_IMAGE, nowhere, chosen, nullptr) !=
                    nullptr;
         }},
        {"destroying nothing", EGL_BAD_SURFACE, [&] { return eglDestroySurface(egl, nowhere); }},
        {"query of nothing", EGL_BAD_SURFACE,
         [&] { return eglQuerySurface(egl, nowhere, EGL_WIDTH, &value); }},
        {"query of an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] { return eglQuerySurface(egl, surface, 0x7777, &value); }},
        {"query to nowhere", EGL_BAD_PARAMETER,
         [&] { return eglQuerySurface(egl, surface, EGL_WIDTH, nullptr); }},
        {"age of what is not drawn to", EGL_BAD_SURFACE,
         [&] { return eglQuerySurface(egl, taken, EGL_BUFFER_AGE_EXT, &value); }},
        {"attribute of nothing", EGL_BAD_SURFACE,
         [&] { return eglSurfaceAttrib(egl, nowhere, EGL_MIPMAP_LEVEL, 0); }},
        {"an attribute that is for asking", EGL_BAD_ATTRIBUTE,
         [&] { return eglSurfaceAttrib(egl, surface, EGL_WIDTH, 3); }},
        {"no behaviour of swaps", EGL_BAD_PARAMETER,
         [&] { return eglSurfaceAttrib(egl, surface, EGL_SWAP_BEHAVIOR, 0x7777); }},
        {"resolving by a filter", EGL_BAD_MATCH,
         [&] {
             return eglSurfaceAttrib(egl, surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX);
         }},
        {"swapping nothing", EGL_BAD_SURFACE, [&] { return eglSwapBuffers(egl, nowhere); }},
        {"swapping what is not drawn to", EGL_BAD_SURFACE, [&] { return eglSwapBuffers(egl, taken); }},
        {"copying nothing", EGL_BAD_SURFACE, [&] { return eglCopyBuffers(egl, nowhere, pixmap); }},
        {"copying what is not drawn to", EGL_BAD_SURFACE,
         [&] { return eglCopyBuffers(egl, surface, pixmap); }},
        {"binding nothing", EGL_BAD_SURFACE, [&] { return eglBindTexImage(egl, nowhere, EGL_BACK_BUFFER); }},
        {"binding no texture", EGL_BAD_MATCH, [&] { return eglBindTexImage(egl, surface, EGL_BACK_BUFFER); }},
        {"binding no buffer", EGL_BAD_PARAMETER, [&] { return eglBindTexImage(egl, surface, 0x7777); }},
        {"letting go of nothing", EGL_BAD_SURFACE,
         [&] { return eglReleaseTexImage(egl, nowhere, EGL_BACK_BUFFER); }},
    });
    ASSERT_TRUE(eglMakeCurrent(egl, taken, taken, context(chosen)));
    const EGLint damage[] = {0, 0, 1, 1};
    const auto swap =
        command<EGLBoolean(EGLDisplay, EGLSurface, const EGLint*, EGLint)>("eglSwapBuffersWithDamageKHR");
    check({
        {"damage of less than nothing", EGL_BAD_PARAMETER, [&] { return swap(egl, taken, damage, -1); }},
        {"damage somewhere", EGL_BAD_PARAMETER, [&] { return swap(egl, taken, nullptr, 1); }},
        {"damage", EGL_SUCCESS, [&] { return swap(egl, taken, damage, 1); }},
        {"a copy to nothing", EGL_BAD_NATIVE_PIXMAP, [&] { return eglCopyBuffers(egl, taken, 0x1234567); }},
        {"a copy to a window", EGL_BAD_NATIVE_PIXMAP,
         [&] { return eglCopyBuffers(egl, taken, other->id()); }},
        {"a copy to a pixmap of another size", EGL_BAD_MATCH,
         [&] { return eglCopyBuffers(egl, taken, pixmap); }},
        {"a copy to a pixmap of another depth", EGL_BAD_MATCH,
         [&] { return eglCopyBuffers(egl, taken, flat); }},
    });
    (void)deep;
    for (const Pixmap made : {pixmap, flat}) XFreePixmap(x, made);
}

// A window that is destroyed under its surface: EGL says so once it knows.
TEST_F(EglErrors, OfWindowsThatHaveGone) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    auto shown = window(chosen);
    const EGLSurface surface = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr),
                     spare = pbuffer(chosen);
    const EGLContext ctx = context(chosen);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
    clear_to(kRed);
    ASSERT_TRUE(eglSwapBuffers(egl, surface));
    shown.reset();
    eglSwapBuffers(egl, surface);  // may learn of it, or only ask
    check({
        {"swapping", EGL_BAD_NATIVE_WINDOW, [&] { return eglSwapBuffers(egl, surface); }},
        {"waiting for GL", EGL_BAD_CURRENT_SURFACE, [&] { return eglWaitClient(); }},
        {"waiting for X", EGL_BAD_CURRENT_SURFACE, [&] { return eglWaitNative(EGL_CORE_NATIVE_ENGINE); }},
        {"drawing elsewhere", EGL_SUCCESS, [&] { return eglMakeCurrent(egl, spare, spare, ctx); }},
        {"drawing there again", EGL_BAD_NATIVE_WINDOW,
         [&] { return eglMakeCurrent(egl, surface, surface, ctx); }},
        {"destroying it", EGL_SUCCESS, [&] { return eglDestroySurface(egl, surface); }},
    });
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), spare);
    clear_to(kGreen);
    EXPECT_EQ(read(1, 1), kGreen);
    const Pixmap pixmap = XCreatePixmap(x, DefaultRootWindow(x), 8, 8, 24);
    const EGLSurface lost = eglCreatePixmapSurface(egl, chosen, pixmap, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, lost, lost, ctx));
    clear_to(kRed);
    ASSERT_TRUE(eglMakeCurrent(egl, spare, spare, ctx));
    XFreePixmap(x, pixmap);
    XSync(x, 0);
    check({{"drawing to a pixmap that is freed", EGL_BAD_NATIVE_PIXMAP,
            [&] { return eglMakeCurrent(egl, lost, lost, ctx); }}});
}

TEST_F(EglErrors, OfFences) {
    open_surfaceless();
    const EGLConfig chosen = config(EGL_PBUFFER_BIT);
    const EGLint nothing_more[] = {EGL_NONE};
    const EGLAttrib unknown[] = {0x7777, 1, EGL_NONE}, none[] = {EGL_NONE};
    const auto create_khr = command<EGLSyncKHR(EGLDisplay, EGLenum, const EGLint*)>("eglCreateSyncKHR");
    const auto get_khr = command<EGLBoolean(EGLDisplay, EGLSyncKHR, EGLint, EGLint*)>("eglGetSyncAttribKHR");
    check({{"no context", EGL_BAD_MATCH,
            [&] { return eglCreateSync(egl, EGL_SYNC_FENCE, nullptr) != EGL_NO_SYNC; }}});
    const EGLSurface surface = pbuffer(chosen);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context(chosen)));
    const EGLSync sync = eglCreateSync(egl, EGL_SYNC_FENCE, none);
    ASSERT_NE(sync, EGL_NO_SYNC);
    EGLAttrib value = 99;
    EGLint integer = 99;
    check({
        {"an unknown type", EGL_BAD_PARAMETER,
         [&] { return eglCreateSync(egl, 0x7777, nullptr) != EGL_NO_SYNC; }},
        {"an unknown type, by the extension's name", EGL_BAD_ATTRIBUTE,
         [&] { return create_khr(egl, 0x7777, nullptr) != EGL_NO_SYNC; }},
        {"an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] { return eglCreateSync(egl, EGL_SYNC_FENCE, unknown) != EGL_NO_SYNC; }},
        {"one by the extension's name", EGL_SUCCESS,
         [&] { return create_khr(egl, EGL_SYNC_FENCE_KHR, nothing_more) != EGL_NO_SYNC; }},
        {"waiting for nothing", EGL_BAD_PARAMETER,
         [&] { return eglClientWaitSync(egl, nowhere, 0, 0) == EGL_CONDITION_SATISFIED; }},
        {"having GL wait for nothing", EGL_BAD_PARAMETER, [&] { return eglWaitSync(egl, nowhere, 0); }},
        {"having GL wait in an unknown way", EGL_BAD_PARAMETER, [&] { return eglWaitSync(egl, sync, 1); }},
        {"query of nothing", EGL_BAD_PARAMETER,
         [&] { return eglGetSyncAttrib(egl, nowhere, EGL_SYNC_TYPE, &value); }},
        {"query of an unknown attribute", EGL_BAD_ATTRIBUTE,
         [&] { return eglGetSyncAttrib(egl, sync, 0x7777, &value); }},
        {"query to nowhere", EGL_BAD_PARAMETER,
         [&] { return eglGetSyncAttrib(egl, sync, EGL_SYNC_TYPE, nullptr); }},
        {"destroying nothing", EGL_BAD_PARAMETER, [&] { return eglDestroySync(egl, nowhere); }},
    });
    EXPECT_EQ(value, 99);
    const std::pair<EGLint, EGLint> answers[] = {{EGL_SYNC_TYPE, EGL_SYNC_FENCE},
                                                 {EGL_SYNC_STATUS, EGL_SIGNALED},
                                                 {EGL_SYNC_CONDITION, EGL_SYNC_PRIOR_COMMANDS_COMPLETE}};
    for (const auto& [name, answer] : answers) {
        EXPECT_TRUE(eglGetSyncAttrib(egl, sync, name, &value));
        EXPECT_EQ(value, answer);
        EXPECT_TRUE(get_khr(egl, sync, name, &integer));
        EXPECT_EQ(integer, answer);
    }
    ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    check({
        {"having nobody wait", EGL_BAD_MATCH, [&] { return eglWaitSync(egl, sync, 0); }},
        {"waiting without a context", EGL_SUCCESS,
         [&] {
             return eglClientWaitSync(egl, sync, EGL_SYNC_FLUSH_COMMANDS_BIT, 0) == EGL_CONDITION_SATISFIED;
         }},
        {"destroying it", EGL_SUCCESS, [&] { return eglDestroySync(egl, sync); }},
        {"waiting for what is destroyed", EGL_BAD_PARAMETER,
         [&] { return eglClientWaitSync(egl, sync, 0, 0) == EGL_CONDITION_SATISFIED; }},
    });
}

}  // namespace
}  // namespace terrazzo::test
