// One drawable that contexts of several threads draw to, read from and show, while its size changes under
// them (GLX lets a window be current in any number of threads).
//
// What the pictures hold is undefined and not looked at, but for the last: nothing is corrupted, every thread
// comes to its end, and the drawable is good afterwards. The thread sanitizer, under which this runs in
// ./check, finds what memory's order happened to hide.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "gl/context.h"
#include "random.h"
#include "seed_of_run.h"

namespace terrazzo::gl {
namespace {

using stress::Random;
using stress::seed_of_run;

constexpr int kRounds = 80;
constexpr int kLargest = 150;  // three bins

// A window as front ends make them: it follows a size that somebody else has set.
class Window : public Drawable {
  public:
    explicit Window(const raster::TargetFormat& format) : Drawable(Buffering::kDouble), m_format(format) {
        allocate(64, 64, format);
    }
    void want_size(int width, int height) { m_wanted = width << 16 | height; }
    void follow_window(Follow) override {
        const Lock lock(mutex());
        const int wanted = m_wanted;
        if (wanted != 0 && !m_is_being_shown) allocate(wanted >> 16, wanted & 0xffff, m_format);
    }
    void show_front(Context& ctx) override { show(ctx, ColorBuffer::kFront); }
    void swap(Context& ctx) {
        const Lock lock(mutex());
        show(ctx, ColorBuffer::kBack);
        swap_pixels();
        picture_was_shown(ctx, *this);
        follow_drawables(ctx);
    }

  protected:
    void load_front() override {
        const std::vector<std::uint32_t> shown(static_cast<std::size_t>(width()) *
                                               static_cast<std::size_t>(height()));
        load_picture(*target(), plane_of(ColorBuffer::kFront), raster::PixelLayout::kRgba8,
                     reinterpret_cast<const std::byte*>(shown.data()), 4 * width());
    }

  private:
    void show(Context& ctx, ColorBuffer buffer) {
        const Lock lock(mutex());
        follow_drawables(ctx);
        m_is_being_shown = true;  // drawing what is queued must not change the size
        std::vector<std::byte> rows(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) *
                                    4);
        copy_picture(ctx, *this, buffer, raster::PixelLayout::kRgba8, rows.data(), 4 * width());
        m_is_being_shown = false;
    }

    const raster::TargetFormat m_format;
    std::atomic<int> m_wanted = 0;
    bool m_is_being_shown = false;
};

void draw_triangles(Random& random) {
    glColor3f(random.between(0, 1), random.between(0, 1), random.between(0, 1));
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 12; ++i)
        glVertex3f(random.between(-1.2f, 1.2f), random.between(-1.2f, 1.2f), random.between(-1, 1));
    glEnd();
}

GLenum any_buffer(Random& random) {
    static constexpr GLenum kBuffers[] = {GL_BACK, GL_FRONT, GL_FRONT_AND_BACK, GL_NONE};
    return random.one_of(kBuffers);
}

// Samples are not scaled.
void blit(Random& random) {
    GLint samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    const GLint width = 1 + random.below(kLargest), height = 1 + random.below(kLargest);
    const GLint scale = samples == 0 ? 1 + random.below(3) : 1;
    glBlitFramebuffer(0, 0, width, height, 0, 0, width / scale, height, GL_COLOR_BUFFER_BIT,
                      random.once_in(2) ? GL_NEAREST : GL_LINEAR);
}

