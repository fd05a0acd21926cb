// Random matrix-stack operations on ours and on the reference: the matrix and its inverse must agree in every
// bit. The inverse is read through glClipPlane: the unit plane i comes back as row i of the modelview's
// inverse.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <vector>

#include "gl/matrix_math.h"
#include "osmesa.h"

namespace {

using terrazzo::gl::Matrix4;
using terrazzo::gl::StackMatrix;

constexpr int kSequences = 20000;
constexpr int kOperations = 6;

// Drives both sides with the same calls and keeps a log of the sequence for the message of a failure.
class BothStacks {
  public:
    BothStacks(const terrazzo::test::Osmesa& reference, unsigned seed) : m_gl(reference), m_random(seed) {}

    void restart() {
        // Pops whatever is left, then loads: a load replaces the traits that LoadIdentity would keep.
        while (m_stack.size() > 1) pop();
        Matrix4 other = terrazzo::gl::identity();
        other.m[1] = 1.0f;
        TERRAZZO_GL(m_gl, glLoadMatrixf)(other.m);
        TERRAZZO_GL(m_gl, glLoadMatrixf)(terrazzo::gl::identity().m);
        load(top(), other);
        load(top(), terrazzo::gl::identity());
        m_log.str("");
    }

    void random_operation() {
        switch (pick(12)) {
            case 0:
                translate();
                break;
            case 1:
                scale();
                break;
            case 2:
            case 3:
                rotate();
                break;
            case 4:
                ortho();
                break;
            case 5:
                frustum();
                break;
            case 6:
                multiply();
                break;
            case 7:
                load_product();
                break;
            case 8:
                load_identity();
                break;
            case 9:
                push();
                break;
            case 10:
                pop();
                break;
            default:
                uniform_scale();
                break;
        }
    }

    void expect_equal() {
        Matrix4 theirs;
        TERRAZZO_GL(m_gl, glGetFloatv)(GL_MODELVIEW_MATRIX, theirs.m);
        expect_same(theirs, top().value, "matrix");
    }

    void expect_equal_inverse() {
        m_log << " [inverse]";
        settle(top());
        Matrix4 theirs;
        for (int row = 0; row < 4; ++row) {
            const double unit[4] = {row == 0 ? 1.0 : 0.0, row == 1 ? 1.0 : 0.0, row == 2 ? 1.0 : 0.0,
                                    row == 3 ? 1.0 : 0.0};
            TERRAZZO_GL(m_gl, glClipPlane)(GL_CLIP_PLANE0, unit);
            double plane[4];
            TERRAZZO_GL(m_gl, glGetClipPlane)(GL_CLIP_PLANE0, plane);
            for (int column = 0; column < 4; ++column)
                theirs.at(row, column) = static_cast<float>(plane[column]);
        }
        Matrix4 ours;
        for (int row = 0; row < 4; ++row) {
            const float unit[4] = {row == 0 ? 1.f : 0.f, row == 1 ? 1.f : 0.f, row == 2 ? 1.f : 0.f,
                                   row == 3 ? 1.f : 0.f};
            float plane[4];
            transform_row(plane, unit, top().inverse);
            for (int column = 0; column < 4; ++column) ours.at(row, column) = plane[column];
        }
        expect_same(theirs, ours, "inverse");
    }

  private:
    StackMatrix& top() { return m_stack.back(); }
    unsigned pick(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(m_random); }
    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    // Often exactly zero or one: the special cases hang on them.
    float coordinate() { return pick(4) == 0 ? static_cast<float>(pick(3)) - 1.0f : number(-5, 5); }

    void translate() {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        m_log << " translate " << x << ' ' << y << ' ' << z;
        TERRAZZO_GL(m_gl, glTranslatef)(x, y, z);
        terrazzo::gl::translate(top(), x, y, z);
    }

    void scale() {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        m_log << " scale " << x << ' ' << y << ' ' << z;
        TERRAZZO_GL(m_gl, glScalef)(x, y, z);
        terrazzo::gl::scale(top(), x, y, z);
    }

    void uniform_scale() {
        const float x = number(0.25f, 4.0f);
        m_log << " scale " << x;
        TERRAZZO_GL(m_gl, glScalef)(x, x, x);
        terrazzo::gl::scale(top(), x, x, x);
    }

