// The errors of GLX 1.4 and of its extensions, a table of calls and what the program's handler hears of each.
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>

#include "glx_fixture.h"

namespace terrazzo::test {
namespace {

// glxproto.h's numbers, whose header does not go with a program's.
enum GlxError {
    kBadContext,
    kBadContextState,
    kBadDrawable,
    kBadPixmap,
    kBadContextTag,
    kBadCurrentWindow,
    kBadRenderRequest,
    kBadLargeRequest,
    kUnsupportedPrivateRequest,
    kBadFBConfig,
    kBadPbuffer,
    kBadCurrentDrawable,
    kBadWindow
};

class GlxErrors : public Glx {
  protected:
    struct Case {
        const char* what;
        int error;  // 0: none
        std::function<void()> call;
    };

    // GLX's errors have the numbers that the server gave them; one without GLX has none, and the nearest core
    // error takes their place.
    int glx(GlxError error) const {
        int opcode = 0, event = 0, first = 0;
        if (XQueryExtension(display, "GLX", &opcode, &event, &first)) return first + error;
        switch (error) {
            case kBadDrawable:
            case kBadPbuffer:
                return BadDrawable;
            case kBadPixmap:
                return BadPixmap;
            case kBadWindow:
                return BadWindow;
            default:
                return BadValue;
        }
    }
    void check(const std::vector<Case>& cases) {
        for (const Case& c : cases) {
            take_x_error();
            c.call();
            EXPECT_EQ(take_x_error(), c.error) << c.what;
        }
    }
    GLXPbuffer pbuffer(std::vector<int> list) {
        list.push_back(kNone);
        return glXCreatePbuffer(display, double_buffered(), list.data());
    }
    // A configuration whose drawables have another depth of colour than the root window's, or null.
    GLXFBConfig of_other_depth() {
        int count = 0;
        GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
        GLXFBConfig out = nullptr;
        for (int i = 0; i < count && !out; ++i) {
            XVisualInfo* const visual = glXGetVisualFromFBConfig(display, all[i]);
            if (visual && visual->depth != DefaultDepth(display, DefaultScreen(display))) out = all[i];
            XFree(visual);
        }
        XFree(all);
        return out;
    }

