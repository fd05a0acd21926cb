// Where the line stipple begins anew (GL 1.5 §3.4.2): at Begin, with each separate line, with each polygon,
// whatever was drawn or clipped before.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kWidth = 64, kHeight = 32;

class LineStippleTest : public GlTest {
  protected:
    LineStippleTest() {
        attach_picture(ctx(), kWidth, kHeight);
        matrix_mode(ctx(), GL_PROJECTION);
        ortho(ctx(), 0, kWidth, 0, kHeight, -1, 1);
        line_stipple(ctx(), 2, 0x3f5a);
        enable(ctx(), GL_LINE_STIPPLE);
    }

    void vertex(GLfloat x, GLfloat y) { vertex4f(ctx(), x, y, 0, 1); }
    void primitive(GLenum mode, std::initializer_list<std::array<GLfloat, 2>> vertices) {
        begin(ctx(), mode);
        for (const auto& [x, y] : vertices) vertex(x, y);
        end(ctx());
    }

    std::string row(int y) {
        std::array<GLubyte, 4 * kWidth> pixels{};
        read_pixels(ctx(), 0, y, kWidth, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        std::string text;
        for (int x = 0; x < kWidth; ++x) text += pixels[static_cast<std::size_t>(4 * x)] ? '#' : '.';
        return text;
    }
};

// The pattern from pixel `first` to before `last`.
std::string stippled(int first, int last) {
    std::string text(kWidth, '.');
    for (int x = first; x < last; ++x)
        if (0x3f5a >> (x - first) / 2 % 16 & 1) text[static_cast<std::size_t>(x)] = '#';
    return text;
}

TEST_F(LineStippleTest, BeginsAnewWhateverWasDrawnBefore) {
    struct Before {
        const char* what;
        std::function<void()> draw;
    };
    const auto triangles = [&] {
        for (int i = 0; i < 3; ++i)
            primitive(GL_TRIANGLES, {{5, 20}, {20.0f + static_cast<GLfloat>(i), 22}, {10, 29}});
    };
    const Before kBefore[] = {
        {"nothing", [] {}},
        {"a mesh without stipple",
         [&] {
             disable(ctx(), GL_LINE_STIPPLE);
             polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_LINE);
             triangles();
             enable(ctx(), GL_LINE_STIPPLE);
         }},
        {"a mesh with stipple",
         [&] {
             polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_LINE);
             triangles();
         }},
        {"a strip",
         [&] {
             primitive(GL_LINE_STRIP, {{3, 20}, {20, 25}, {31, 20}});
         }},
        {"a loop",
         [&] {
             primitive(GL_LINE_LOOP, {{3, 20}, {20, 25}, {31, 20}});
         }},
        {"a strip, then points",
         [&] {
             primitive(GL_LINE_STRIP, {{3, 20}, {20, 25}});
             primitive(GL_POINTS, {{40, 25}});
         }},
        {"a strip, then a filled polygon",
         [&] {
             primitive(GL_LINE_STRIP, {{3, 20}, {20, 25}});
             polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_FILL);
             triangles();
         }},
        {"a strip with another pattern",
         [&] {
             line_stipple(ctx(), 7, 0xffff);
             primitive(GL_LINE_STRIP, {{3, 20}, {20, 25}});
             line_stipple(ctx(), 2, 0x3f5a);
         }},
    };
    struct Line {
        const char* what;
        GLenum mode;
        std::vector<GLfloat> vertices;
        std::string expected;
    };
    const Line kLines[] = {
        {"a strip", GL_LINE_STRIP, {4.5f, 40.5f, 60.5f}, stippled(4, 60)},
        {"a strip whose first line is clipped away", GL_LINE_STRIP, {-30, -10, 60}, stippled(0, 60)},
        {"a loop whose first line is clipped away", GL_LINE_LOOP, {-30.5f, -10.5f, 60.5f}, {}},
        {"lines",
         GL_LINES,
         {4.5f, 30.5f, 34.5f, 60.5f},
         stippled(4, 30).substr(0, 34) + stippled(34, 60).substr(34)},
        {"lines of which the first is clipped away", GL_LINES, {-30, -4, 4.5f, 60.5f}, stippled(4, 60)},
    };
    constexpr const char* kWays[] = {"immediate", "list", "compile and execute", "arrays", "elements"};
    for (const Before& before : kBefore) {
        for (const Line& line : kLines) {
            for (std::size_t way = 0; way < std::size(kWays); ++way) {
                clear(ctx(), GL_COLOR_BUFFER_BIT);
                before.draw();
                std::vector<GLfloat> vertices;
                for (const GLfloat x : line.vertices) vertices.insert(vertices.end(), {x, 10.5f});
                const auto count = static_cast<GLsizei>(line.vertices.size());
                if (way == 1 || way == 2) new_list(ctx(), 1, way == 1 ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
                if (way < 3) {
                    glBegin(line.mode);
                    for (const GLfloat x : line.vertices) glVertex2f(x, 10.5f);
                    glEnd();
                }
                if (way == 1 || way == 2) end_list(ctx());
                if (way == 1) call_list(ctx(), 1);
                if (way >= 3) {
                    constexpr GLubyte kIndices[] = {0, 1, 2, 3};
                    vertex_pointer(ctx(), 2, GL_FLOAT, 0, vertices.data());
                    enable_client_state(ctx(), GL_VERTEX_ARRAY);
                    if (way == 3) draw_arrays(ctx(), line.mode, 0, count);
                    if (way == 4) draw_elements(ctx(), line.mode, count, GL_UNSIGNED_BYTE, kIndices);
                    disable_client_state(ctx(), GL_VERTEX_ARRAY);
                }
                ASSERT_EQ(take_error(), GLenum{GL_NO_ERROR});
                const std::string found = row(10);
                if (line.expected.empty()) {
                    // Cut twice: where its parts begin is left to us, but not to what was drawn before.
                    static std::string first_found;
                    if (&before == kBefore && way == 0) first_found = found;
                    EXPECT_EQ(found, first_found)
                        << line.what << " after " << before.what << ", " << kWays[way];
                    EXPECT_NE(found, std::string(kWidth, '.'));
                    continue;
                }
                EXPECT_EQ(found, line.expected)
                    << line.what << " after " << before.what << ", " << kWays[way];
            }
        }
    }
}

// From the last corner on: (2.5, 4.5) to (50.5, 4.5) is the first edge of the outline here.
TEST_F(LineStippleTest, BeginsAnewWithEachPolygon) {
    polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_LINE);
    begin(ctx(), GL_TRIANGLES);
    for (const GLfloat y : {4.5f, 14.5f}) {
        vertex(50.5f, y);
        vertex(50.5f, y + 7);
        vertex(2.5f, y);
    }
    // Its first edge is above the window: gone, and the next polygon still begins anew.
    vertex(50.5f, 40), vertex(50.5f, 50), vertex(2.5f, 40);
    vertex(50.5f, 24.5f), vertex(50.5f, 28), vertex(2.5f, 24.5f);
    end(ctx());
    // The outline's last edge comes near the first's beginning.
    for (const int y : {4, 14, 24}) EXPECT_EQ(row(y).substr(8, 42), stippled(2, 50).substr(8, 42)) << y;
}

}  // namespace
}  // namespace terrazzo::gl
