// Signed integers of normals and colours mean the same by every way into the pipeline, bit by bit (GL 1.5
// table 2.9): immediate mode, arrays drawn, indexed or element by element, and lists of these.
#define GL_GLEXT_PROTOTYPES
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

enum class Way { kImmediate, kArrays, kElements, kArrayElement, kBuffer };
constexpr Way kWays[] = {Way::kImmediate, Way::kArrays, Way::kElements, Way::kArrayElement, Way::kBuffer};
enum class List { kNone, kCompiled, kCompiledAndExecuted };
constexpr List kLists[] = {List::kNone, List::kCompiled, List::kCompiledAndExecuted};

constexpr GLfloat kTriangle[] = {-1, -1, 3, -1, -1, 3};

class ArrayNormalsTest : public GlTest {
  protected:
    ArrayNormalsTest() {
        raster::TargetFormat format;
        format.color = raster::ColorFormat::kRgba32F;
        attach_picture(ctx(), 4, 4, format);
        color_material(ctx(), GL_FRONT_AND_BACK, GL_DIFFUSE);
        enable(ctx(), GL_COLOR_MATERIAL);
        enable(ctx(), GL_LIGHTING);
        enable(ctx(), GL_LIGHT0);
        const GLfloat towards[4] = {0.5f, 0.25f, 1, 0}, none[4] = {0, 0, 0, 1};
        lightfv(ctx(), GL_LIGHT0, GL_POSITION, towards);
        light_modelfv(ctx(), GL_LIGHT_MODEL_AMBIENT, none);
        gen_buffers(ctx(), 1, &m_buffer);
    }

    template <typename Integer>
    std::array<GLfloat, 4> draw(const std::array<Integer, 3>& normal, const std::array<Integer, 4>& color,
                                GLenum type, Way way, List list) {
        clear(ctx(), GL_COLOR_BUFFER_BIT);
        glColor4f(1, 1, 1, 1);
        glNormal3f(0, 0, 1);
        std::array<Integer, 24> vertices{};
        for (std::size_t i = 0; i < vertices.size(); i += 8) {
            std::ranges::copy(normal, vertices.begin() + static_cast<std::ptrdiff_t>(i));
            std::ranges::copy(color, vertices.begin() + static_cast<std::ptrdiff_t>(i + 4));
        }
        constexpr auto kStride = static_cast<GLsizei>(8 * sizeof(Integer));
        const Integer* first = vertices.data();
        if (way == Way::kBuffer) {
            glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
            glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices.data(), GL_STATIC_DRAW);
            first = nullptr;
        }
        glNormalPointer(type, kStride, first);
        glColorPointer(
            4, type, kStride,
            reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(first) + 4 * sizeof(Integer)));
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glVertexPointer(2, GL_FLOAT, 0, kTriangle);
        for (const GLenum array : {GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_VERTEX_ARRAY})
            glEnableClientState(array);
        if (list != List::kNone) glNewList(1, list == List::kCompiled ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
        send(normal, color, way);
        if (list != List::kNone) glEndList();
        if (list == List::kCompiled) glCallList(1);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        std::array<GLfloat, 4> pixel{};
        glReadPixels(1, 1, 1, 1, GL_RGBA, GL_FLOAT, pixel.data());
        return pixel;
    }

    template <typename Integer>
    void send(const std::array<Integer, 3>& normal, const std::array<Integer, 4>& color, Way way) {
        constexpr GLubyte kIndices[] = {0, 1, 2};
        if (way == Way::kArrays || way == Way::kBuffer) return glDrawArrays(GL_TRIANGLES, 0, 3);
        if (way == Way::kElements) return glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, kIndices);
        glBegin(GL_TRIANGLES);
        for (GLint i = 0; i < 3; ++i) {
            if (way == Way::kArrayElement) {
                glArrayElement(i);
                continue;
            }
            if constexpr (std::is_same_v<Integer, GLbyte>)
                glNormal3bv(normal.data()), glColor4bv(color.data());
            if constexpr (std::is_same_v<Integer, GLshort>)
                glNormal3sv(normal.data()), glColor4sv(color.data());
            if constexpr (std::is_same_v<Integer, GLint>)
                glNormal3iv(normal.data()), glColor4iv(color.data());
            glVertex2f(kTriangle[2 * i], kTriangle[2 * i + 1]);
        }
        glEnd();
    }

    template <typename Integer>
    void expect_alike(GLenum type) {
        using Limits = std::numeric_limits<Integer>;
        const auto part = [](int of_64) {
            return static_cast<Integer>(Limits::max() / 64 * of_64 + of_64 % 3);
        };
        for (int i = 0; i < 64; ++i) {
            const std::array<Integer, 3> normal{part(i * 37 % 64), part(i * 11 % 64 - 32), part(64 - i)};
            const std::array<Integer, 4> color{part(i), part(63 - i), i % 2 ? Limits::max() : Limits::min(),
                                               part(i / 2)};
            const auto expected = draw(normal, color, type, Way::kImmediate, List::kNone);
            for (const Way way : kWays)
                for (const List list : kLists)
                    EXPECT_EQ(draw(normal, color, type, way, list), expected)
                        << "type 0x" << std::hex << type << " case " << std::dec << i << " way "
                        << static_cast<int>(way) << " list " << static_cast<int>(list);
        }
    }

    GLuint m_buffer = 0;
};

TEST_F(ArrayNormalsTest, BytesAreAlike) {
    expect_alike<GLbyte>(GL_BYTE);
}

TEST_F(ArrayNormalsTest, ShortsAreAlike) {
    expect_alike<GLshort>(GL_SHORT);
}

TEST_F(ArrayNormalsTest, IntegersAreAlike) {
    expect_alike<GLint>(GL_INT);
}

// Table 2.9: (2c + 1)/(2^b - 1), so that nothing stands for 0.
TEST_F(ArrayNormalsTest, FollowGl15) {
    disable(ctx(), GL_LIGHTING);
    const auto pixel = draw<GLbyte>({0, 0, 127}, {0, 127, -128, 64}, GL_BYTE, Way::kArrays, List::kNone);
    EXPECT_FLOAT_EQ(pixel[0], 1.0f / 255);
    EXPECT_FLOAT_EQ(pixel[1], 1);
    EXPECT_FLOAT_EQ(pixel[2], 0) << "clamped";
    EXPECT_FLOAT_EQ(pixel[3], 129.0f / 255);
}

}  // namespace
}  // namespace terrazzo::gl