    static constexpr XID kNowhere = 0x1234567;
    const GLXContext no_context = reinterpret_cast<GLXContext>(0x12345670);
    const GLXFBConfig no_config = reinterpret_cast<GLXFBConfig>(0x12345670);
};

TEST_F(GlxErrors, OfContexts) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen), other = context(chosen);
    int value = 0;
    check({
        {"a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_EQ(glXCreateNewContext(display, no_config, GLX_RGBA_TYPE, nullptr, 1), nullptr); }},
        {"an unknown render type", BadValue,
         [&] { EXPECT_EQ(glXCreateNewContext(display, chosen, 0x7777, nullptr, 1), nullptr); }},
        {"a render type that no configuration has", BadMatch,
         [&] { EXPECT_EQ(glXCreateNewContext(display, chosen, GLX_COLOR_INDEX_TYPE, nullptr, 1), nullptr); }},
        {"sharing with nothing", glx(kBadContext),
         [&] { EXPECT_EQ(glXCreateNewContext(display, chosen, GLX_RGBA_TYPE, no_context, 1), nullptr); }},
        {"destroying nothing", glx(kBadContext), [&] { glXDestroyContext(display, no_context); }},
        {"directness of nothing", glx(kBadContext), [&] { EXPECT_FALSE(glXIsDirect(display, no_context)); }},
        {"query of nothing", glx(kBadContext),
         [&] { EXPECT_NE(glXQueryContext(display, no_context, GLX_SCREEN, &value), 0); }},
        {"copy from nothing", glx(kBadContext),
         [&] { glXCopyContext(display, no_context, ctx, GL_LINE_BIT); }},
        {"copy to nothing", glx(kBadContext), [&] { glXCopyContext(display, ctx, no_context, GL_LINE_BIT); }},
        {"nothing made current", glx(kBadContext),
         [&] { EXPECT_FALSE(glXMakeCurrent(display, shown->id(), no_context)); }},
        {"drawable without a context", BadMatch,
         [&] { EXPECT_FALSE(glXMakeCurrent(display, shown->id(), nullptr)); }},
        {"only to draw to", BadMatch,
         [&] { EXPECT_FALSE(glXMakeContextCurrent(display, shown->id(), 0, ctx)); }},
        {"only to read from", BadMatch,
         [&] { EXPECT_FALSE(glXMakeContextCurrent(display, 0, shown->id(), ctx)); }},
        {"to draw nowhere", glx(kBadDrawable), [&] { EXPECT_FALSE(glXMakeCurrent(display, kNowhere, ctx)); }},
        {"to read nowhere", glx(kBadDrawable),
         [&] { EXPECT_FALSE(glXMakeContextCurrent(display, shown->id(), kNowhere, ctx)); }},
        {"all is well", 0, [&] { EXPECT_TRUE(glXMakeCurrent(display, shown->id(), ctx)); }},
        {"current in another thread", BadAccess,
         [&] { std::thread([&] { EXPECT_FALSE(glXMakeCurrent(display, shown->id(), ctx)); }).join(); }},
        {"copy from a context of another thread", BadAccess,
         [&] { std::thread([&] { glXCopyContext(display, ctx, other, GL_LINE_BIT); }).join(); }},
        {"copy to the current context", BadAccess, [&] { glXCopyContext(display, other, ctx, GL_LINE_BIT); }},
    });
    EXPECT_EQ(glXQueryContext(display, ctx, 0x7777, &value), GLX_BAD_ATTRIBUTE);
    EXPECT_EQ(glXGetCurrentContext(), ctx);
    EXPECT_EQ(glXGetCurrentDrawable(), shown->id());
    for (const GLXContext made : {ctx, other}) glXDestroyContext(display, made);
}

TEST_F(GlxErrors, OfContextsOfAnotherDisplay) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    Display* const other = XOpenDisplay(nullptr);
    int count = 0;
    GLXFBConfig* const its = glXGetFBConfigs(other, DefaultScreen(other), &count);
    ASSERT_GT(count, 0);
    const GLXContext foreign = glXCreateNewContext(other, its[0], GLX_RGBA_TYPE, nullptr, 1);
    check({
        {"a context of another display", BadMatch,
         [&] { EXPECT_FALSE(glXMakeCurrent(display, shown->id(), foreign)); }},
        {"a context of another display, without drawables", BadMatch,
         [&] { EXPECT_FALSE(glXMakeContextCurrent(display, 0, 0, foreign)); }},
        {"copy from a context of another display", BadMatch,
         [&] { glXCopyContext(display, foreign, ctx, GL_LINE_BIT); }},
        {"a configuration of another display", glx(kBadFBConfig),
         [&] { EXPECT_EQ(context(its[0]), nullptr); }},
    });
    EXPECT_EQ(glXGetCurrentContext(), nullptr);
    glXDestroyContext(other, foreign);
    glXDestroyContext(display, ctx);
    XFree(its);
    XCloseDisplay(other);
}

