// EGL where programs leave the usual ways: pixels of earlier frames, copies of what is still to be drawn,
// pixmaps, surfaces of every format.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "egl_fixture.h"
#include "pictures.h"

namespace terrazzo::test {
namespace {

class EglState : public Egl {
  protected:
    EGLint asked(EGLSurface surface, EGLint name) {
        EGLint out = 77;
        EXPECT_TRUE(eglQuerySurface(egl, surface, name, &out));
        return out;
    }
    EGLint render_buffer(EGLContext ctx) {
        EGLint out = 77;
        EXPECT_TRUE(eglQueryContext(egl, ctx, EGL_RENDER_BUFFER, &out));
        return out;
    }
};

TEST_F(EglState, TheAgeOfTheBackBufferSaysWhatIsInIt) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto shown = window(chosen, 40, 30);
    const EGLSurface surface = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context(chosen)));
    std::vector<Pixel> frames;
    std::vector<EGLint> ages;
    const auto next_frame = [&] {
        ages.push_back(asked(surface, EGL_BUFFER_AGE_EXT));
        if (ages.back() > 0) {
            ASSERT_LE(static_cast<std::size_t>(ages.back()), frames.size());
            EXPECT_EQ(read(20, 15), frames[frames.size() - static_cast<std::size_t>(ages.back())]);
        }
        const int n = static_cast<int>(frames.size());
        frames.push_back({n * 20 % 256, 255 - n * 10, n * 50 % 256});
        clear_to(frames.back());
        ASSERT_TRUE(eglSwapBuffers(egl, surface));
        EXPECT_EQ(shown->pixel(20, 15), frames.back());
    };
    for (int i = 0; i < 3; ++i) next_frame();
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(read(20, 15), frames.back());
    glReadBuffer(GL_BACK);
    for (int i = 0; i < 2; ++i) next_frame();
    EXPECT_EQ(ages, (std::vector<EGLint>{0, 1, 1, 1, 2}));
    shown->resize(50, 60);
    eglWaitNative(EGL_CORE_NATIVE_ENGINE);
    EXPECT_EQ(asked(surface, EGL_WIDTH), 50);
    EXPECT_EQ(asked(surface, EGL_HEIGHT), 60);
    frames.clear(), ages.clear();
    for (int i = 0; i < 2; ++i) next_frame();
    EXPECT_EQ(ages, (std::vector<EGLint>{0, 1}));
}

// What is queued is drawn before it is copied, whoever asked for what before.
TEST_F(EglState, CopiesHaveWhatWasDrawnLast) {
    constexpr int kWidth = 48, kHeight = 20;
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto shown = window(chosen, kWidth, kHeight);
    const EGLAttrib single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const Pixmap pixmap = XCreatePixmap(x, shown->id(), kWidth, kHeight, 24),
                 drawn_to = XCreatePixmap(x, shown->id(), kWidth, kHeight, 24);
    const EGLContext ctx = context(chosen);
    Window name = shown->id();
    const auto surfaces = {
        std::pair{"a pbuffer", pbuffer(chosen, kWidth, kHeight)},
        {"a pixmap", eglCreatePixmapSurface(egl, chosen, drawn_to, nullptr)},
        {"a single-buffered window", eglCreatePlatformWindowSurface(egl, chosen, &name, single)},
        {"a window", EGL_NO_SURFACE},
    };
    for (const auto& [what, made] : surfaces) {
        const EGLSurface surface = made ? made : eglCreateWindowSurface(egl, chosen, name, nullptr);
        ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx)) << what;
        for (int round = 0; round < 2; ++round) {
            clear_to(round ? kRed : kBlack);
            draw_pattern(kWidth, kHeight);
            glColor3f(0, 1, 0);
            glRectf(-1, -1, round ? 0 : -0.5f, 1);
            ASSERT_TRUE(eglCopyBuffers(egl, surface, pixmap)) << what;
            const int green = round ? kWidth / 2 : kWidth / 4;
            EXPECT_EQ(picture_of(x, pixmap, kWidth, kHeight).differing([&](int px, int py) {
                return px < green ? kGreen : pattern(px, py);
            }),
                      "")
                << what << " " << round;
            EXPECT_EQ(read(kWidth - 1, 3), pattern(kWidth - 1, 3)) << what;
        }
        ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
        ASSERT_TRUE(eglDestroySurface(egl, surface));
    }
    for (const Pixmap p : {pixmap, drawn_to}) XFreePixmap(x, p);
}