    void rotate() {
        const float degrees =
            pick(3) == 0 ? 90.0f * static_cast<float>(pick(9)) - 360.0f : number(-100000, 100000);
        const float x = coordinate(), y = coordinate(), z = coordinate();
        m_log << " rotate " << degrees << ' ' << x << ' ' << y << ' ' << z;
        TERRAZZO_GL(m_gl, glRotatef)(degrees, x, y, z);
        terrazzo::gl::rotate(top(), degrees, x, y, z);
    }

    void ortho() {
        const double l = number(-3, -0.1f), r = number(0.1f, 3), n = number(-2, 0.5f), f = number(1, 20);
        m_log << " ortho " << l << ' ' << r << ' ' << n << ' ' << f;
        TERRAZZO_GL(m_gl, glOrtho)(l, r, l, r * 2, n, f);
        terrazzo::gl::ortho(top(), l, r, l, r * 2, n, f);
    }

    void frustum() {
        const double l = number(-3, -0.1f), r = number(0.1f, 3), n = number(0.1f, 0.5f), f = number(1, 20);
        m_log << " frustum " << l << ' ' << r << ' ' << n << ' ' << f;
        TERRAZZO_GL(m_gl, glFrustum)(l, r, l, r * 2, n, f);
        terrazzo::gl::frustum(top(), l, r, l, r * 2, n, f);
    }

    void multiply() {
        Matrix4 a;
        for (float& x : a.m) x = coordinate();
        if (pick(2) == 0) a.m[3] = a.m[7] = a.m[11] = 0.0f, a.m[15] = 1.0f;
        if (pick(8) == 0) a = terrazzo::gl::identity();
        m_log << " multiply";
        if (pick(2) == 0) {
            TERRAZZO_GL(m_gl, glMultMatrixf)(a.m);
        } else {
            double transposed[16];
            for (int i = 0; i < 16; ++i) transposed[i] = terrazzo::gl::transpose(a).m[i];
            TERRAZZO_GL(m_gl, glMultTransposeMatrixd)(transposed);
        }
        terrazzo::gl::multiply(top(), a);
    }

    // What programs load is mostly a product of simple matrices; its kind must be recognised from the values.
    void load_product() {
        StackMatrix a;
        if (pick(2)) terrazzo::gl::translate(a, coordinate(), coordinate(), coordinate());
        if (pick(2)) terrazzo::gl::rotate(a, 360.0f * number(0, 1), coordinate(), coordinate(), coordinate());
        if (pick(3) == 0) terrazzo::gl::scale(a, coordinate(), coordinate(), coordinate());
        if (pick(3) == 0) terrazzo::gl::scale(a, 1.5f, 1.5f, 1.5f);
        m_log << " load";
        TERRAZZO_GL(m_gl, glLoadMatrixf)(a.value.m);
        load(top(), a.value);
    }

    void load_identity() {
        m_log << " identity";
        TERRAZZO_GL(m_gl, glLoadIdentity)();
        terrazzo::gl::load_identity(top());
    }

    void push() {
        if (m_stack.size() >= 8) return;
        m_log << " push";
        TERRAZZO_GL(m_gl, glPushMatrix)();
        settle(top());
        m_stack.push_back(top());
    }

    void pop() {
        if (m_stack.size() == 1) return;
        m_log << " pop";
        TERRAZZO_GL(m_gl, glPopMatrix)();
        m_stack.pop_back();
    }

    void expect_same(const Matrix4& theirs, const Matrix4& ours, const char* what) {
        for (int i = 0; i < 16; ++i) {
            if (std::isnan(theirs.m[i]) && std::isnan(ours.m[i])) continue;
            EXPECT_EQ(std::bit_cast<std::uint32_t>(theirs.m[i]), std::bit_cast<std::uint32_t>(ours.m[i]))
                << what << " element " << i << ": " << theirs.m[i] << " but ours " << ours.m[i] << " after"
                << m_log.str();
        }
    }

    const terrazzo::test::Osmesa& m_gl;
    std::mt19937 m_random;
    std::vector<StackMatrix> m_stack{StackMatrix{}};
    std::ostringstream m_log;
};

TEST(MatrixStack, EqualsTheReferenceBitForBit) {
    const terrazzo::test::Osmesa reference(4, 4);
    if (!reference.missing().empty()) GTEST_SKIP() << reference.missing();
    BothStacks both(reference, 1);
    for (int sequence = 0; sequence < kSequences; ++sequence) {
        both.restart();
        for (int i = 0; i < kOperations; ++i) {
            both.random_operation();
            both.expect_equal();
            if (i % 2) both.expect_equal_inverse();
            if (HasFailure()) FAIL() << "sequence " << sequence;
        }
    }
}

}  // namespace