// The numbers are those of GLX's protocol.
TEST_F(GlxErrors, NameTheRequestAndWhatItWasAbout) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    unsigned answer = 0;
    struct Named {
        const char* what;
        int request;
        XID resource;
        std::function<void()> call;
    };
    std::vector<Named> cases = {
        {"only to draw to", 26, 0, [&] { glXMakeContextCurrent(display, shown->id(), 0, ctx); }},
        {"to draw nowhere", 5, kNowhere, [&] { glXMakeCurrent(display, kNowhere, ctx); }},
        {"to read nowhere", 26, kNowhere,
         [&] { glXMakeContextCurrent(display, shown->id(), kNowhere, ctx); }},
        {"a window that is none", 31, kNowhere, [&] { glXCreateWindow(display, chosen, kNowhere, nullptr); }},
        {"a pixmap that is none", 22, kNowhere, [&] { glXCreatePixmap(display, chosen, kNowhere, nullptr); }},
        {"query of nothing", 29, kNowhere, [&] { glXQueryDrawable(display, kNowhere, GLX_WIDTH, &answer); }},
        {"destroying no window", 32, kNowhere, [&] { glXDestroyWindow(display, kNowhere); }},
        {"destroying no pixmap", 23, kNowhere, [&] { glXDestroyPixmap(display, kNowhere); }},
        {"destroying no pbuffer", 28, kNowhere, [&] { glXDestroyPbuffer(display, kNowhere); }},
        {"swapping nothing", 11, kNowhere, [&] { glXSwapBuffers(display, kNowhere); }},
    };
    for (const Named& c : cases) {
        take_x_error();
        last_x_error_request = 77;
        last_x_error_resource = 77;
        c.call();
        EXPECT_NE(take_x_error(), 0) << c.what;
        EXPECT_EQ(last_x_error_request, c.request) << c.what;
        EXPECT_EQ(last_x_error_resource, c.resource) << c.what;
    }
    glXDestroyContext(display, ctx);
}

