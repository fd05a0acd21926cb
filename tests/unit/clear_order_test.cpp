// Clears of all or a part of the picture, before, between and after draws, leave what a model of single
// pixels says: whether a frame takes them together, drops what they hide, or puts them in its lists.
//
// TERRAZZO_CLEAR_SEED=n is one sequence; there are several without it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kWidth = 150, kHeight = 90;  // three by two bins, of which the last are cut

// What a pixel holds, in steps that every rounding leaves alone.
struct Pixel {
    int red = 0, depth = 0, stencil = 0;
    bool operator==(const Pixel&) const = default;
};
constexpr int kSteps = 5;  // of red and of depth

struct Rect {
    int x0 = 0, y0 = 0, x1 = kWidth, y1 = kHeight;
    bool has(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

class ClearOrderTest : public GlTest {
  protected:
    ClearOrderTest() : m_model(kWidth * kHeight) {}

    void begin(int seed, int samples) {
        m_random.seed(static_cast<unsigned>(seed));
        raster::TargetFormat format;
        format.samples = static_cast<std::uint8_t>(samples);
        attach_picture(ctx(), kWidth, kHeight, format);
        matrix_mode(ctx(), GL_PROJECTION);
        load_identity(ctx());
        ortho(ctx(), 0, kWidth, 0, kHeight, 0, -1);  // z is the depth
        enable(ctx(), GL_DEPTH_TEST);
        enable(ctx(), GL_STENCIL_TEST);
        stencil_func(ctx(), GL_ALWAYS, 0, 0xff);
        stencil_op(ctx(), GL_KEEP, GL_KEEP, GL_INCR);
        depth_func(ctx(), GL_LEQUAL);
        m_model.assign(m_model.size(), Pixel());
    }

    int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    Rect pick_rect() {
        // Edges of bins are what rectangles end at more often than anywhere else.
        const std::array<int, 5> xs{0, 40, 64, 128, kWidth}, ys{0, 21, 26, 64, kHeight};
        const auto i = static_cast<std::size_t>(pick(4)), j = static_cast<std::size_t>(pick(4));
        return {xs[i], ys[j], xs[i + 1 + static_cast<std::size_t>(pick(static_cast<int>(4 - i)))],
                ys[j + 1 + static_cast<std::size_t>(pick(static_cast<int>(4 - j)))]};
    }

    template <typename Change>
    void change(const Rect& rect, Change change) {
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) change(m_model[static_cast<std::size_t>(y * kWidth + x)]);
    }

    void clear_some(const Rect& rect, bool scissored) {
        const int red = pick(kSteps + 1), depth = pick(kSteps + 1), stencil = pick(200), planes = 1 + pick(7);
        if (scissored) {
            enable(ctx(), GL_SCISSOR_TEST);
            scissor(ctx(), rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0);
        }
        clear_color(ctx(), static_cast<float>(red) / kSteps, 0, 0, 1);
        clear_depth(ctx(), static_cast<double>(depth) / kSteps);
        clear_stencil(ctx(), stencil);
        clear(ctx(), (planes & 1 ? GL_COLOR_BUFFER_BIT : 0u) | (planes & 2 ? GL_DEPTH_BUFFER_BIT : 0u) |
                         (planes & 4 ? GL_STENCIL_BUFFER_BIT : 0u));
        disable(ctx(), GL_SCISSOR_TEST);
        change(rect, [&](Pixel& pixel) {
            if (planes & 1) pixel.red = red;
            if (planes & 2) pixel.depth = depth;
            if (planes & 4) pixel.stencil = stencil;
        });
    }

    void draw(const Rect& rect) {
        const int red = pick(kSteps + 1), depth = pick(kSteps + 1);
        glColor3f(static_cast<float>(red) / kSteps, 0, 0);
        const float z = static_cast<float>(depth) / kSteps;
        glBegin(GL_QUADS);
        glVertex3f(static_cast<float>(rect.x0), static_cast<float>(rect.y0), z);
        glVertex3f(static_cast<float>(rect.x1), static_cast<float>(rect.y0), z);
        glVertex3f(static_cast<float>(rect.x1), static_cast<float>(rect.y1), z);
        glVertex3f(static_cast<float>(rect.x0), static_cast<float>(rect.y1), z);
        glEnd();
        change(rect, [&](Pixel& pixel) {
            if (depth <= pixel.depth) pixel = {red, depth, std::min(pixel.stencil + 1, 255)};
        });
    }

    void step() {
        switch (pick(8)) {
            case 0:
            case 1:
                return clear_some({}, false);
            case 2:
            case 3:
                return clear_some(pick_rect(), true);
            case 4:
                return finish(ctx());
            default:
                return draw(pick_rect());
        }
    }

    void compare(const std::string& what) {
        std::vector<GLubyte> red(m_model.size()), stencil(m_model.size());
        std::vector<GLfloat> depth(m_model.size());
        pixel_storei(ctx(), GL_PACK_ALIGNMENT, 1);
        read_pixels(ctx(), 0, 0, kWidth, kHeight, GL_RED, GL_UNSIGNED_BYTE, red.data());
        read_pixels(ctx(), 0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
        read_pixels(ctx(), 0, 0, kWidth, kHeight, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        for (std::size_t i = 0; i < m_model.size(); ++i) {
            const Pixel pixel{red[i] * kSteps / 255, static_cast<int>(std::lrint(depth[i] * kSteps)),
                              stencil[i]};
            if (pixel == m_model[i]) continue;
            FAIL() << what << ": pixel " << i % kWidth << ' ' << i / kWidth << " is " << pixel.red << ' '
                   << pixel.depth << ' ' << pixel.stencil << ", not " << m_model[i].red << ' '
                   << m_model[i].depth << ' ' << m_model[i].stencil;
        }
    }

    std::vector<Pixel> m_model;
    std::mt19937 m_random;
};

TEST_F(ClearOrderTest, SequencesAgreeWithTheModel) {
    const char* const wanted = std::getenv("TERRAZZO_CLEAR_SEED");
    const int first = wanted ? std::atoi(wanted) : 1, count = wanted ? 1 : 60;
    std::cout << "TERRAZZO_CLEAR_SEED=" << first << " to " << first + count - 1 << '\n';
    for (int seed = first; seed < first + count && !HasFailure(); ++seed) {
        begin(seed, seed % 3 == 0 ? 4 : 1);
        clear_some({}, false);
        for (int picture = 0; picture < 3 && !HasFailure(); ++picture) {
            for (int steps = 1 + pick(8); steps > 0; --steps) step();
            compare("seed " + std::to_string(seed) + ", picture " + std::to_string(picture));
        }
    }
}

}  // namespace
}  // namespace terrazzo::gl