TEST_F(EglState, SurfacesSayWhichBufferIsDrawnTo) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const auto shown = window(chosen), other = window(chosen);
    XMoveWindow(x, other->id(), 200, 0);
    const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const Pixmap pixmap = XCreatePixmap(x, shown->id(), 8, 8, 24);
    const EGLContext ctx = context(chosen);
    EXPECT_EQ(render_buffer(ctx), EGL_NONE);
    const EGLSurface back = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr),
                     front = eglCreateWindowSurface(egl, chosen, other->id(), single),
                     hidden = pbuffer(chosen), kept = eglCreatePixmapSurface(egl, chosen, pixmap, nullptr);
    const std::pair<EGLSurface, EGLint> surfaces[] = {{back, EGL_BACK_BUFFER},
                                                      {front, EGL_SINGLE_BUFFER},
                                                      {hidden, EGL_BACK_BUFFER},
                                                      {kept, EGL_SINGLE_BUFFER}};
    for (const auto& [surface, buffer] : surfaces) {
        ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
        EXPECT_EQ(asked(surface, EGL_RENDER_BUFFER), buffer);
        EXPECT_EQ(render_buffer(ctx), buffer);
        clear_to(kGreen);
        glFlush();
        EXPECT_EQ(read(1, 1), kGreen);
        EXPECT_TRUE(eglSwapBuffers(egl, surface));
    }
    // The pixmap is the last; it has no back buffer to name.
    glDrawBuffer(GL_BACK);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glReadBuffer(GL_BACK);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(picture_of(x, pixmap, 8, 8).count(kGreen), 64);
    EXPECT_EQ(shown->pixel(3, 3), kGreen);
    EXPECT_EQ(other->pixel(3, 3), kGreen);
    XFreePixmap(x, pixmap);
}