TEST_F(GlxErrors, OfDrawables) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const Pixmap pixmap = XCreatePixmap(display, shown->id(), 8, 8, 24),
                 flat = XCreatePixmap(display, shown->id(), 8, 8, 1);
    const GLXPbuffer hidden = pbuffer({GLX_PBUFFER_WIDTH, 4, GLX_PBUFFER_HEIGHT, 4});
    const GLXWindow named = glXCreateWindow(display, chosen, shown->id(), nullptr);
    const GLXPixmap kept = glXCreatePixmap(display, chosen, pixmap, nullptr);
    ASSERT_TRUE(hidden && named && kept);
    const int unknown[] = {0x7777, 1, kNone};
    int value = 0;
    unsigned answer = 0;
    unsigned long mask = 0;
    check({
        {"attribute of a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_NE(glXGetFBConfigAttrib(display, no_config, GLX_RED_SIZE, &value), 0); }},
        {"visual of a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_EQ(glXGetVisualFromFBConfig(display, no_config), nullptr); }},
        {"window of a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_EQ(glXCreateWindow(display, no_config, shown->id(), nullptr), 0u); }},
        {"pixmap of a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_EQ(glXCreatePixmap(display, no_config, pixmap, nullptr), 0u); }},
        {"pbuffer of a configuration that is none", glx(kBadFBConfig),
         [&] { EXPECT_EQ(glXCreatePbuffer(display, no_config, nullptr), 0u); }},
        {"a window that is none", BadWindow,
         [&] { EXPECT_EQ(glXCreateWindow(display, chosen, kNowhere, nullptr), 0u); }},
        {"a pixmap for a window", BadWindow,
         [&] { EXPECT_EQ(glXCreateWindow(display, chosen, pixmap, nullptr), 0u); }},
        {"a pixmap that is none", BadPixmap,
         [&] { EXPECT_EQ(glXCreatePixmap(display, chosen, kNowhere, nullptr), 0u); }},
        {"a window for a pixmap", BadPixmap,
         [&] { EXPECT_EQ(glXCreatePixmap(display, chosen, shown->id(), nullptr), 0u); }},
        {"a pixmap of another depth", BadMatch,
         [&] { EXPECT_EQ(glXCreatePixmap(display, chosen, flat, nullptr), 0u); }},
        {"an unknown attribute of a window", BadValue,
         [&] { EXPECT_EQ(glXCreateWindow(display, chosen, shown->id(), unknown), 0u); }},
        {"an unknown attribute of a pixmap", BadValue,
         [&] { EXPECT_EQ(glXCreatePixmap(display, chosen, pixmap, unknown), 0u); }},
        {"an unknown attribute of a pbuffer", BadValue,
         [&] { EXPECT_EQ(glXCreatePbuffer(display, chosen, unknown), 0u); }},
        {"a pbuffer of negative width", BadValue,
         [&] {
             EXPECT_EQ(pbuffer({GLX_PBUFFER_WIDTH, -1}), 0u);
         }},
        {"a pbuffer of negative height", BadValue,
         [&] {
             EXPECT_EQ(pbuffer({GLX_PBUFFER_HEIGHT, -1}), 0u);
         }},
        {"a pbuffer that is too wide", BadAlloc,
         [&] {
             EXPECT_EQ(pbuffer({GLX_PBUFFER_WIDTH, 16385}), 0u);
         }},
        {"a pbuffer that is too high", BadAlloc,
         [&] {
             EXPECT_EQ(pbuffer({GLX_PBUFFER_HEIGHT, 16385}), 0u);
         }},
        {"destroying no window", glx(kBadWindow), [&] { glXDestroyWindow(display, kNowhere); }},
        {"destroying no pixmap", glx(kBadPixmap), [&] { glXDestroyPixmap(display, kNowhere); }},
        {"destroying no pbuffer", glx(kBadPbuffer), [&] { glXDestroyPbuffer(display, kNowhere); }},
        {"swapping nothing", glx(kBadDrawable), [&] { glXSwapBuffers(display, kNowhere); }},
        {"query of nothing", glx(kBadDrawable),
         [&] { glXQueryDrawable(display, kNowhere, GLX_WIDTH, &answer); }},
        {"query of an unknown attribute", BadValue,
         [&] { glXQueryDrawable(display, hidden, 0x7777, &answer); }},
        {"events of nothing", glx(kBadDrawable), [&] { glXSelectEvent(display, kNowhere, 1); }},
        {"selected events of nothing", glx(kBadDrawable),
         [&] { glXGetSelectedEvent(display, kNowhere, &mask); }},
        {"all of them still there", 0,
         [&] {
             for (const GLXDrawable name : {hidden, named, kept})
                 glXQueryDrawable(display, name, GLX_WIDTH, &answer);
         }},
    });
    const GLXPbuffer largest =
        pbuffer({GLX_PBUFFER_WIDTH, 20000, GLX_PBUFFER_HEIGHT, 1, GLX_LARGEST_PBUFFER, 1});
    glXQueryDrawable(display, largest, GLX_WIDTH, &answer);
    EXPECT_EQ(answer, 16384u);
    glXQueryDrawable(display, largest, GLX_LARGEST_PBUFFER, &answer);
    EXPECT_EQ(answer, 1u);
    glXQueryDrawable(display, hidden, GLX_LARGEST_PBUFFER, &answer);
    EXPECT_EQ(answer, 0u);
    for (const unsigned preserved : {0u, 1u}) {
        const GLXPbuffer made =
            pbuffer({GLX_PRESERVED_CONTENTS, static_cast<int>(preserved), GLX_PBUFFER_WIDTH, 4,
                     GLX_PBUFFER_HEIGHT, 5, GLX_LARGEST_PBUFFER, 0});
        ASSERT_NE(made, 0u);
        const std::pair<int, unsigned> kept[] = {
            {GLX_PRESERVED_CONTENTS, preserved}, {GLX_WIDTH, 4}, {GLX_HEIGHT, 5}, {GLX_LARGEST_PBUFFER, 0}};
        for (const auto& [name, expected] : kept) {
            answer = 77;
            glXQueryDrawable(display, made, name, &answer);
            EXPECT_EQ(answer, expected) << name;
        }
        glXDestroyPbuffer(display, made);
    }
    glXSelectEvent(display, hidden, GLX_PBUFFER_CLOBBER_MASK);
    glXGetSelectedEvent(display, hidden, &mask);
    EXPECT_EQ(mask, static_cast<unsigned long>(GLX_PBUFFER_CLOBBER_MASK));
    EXPECT_EQ(take_x_error(), 0);
    check({
        {"destroyed once", 0, [&] { glXDestroyWindow(display, named); }},
        {"destroyed twice", glx(kBadWindow), [&] { glXDestroyWindow(display, named); }},
        {"a pbuffer destroyed", 0, [&] { glXDestroyPbuffer(display, largest); }},
        // libglvnd forgets them, whatever the vendor says: they come last.
        {"a pbuffer destroyed as a window", glx(kBadWindow), [&] { glXDestroyWindow(display, hidden); }},
        {"a pixmap destroyed as a pbuffer", glx(kBadPbuffer), [&] { glXDestroyPbuffer(display, kept); }},
        {"a window destroyed as a pixmap", glx(kBadPixmap),
         [&] { glXDestroyPixmap(display, glXCreateWindow(display, chosen, shown->id(), nullptr)); }},
        {"a window destroyed as a GLXPixmap", glx(kBadPixmap),
         [&] { glXDestroyGLXPixmap(display, glXCreateWindow(display, chosen, shown->id(), nullptr)); }},
    });
    for (const Pixmap made : {pixmap, flat}) XFreePixmap(display, made);
}

TEST_F(GlxErrors, OfDrawablesOfAnotherDepth) {
    const GLXFBConfig chosen = double_buffered(), deep = of_other_depth();
    if (!deep) GTEST_SKIP() << "all visuals have the depth of the root window's";
    const auto shown = window(chosen), other = window(deep);
    const GLXContext ctx = context(chosen);
    check({
        {"a window of another depth", BadMatch,
         [&] { EXPECT_EQ(glXCreateWindow(display, deep, shown->id(), nullptr), 0u); }},
        {"a window of the configuration's", 0,
         [&] { EXPECT_NE(glXCreateWindow(display, deep, other->id(), nullptr), 0u); }},
        {"current, though the context is of another depth", glx(kBadDrawable),
         [&] { EXPECT_FALSE(glXMakeCurrent(display, other->id(), ctx)); }},
    });
    glXDestroyContext(display, ctx);
}

TEST_F(GlxErrors, OfExtensions) {
    const GLXFBConfig chosen = single_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    const Pixmap pixmap = XCreatePixmap(display, shown->id(), 8, 8, 24);
    const GLXPixmap plain = glXCreatePixmap(display, chosen, pixmap, nullptr);
    const int list[] = {GLX_TEXTURE_FORMAT_EXT, GLX_TEXTURE_FORMAT_RGB_EXT, kNone};
    const GLXPixmap texture = glXCreatePixmap(display, chosen, pixmap, list);
    const auto bind = command<void(Display*, GLXDrawable, int, const int*)>("glXBindTexImageEXT");
    const auto release = command<void(Display*, GLXDrawable, int)>("glXReleaseTexImageEXT");
    const auto interval = command<void(Display*, GLXDrawable, int)>("glXSwapIntervalEXT");
    check({
        {"a window as a texture", glx(kBadPixmap),
         [&] { bind(display, shown->id(), GLX_FRONT_LEFT_EXT, nullptr); }},
        {"no such buffer", BadValue, [&] { bind(display, texture, 0x7777, nullptr); }},
        {"a pixmap that is no texture", BadMatch, [&] { bind(display, plain, GLX_FRONT_LEFT_EXT, nullptr); }},
        {"a pixmap that is one", 0, [&] { bind(display, texture, GLX_FRONT_LEFT_EXT, nullptr); }},
        {"a window let go of", glx(kBadPixmap), [&] { release(display, shown->id(), GLX_FRONT_LEFT_EXT); }},
        {"no such buffer let go of", BadValue, [&] { release(display, texture, 0x7777); }},
        {"a texture let go of", 0, [&] { release(display, texture, GLX_FRONT_LEFT_EXT); }},
        {"a texture of what has gone", BadDrawable,
         [&] {
             XFreePixmap(display, pixmap);
             XSync(display, 0);
             bind(display, texture, GLX_FRONT_LEFT_EXT, nullptr);
         }},
        {"an interval below zero", BadValue, [&] { interval(display, shown->id(), -1); }},
        {"an interval", 0, [&] { interval(display, shown->id(), 3); }},
    });
    unsigned value = 0;
    glXQueryDrawable(display, shown->id(), GLX_SWAP_INTERVAL_EXT, &value);
    EXPECT_EQ(value, 3u);
    const auto mesa = command<int(unsigned)>("glXSwapIntervalMESA");
    const auto sgi = command<int(int)>("glXSwapIntervalSGI");
    EXPECT_EQ(mesa(0x8000), GLX_BAD_VALUE);
    EXPECT_EQ(sgi(0), GLX_BAD_VALUE);
    EXPECT_EQ(sgi(-1), GLX_BAD_VALUE);
    glXQueryDrawable(display, shown->id(), GLX_SWAP_INTERVAL_EXT, &value);
    EXPECT_EQ(value, 3u);
    unsigned count = 0;
    const auto wait = command<int(int, int, unsigned*)>("glXWaitVideoSyncSGI");
    EXPECT_EQ(wait(0, 0, &count), GLX_BAD_VALUE);
    EXPECT_EQ(wait(2, 2, &count), GLX_BAD_VALUE);
    EXPECT_EQ(wait(2, -1, &count), GLX_BAD_VALUE);
    EXPECT_EQ(wait(2, 1, &count), 0);
    EXPECT_EQ(count % 2, 1u);
    ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
    // libglvnd answers itself where no context is current.
    if (!std::getenv("__GLX_VENDOR_LIBRARY_NAME")) {
        EXPECT_EQ(mesa(1), GLX_BAD_CONTEXT);
        EXPECT_EQ(sgi(1), GLX_BAD_CONTEXT);
    }
    glXDestroyContext(display, ctx);
}

TEST_F(GlxErrors, OfTheCountersOfSwaps) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen, 8, 8);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    const auto swap = command<std::int64_t(Display*, GLXDrawable, std::int64_t, std::int64_t, std::int64_t)>(
        "glXSwapBuffersMscOML");
    const auto wait_for_swaps =
        command<int(Display*, GLXDrawable, std::int64_t, std::int64_t*, std::int64_t*, std::int64_t*)>(
            "glXWaitForSbcOML");
    const auto wait = command<int(Display*, GLXDrawable, std::int64_t, std::int64_t, std::int64_t,
                                  std::int64_t*, std::int64_t*, std::int64_t*)>("glXWaitForMscOML");
    std::int64_t ust = 0, msc = 0, sbc = 0;
    EXPECT_EQ(swap(display, shown->id(), -1, 0, 0), -1);
    EXPECT_EQ(swap(display, shown->id(), 0, -1, 0), -1);
    EXPECT_EQ(swap(display, shown->id(), 0, 2, 2), -1);
    EXPECT_EQ(swap(display, shown->id(), 0, 2, -1), -1);
    EXPECT_EQ(swap(display, shown->id(), 0, 0, 0), 1);
    EXPECT_EQ(swap(display, shown->id(), 0, 2, 1), 2);
    EXPECT_FALSE(wait(display, shown->id(), 0, 3, 3, &ust, &msc, &sbc));
    ASSERT_TRUE(wait(display, shown->id(), 0, 3, 2, &ust, &msc, &sbc));
    const std::int64_t reached = msc;
    ASSERT_TRUE(wait(display, shown->id(), reached + 2, 0, 0, &ust, &msc, &sbc));
    EXPECT_GE(msc, reached + 2);
    EXPECT_EQ(sbc, 2);
    EXPECT_TRUE(wait_for_swaps(display, shown->id(), 2, &ust, &msc, &sbc));
    // A target that lies ahead is waited for.
    const std::int64_t ahead = msc + 3;
    EXPECT_EQ(swap(display, shown->id(), ahead, 0, 0), 3);
    EXPECT_TRUE(wait_for_swaps(display, shown->id(), 3, &ust, &msc, &sbc));
    EXPECT_GE(msc, ahead);
    EXPECT_FALSE(wait_for_swaps(display, shown->id(), 4, &ust, &msc, &sbc));
    EXPECT_FALSE(wait_for_swaps(display, shown->id(), -1, &ust, &msc, &sbc));
    glXDestroyContext(display, ctx);
}

}  // namespace
}  // namespace terrazzo::test
