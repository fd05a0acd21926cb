// EGL in several threads: a surface is current in one, and a display may be terminated, or its objects
// destroyed, whatever the others do. Run by on_display.py, and once more with the thread sanitizer.
#include <array>
#include <atomic>
#include <functional>
#include <thread>

#include "egl_fixture.h"

namespace terrazzo::test {
namespace {

class EglThreads : public Egl {
  protected:
    // Each body in a thread of its own, all at the same time, `turns` times.
    static void run(int turns, const std::vector<std::function<void()>>& bodies) {
        std::atomic<std::size_t> waiting = bodies.size();
        std::vector<std::thread> threads;
        for (const auto& body : bodies) {
            threads.emplace_back([&] {
                eglBindAPI(EGL_OPENGL_API);
                --waiting;
                while (waiting != 0) std::this_thread::yield();
                for (int turn = 0; turn < turns; ++turn) body();
                eglReleaseThread();
            });
        }
        for (std::thread& thread : threads) thread.join();
    }
};

TEST_F(EglThreads, ASurfaceIsCurrentInOne) {
    open_surfaceless();
    const EGLConfig of = config(EGL_PBUFFER_BIT);
    const EGLSurface surface = pbuffer(of), other = pbuffer(of);
    std::atomic<int> holders = 0, most = 0, refused = 0, made = 0;
    const auto body = [&](EGLContext context, bool reads) {
        return [&, context, reads] {
            const bool done = eglMakeCurrent(egl, reads ? other : surface, surface, context);
            if (!done) {
                refused += eglGetError() == EGL_BAD_ACCESS;
                return;
            }
            ++made;
            const int now = ++holders;
            if (now > most) most = now;
            glClear(GL_COLOR_BUFFER_BIT);
            glFinish();
            --holders;
            EXPECT_TRUE(eglMakeCurrent(egl, nullptr, nullptr, nullptr));
        };
    };
    constexpr int kTurns = 4000;
    run(kTurns, {body(context(of), false), body(context(of), false), body(context(of), true)});
    EXPECT_EQ(most, 1);
    EXPECT_GT(made, 0);
    EXPECT_EQ(made + refused, 3 * kTurns);
}

TEST_F(EglThreads, AContextIsCurrentInOne) {
    open_surfaceless();
    const EGLConfig of = config(EGL_PBUFFER_BIT);
    const EGLContext wanted = context(of);
    std::atomic<int> holders = 0, most = 0;
    const auto body = [&](EGLSurface surface) {
        return [&, surface] {
            if (!eglMakeCurrent(egl, surface, surface, wanted)) {
                EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
                return;
            }
            const int now = ++holders;
            if (now > most) most = now;
            EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
            EGLint buffer = 0;
            EXPECT_TRUE(eglQueryContext(egl, wanted, EGL_RENDER_BUFFER, &buffer));
            --holders;
            EXPECT_TRUE(eglMakeCurrent(egl, nullptr, nullptr, nullptr));
        };
    };
    run(4000, {body(pbuffer(of)), body(pbuffer(of)), body(pbuffer(of))});
    EXPECT_EQ(most, 1);
}

// What its threads are told while a display comes and goes is not looked at: it must not take them down.
class Terminated : public EglThreads, public testing::WithParamInterface<bool> {};

TEST_P(Terminated, WhileOthersDraw) {
    // The default display: EGL has a connection of its own.
    GetParam() ? open_surfaceless() : open(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    const auto draw = [&] {
        const EGLint list[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
        EGLConfig of = nullptr;
        EGLint count = 0, value = 0;
        if (!eglChooseConfig(egl, list, &of, 1, &count)) return;
        const EGLSurface surface = pbuffer(of);
        const EGLContext ctx = context(of);
        eglMakeCurrent(egl, surface, surface, ctx);
        glClear(GL_COLOR_BUFFER_BIT);
        eglSwapBuffers(egl, surface);
        eglQuerySurface(egl, surface, EGL_WIDTH, &value);
        eglSurfaceAttrib(egl, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED);
        eglGetConfigAttrib(egl, of, EGL_CONFIG_ID, &value);
        eglDestroySync(egl, eglCreateSync(egl, EGL_SYNC_FENCE, nullptr));
        eglDestroySurface(egl, surface);
        eglDestroyContext(egl, ctx);
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
    };
    run(GetParam() ? 1000 : 100, {draw, draw, [&] {
                                      EXPECT_TRUE(eglTerminate(egl));
                                      EXPECT_TRUE(eglInitialize(egl, nullptr, nullptr));
                                  }});
    EXPECT_NE(pbuffer(config(EGL_PBUFFER_BIT)), EGL_NO_SURFACE);
}

INSTANTIATE_TEST_SUITE_P(Displays, Terminated, testing::Bool(),
                         [](const auto& info) { return info.param ? "Surfaceless" : "Default"; });

TEST_F(EglThreads, OneMakesTheSurfaceOfAWindow) {
    XInitThreads();
    open_x();
    const EGLConfig of = config(EGL_WINDOW_BIT);
    const auto there = window(of);
    std::atomic<int> living = 0, most = 0;
    const auto body = [&] {
        const EGLSurface surface = eglCreateWindowSurface(egl, of, there->id(), nullptr);
        if (!surface) {
            EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
            return;
        }
        const int now = ++living;
        if (now > most) most = now;
        EGLint width = 0;  // asks the server: time for another thread
        EXPECT_TRUE(eglQuerySurface(egl, surface, EGL_WIDTH, &width));
        --living;
        EXPECT_TRUE(eglDestroySurface(egl, surface));
    };
    run(300, {body, body});
    EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace terrazzo::test
