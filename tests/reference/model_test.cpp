// The model of doc/reference.md against the library itself: random triangles, lines and points, every pixel's
// coverage, colour bits and depth. This is the proof that the page says what the library does.

#include "model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "osmesa.h"

namespace {

namespace model = terrazzo::test::model;
using model::Float4;

constexpr int kWidth = 96;
constexpr int kHeight = 80;

class Model : public testing::TestWithParam<GLenum> {
  protected:
    Model() : m_gl(kWidth, kHeight, GL_FLOAT) {}

    void SetUp() override {
        if (!m_gl.missing().empty()) GTEST_SKIP() << m_gl.missing();
        TERRAZZO_GL(m_gl, glEnable)(GL_DEPTH_TEST);
        TERRAZZO_GL(m_gl, glDepthFunc)(GL_ALWAYS);
        TERRAZZO_GL(m_gl, glEnable)(GL_POLYGON_OFFSET_FILL);
    }

    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }

    // A projection whose frustum, box or general matrix cuts about half of what is drawn.
    void choose_view(int kind) {
        TERRAZZO_GL(m_gl, glMatrixMode)(GL_PROJECTION);
        TERRAZZO_GL(m_gl, glLoadIdentity)();
        m_grid = kind == 3;
        if (m_grid)
            TERRAZZO_GL(m_gl, glOrtho)(0, kWidth, 0, kHeight, -1, 1);
        else if (kind == 2)
            TERRAZZO_GL(m_gl, glOrtho)
            (number(-3, -1), number(1, 3), number(-3, -1), number(1, 3), -1, number(1, 9));
        else
            TERRAZZO_GL(m_gl, glFrustum)
            (number(-2, -0.2f), number(0.2f, 2), number(-2, -0.2f), number(0.2f, 2), 1, 20);
        TERRAZZO_GL(m_gl, glTranslatef)(0, 0, m_grid ? 0 : kind == 2 ? -1 : -3);
        TERRAZZO_GL(m_gl, glGetFloatv)(GL_PROJECTION_MATRIX, m_matrix);

        const bool whole = pick(2) == 0;
        const int x = whole ? 0 : pick(20), y = whole ? 0 : pick(20);
        const int width = whole ? kWidth : 20 + pick(70), height = whole ? kHeight : 20 + pick(50);
        const double near = whole ? 0 : number(0, 0.5f), far = whole ? 1 : number(0.5f, 1);
        TERRAZZO_GL(m_gl, glViewport)(x, y, width, height);
        TERRAZZO_GL(m_gl, glDepthRange)(near, far);
        m_viewport = model::make_viewport(x, y, width, height, near, far, kHeight);
    }

    // Half of the grid's positions are pixel centres and corners, where the tie rules live.
    Float4 random_position() {
        if (!m_grid) return {number(-2, 2), number(-2, 2), number(-2, 2), pick(4) ? 1.0f : number(0.5f, 2)};
        const float fine = pick(2) ? static_cast<float>(pick(8)) / 8.0f : 0.0f;
        return {static_cast<float>(pick(2 * kWidth)) * 0.5f + fine,
                static_cast<float>(pick(2 * kHeight)) * 0.5f, 0, 1};
    }

    model::Vertex random_vertex() {
        const Float4 position = random_position();
        model::Vertex v;
        v.colour = {number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
        v.clip = model::transform(m_matrix, position);
        model::project(v, m_viewport);
        TERRAZZO_GL(m_gl, glColor4fv)(v.colour.data());
        TERRAZZO_GL(m_gl, glVertex4fv)(position.data());
        return v;
    }

    void begin(GLenum mode) {
        TERRAZZO_GL(m_gl, glClearColor)(-1, -1, -1, -1);
        TERRAZZO_GL(m_gl, glClear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        TERRAZZO_GL(m_gl, glBegin)(mode);
    }

    void draw(model::Image& image) {
        const GLenum mode = GetParam();
        begin(mode);
        if (mode == GL_TRIANGLES) {
            const std::array<model::Vertex, 3> v = {random_vertex(), random_vertex(), random_vertex()};
            for (const auto& piece : model::clip_triangle(v, m_viewport))
                model::draw_triangle(image, piece, m_offset);
        } else if (mode == GL_LINES) {
            model::Vertex a = random_vertex(), b = random_vertex();
            if (model::clip_line(a, b, m_viewport)) model::draw_line(image, a, b, m_size);
        } else {
            const model::Vertex v = random_vertex();
            if (model::point_visible(v)) model::draw_point(image, v, m_size);
        }
        TERRAZZO_GL(m_gl, glEnd)();
        TERRAZZO_GL(m_gl, glFinish)();
    }

    void expect_equal(model::Image& image) {
        std::vector<GLuint> depth(kWidth * kHeight);
        TERRAZZO_GL(m_gl, glReadPixels)
        (0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const std::size_t index = static_cast<std::size_t>(y) * kWidth + x;
                const float* theirs = m_gl.floats() + 4 * index;
                const model::Pixel& ours = image.at(x, kHeight - 1 - y);
                ASSERT_EQ(theirs[3] != -1.0f, ours.covered) << "coverage at " << x << ' ' << y;
                if (!ours.covered) continue;
                for (int i = 0; i < 4; ++i)
                    ASSERT_EQ(std::bit_cast<std::uint32_t>(theirs[i]),
                              std::bit_cast<std::uint32_t>(ours.colour[i]))
                        << "component " << i << " at " << x << ' ' << y;
                const float z = std::min(std::max(ours.z, 0.0f), 1.0f);
                ASSERT_EQ(depth[index] >> 8, std::lrint(z * 16777215.0f)) << "depth at " << x << ' ' << y;
                ++m_covered;
            }
    }

    void choose_sizes() {
        m_offset = {};
        if (pick(2)) m_offset = {number(-3, 3), number(-4, 4), 24};
        m_size = pick(2) ? static_cast<float>(1 + pick(7)) : number(0.3f, 8);
        TERRAZZO_GL(m_gl, glPolygonOffset)(m_offset.factor, m_offset.units);
        TERRAZZO_GL(m_gl, glLineWidth)(m_size);
        TERRAZZO_GL(m_gl, glPointSize)(m_size);
    }

    terrazzo::test::Osmesa m_gl;
    std::mt19937 m_random{5};
    float m_matrix[16];
    bool m_grid = false;
    model::Viewport m_viewport;
    model::PolygonOffset m_offset;
    float m_size = 1;
    long m_covered = 0;
};

TEST_P(Model, EqualsTheLibraryBitForBit) {
    for (int i = 0; i < 400; ++i) {
        choose_view(i % 4);
        choose_sizes();
        model::Image image(kWidth, kHeight);
        draw(image);
        expect_equal(image);
        if (HasFatalFailure()) FAIL() << "draw " << i;
    }
    EXPECT_GT(m_covered, 5000) << "the draws must cover something";
}

INSTANTIATE_TEST_SUITE_P(Primitives, Model, testing::Values(GL_TRIANGLES, GL_LINES, GL_POINTS));

}  // namespace