TEST_F(EglState, AttributesOfSurfacesAreKept) {
    open_x();
    const EGLConfig chosen = config(EGL_WINDOW_BIT);
    const EGLint list[] = {EGL_WIDTH, 20000, EGL_HEIGHT, 2, EGL_LARGEST_PBUFFER, EGL_TRUE, EGL_NONE};
    const EGLSurface large = eglCreatePbufferSurface(egl, chosen, list), small = pbuffer(chosen, 3, 5);
    EXPECT_EQ(asked(large, EGL_WIDTH), 16384);
    EXPECT_EQ(asked(large, EGL_HEIGHT), 2);
    EXPECT_EQ(asked(large, EGL_LARGEST_PBUFFER), EGL_TRUE);
    EXPECT_EQ(asked(small, EGL_LARGEST_PBUFFER), EGL_FALSE);
    EXPECT_EQ(asked(small, EGL_WIDTH), 3);
    EXPECT_EQ(asked(small, EGL_HEIGHT), 5);
    EXPECT_EQ(asked(small, EGL_TEXTURE_FORMAT), EGL_NO_TEXTURE);
    EXPECT_EQ(asked(small, EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_LINEAR);
    EGLint id = 0;
    eglGetConfigAttrib(egl, chosen, EGL_CONFIG_ID, &id);
    EXPECT_EQ(asked(small, EGL_CONFIG_ID), id);
    for (const EGLint behavior : {EGL_BUFFER_DESTROYED, EGL_BUFFER_PRESERVED}) {
        EXPECT_TRUE(eglSurfaceAttrib(egl, small, EGL_SWAP_BEHAVIOR, behavior));
        EXPECT_EQ(asked(small, EGL_SWAP_BEHAVIOR), behavior);
    }
}

// Of the visuals that can be drawn to, one of each class and depth has configurations: the root window's, if
// it is one.
TEST_F(EglState, EveryLookOfTheScreenHasConfigurations) {
    open_x();
    EGLConfig all[200];
    EGLint count = 0;
    ASSERT_TRUE(eglGetConfigs(egl, all, 200, &count));
    using Look = std::pair<int, int>;  // class, depth
    std::map<Look, std::set<VisualID>> found;
    for (int i = 0; i < count; ++i) {
        EGLint id = 0, type = 0;
        EXPECT_TRUE(eglGetConfigAttrib(egl, all[i], EGL_NATIVE_VISUAL_ID, &id));
        EXPECT_TRUE(eglGetConfigAttrib(egl, all[i], EGL_NATIVE_VISUAL_TYPE, &type));
        XVisualInfo wanted{};
        wanted.visualid = static_cast<VisualID>(id);
        int visuals = 0;
        XVisualInfo* const visual = XGetVisualInfo(x, VisualIDMask, &wanted, &visuals);
        ASSERT_EQ(visuals, 1);
        EXPECT_EQ(visual->c_class, type);
        found[{visual->c_class, visual->depth}].insert(visual->visualid);
        XFree(visual);
    }
    std::set<Look> expected;
    XVisualInfo wanted{};
    wanted.screen = DefaultScreen(x);
    int visuals = 0;
    XVisualInfo* const known = XGetVisualInfo(x, VisualScreenMask, &wanted, &visuals);
    for (int i = 0; i < visuals; ++i) {
        const bool deep = known[i].depth >= 24 && known[i].green_mask == 0xff00;
        const bool flat = known[i].depth == 16 && known[i].green_mask == 0x7e0;
        const bool direct = known[i].c_class == TrueColor || known[i].c_class == DirectColor;
        if (direct && (deep || flat)) expected.insert({known[i].c_class, known[i].depth});
    }
    XFree(known);
    for (const Look& look : expected) EXPECT_EQ(found[look].size(), 1u) << look.first << ", " << look.second;
    EXPECT_EQ(found.size(), expected.size());
    const VisualID of_root = XVisualIDFromVisual(DefaultVisual(x, DefaultScreen(x)));
    EXPECT_TRUE((found[{TrueColor, DefaultDepth(x, DefaultScreen(x))}].count(of_root)));
}

TEST_F(EglState, SurfacesHaveTheFormatOfTheirConfiguration) {
    open_x();
    EGLConfig all[200];
    EGLint count = 0;
    ASSERT_TRUE(eglGetConfigs(egl, all, 200, &count));
    ASSERT_GT(count, 0);
    for (int i = 0; i < count; ++i) {
        const EGLConfig chosen = all[i];
        const auto value = [&](EGLint name) {
            EGLint out = -1;
            eglGetConfigAttrib(egl, chosen, name, &out);
            return out;
        };
        SCOPED_TRACE("configuration " + std::to_string(value(EGL_CONFIG_ID)));
        const Bits bits{value(EGL_RED_SIZE),   value(EGL_GREEN_SIZE), value(EGL_BLUE_SIZE),
                        value(EGL_ALPHA_SIZE), value(EGL_DEPTH_SIZE), value(EGL_STENCIL_SIZE),
                        value(EGL_SAMPLES)};
        EXPECT_EQ(value(EGL_BUFFER_SIZE), bits.red + bits.green + bits.blue + bits.alpha);
        const auto shown = window(chosen, kFormatSize, kFormatSize);
        XWindowAttributes attributes;
        XGetWindowAttributes(x, shown->id(), &attributes);
        const Pixmap pixmap =
            XCreatePixmap(x, shown->id(), kFormatSize, kFormatSize, static_cast<unsigned>(attributes.depth));
        const EGLSurface in_window = eglCreateWindowSurface(egl, chosen, shown->id(), nullptr),
                         hidden = pbuffer(chosen, kFormatSize, kFormatSize),
                         kept = eglCreatePixmapSurface(egl, chosen, pixmap, nullptr);
        const EGLContext ctx = context(chosen);
        for (const EGLSurface surface : {hidden, in_window, kept}) {
            ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, ctx));
            check_format(bits, surface == in_window);
            if (surface == hidden) continue;
            EXPECT_TRUE(eglSwapBuffers(egl, surface));  // without effect on a pixmap
            glFlush();
            check_shown_format(picture_of(x, surface == in_window ? shown->id() : pixmap, kFormatSize,
                                          kFormatSize, surface == in_window ? 0 : shown->id()),
                               bits);
        }
        ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
        EXPECT_TRUE(eglDestroyContext(egl, ctx));
        for (const EGLSurface surface : {hidden, in_window, kept})
            EXPECT_TRUE(eglDestroySurface(egl, surface));
        XFreePixmap(x, pixmap);
    }
}

}  // namespace
}  // namespace terrazzo::test