// One of the things that a context does with what it draws to or reads from.
void use_window(Random& random, Window& window, Context& ctx) {
    static constexpr int kPixels = kLargest * kLargest;
    std::vector<float> pixels(kPixels);
    const auto size = [&] { return static_cast<GLsizei>(1 + random.below(kLargest)); };
    switch (random.below(14)) {
        case 0:
            return glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        case 1:
            return glClear(GL_COLOR_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
        case 2:
            return glReadPixels(0, 0, size(), size(), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        case 3:
            return glReadPixels(0, 0, size(), size(), GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
        case 4:
            glRasterPos2f(-1, -1);
            return glCopyPixels(0, 0, size(), size(), random.once_in(2) ? GL_COLOR : GL_DEPTH);
        case 5:
            return glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 64, 64, 0);
        case 6:
            return glAccum(random.once_in(2) ? GL_ACCUM : GL_LOAD, 0.5f);
        case 7:
            return glAccum(random.once_in(2) ? GL_RETURN : GL_MULT, 0.5f);
        case 8:
            return blit(random);
        case 9:
            return glDrawBuffer(any_buffer(random));
        case 10:
            return glReadBuffer(random.once_in(2) ? GL_FRONT : GL_BACK);
        case 11:
            return random.once_in(2) ? glFlush() : glFinish();
        case 12:
            return glViewport(0, 0, size(), size());
        default:
            return window.swap(ctx);
    }
}

class SharedDrawable : public testing::TestWithParam<int> {
  protected:
    // What a thread does again and again with a context that draws to one window and reads from the other.
    struct Part {
        std::shared_ptr<Window> draw, read;
        std::function<void(Random&, Context&)> body;
    };
    static void run(const std::vector<Part>& parts) {
        std::atomic<std::size_t> waiting = parts.size();
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            threads.emplace_back([&, i] {
                Random random(seed_of_run() + i);
                const auto ctx = new_context(parts[i].draw, parts[i].read);
                --waiting;
                while (waiting != 0) std::this_thread::yield();
                for (int round = 0; round < kRounds; ++round) parts[i].body(random, *ctx);
                EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "thread " << i;
                make_current(nullptr);
            });
        }
        for (std::thread& thread : threads) thread.join();
    }

    // Current in the calling thread.
    static std::unique_ptr<Context> new_context(std::shared_ptr<Window> draw, std::shared_ptr<Window> read) {
        Config config;
        config.double_buffered = true;
        config.accum_bits = 16;
        auto ctx = create_context(config, nullptr);
        attach_drawables(*ctx, std::move(draw), std::move(read));
        make_current(ctx.get());
        glEnable(GL_DEPTH_TEST);
        return ctx;
    }

    // The window that all drew to can be drawn to.
    static void expect_good(const std::shared_ptr<Window>& window) {
        window->want_size(80, 70);
        const auto ctx = new_context(window, window);
        glClearColor(0, 1, 0, 1);
        for (const GLenum buffer : {GL_FRONT, GL_BACK}) {
            glDrawBuffer(buffer);
            glReadBuffer(buffer);
            glClear(GL_COLOR_BUFFER_BIT);
            std::array<std::array<GLubyte, 4>, 80 * 70> pixels{};
            glReadPixels(0, 0, 80, 70, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
            const std::array<GLubyte, 4> green{0, 255, 0, 255};
            EXPECT_EQ(std::count(pixels.begin(), pixels.end(), green), 80 * 70);
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        make_current(nullptr);
    }

    static raster::TargetFormat format() {
        raster::TargetFormat out;
        out.samples = static_cast<std::uint8_t>(GetParam());
        return out;
    }
};

TEST_P(SharedDrawable, IsDrawnToReadAndShownWhileItsSizeChanges) {
    const auto window = std::make_shared<Window>(format());
    const auto body = [&](Random& random, Context& ctx) {
        draw_triangles(random);
        use_window(random, *window, ctx);
        if (random.once_in(4)) window->want_size(1 + random.below(kLargest), 1 + random.below(kLargest));
    };
    run({{window, window, body}, {window, window, body}, {window, window, body}});
    expect_good(window);
}

// Each thread's target is the other's source: whoever takes both must not wait for the other for ever.
TEST_P(SharedDrawable, AreCopiedToEachOtherByTwoThreads) {
    const auto one = std::make_shared<Window>(format()), other = std::make_shared<Window>(format());
    const auto copy_to = [](Window& window) {
        return [&](Random& random, Context& ctx) {
            draw_triangles(random);
            glBlitFramebuffer(0, 0, 64, 64, 0, 0, 64, 64, GL_COLOR_BUFFER_BIT, GL_NEAREST);
            glRasterPos2f(-1, -1);
            glCopyPixels(0, 0, 64, 64, GL_COLOR);
            if (random.coin()) glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 64, 64, 0);
            if (random.once_in(4)) window.swap(ctx);
        };
    };
    run({{one, other, copy_to(*one)}, {other, one, copy_to(*other)}});
    expect_good(one);
    expect_good(other);
}

INSTANTIATE_TEST_SUITE_P(Samples, SharedDrawable, testing::Values(1, 4));

}  // namespace
}  // namespace terrazzo::gl
