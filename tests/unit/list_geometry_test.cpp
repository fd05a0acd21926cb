// Geometry in display lists: whatever commands a list holds, calling it draws and leaves behind what the
// commands themselves would have. Random command streams, sensible and not, are carried out both ways and
// compared.
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "attach_picture.h"
#include "gl/context.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 48;

using Command = std::function<void()>;

// What a program can see of a context.
struct Outcome {
    std::vector<std::byte> pixels;
    std::vector<GLfloat> state;
    GLenum error = GL_NO_ERROR;
    unsigned errors = 0;

    bool operator==(const Outcome&) const = default;
};

std::unique_ptr<Context> make_context() {
    auto ctx = create_context(Config{}, nullptr);
    attach_picture(*ctx, kSize, kSize);
    make_current(ctx.get());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHT0);
    // The reference, and so we, cuts quads along another diagonal in lists; not where they are stippled.
    glEnable(GL_POLYGON_STIPPLE);
    std::array<GLubyte, 8 * 8 * 4> texels;
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(i * 29);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return ctx;
}

// Restarts the context's error count, so that set-up does not show.
void forget_errors(Context& ctx) {
    ctx.error = {};
}

Outcome outcome_of(Context& ctx) {
    Outcome outcome;
    outcome.error = ctx.error.code;
    outcome.errors = ctx.error.count;
    if (ctx.vertex.open) glEnd();
    outcome.pixels.resize(kSize * kSize * 4);
    copy_picture(ctx, *ctx.surface.draw, ColorBuffer::kFront, raster::PixelLayout::kRgba8,
                 outcome.pixels.data(), kSize * 4);
    const auto append = [&](auto query, int count) {
        std::array<GLfloat, 16> values{};
        query(values.data());
        outcome.state.insert(outcome.state.end(), values.begin(), values.begin() + count);
    };
    append([](GLfloat* v) { glGetFloatv(GL_CURRENT_COLOR, v); }, 4);
    append([](GLfloat* v) { glGetFloatv(GL_CURRENT_NORMAL, v); }, 3);
    append([](GLfloat* v) { glGetFloatv(GL_CURRENT_TEXTURE_COORDS, v); }, 4);
    append([](GLfloat* v) { glGetFloatv(GL_CURRENT_INDEX, v); }, 1);
    append([](GLfloat* v) { glGetFloatv(GL_EDGE_FLAG, v); }, 1);
    append([](GLfloat* v) { glGetFloatv(GL_MODELVIEW_MATRIX, v); }, 16);
    append([](GLfloat* v) { glGetMaterialfv(GL_FRONT, GL_DIFFUSE, v); }, 4);
    append([](GLfloat* v) { glGetMaterialfv(GL_BACK, GL_SPECULAR, v); }, 4);
    return outcome;
}

// Commands for one run, drawn from one seed.
class Program {
  public:
    Program(unsigned seed, bool perspective) : m_random(seed), m_perspective(perspective) {
        for (GLfloat& value : m_array) value = number();
    }

    // Commands in an order that a program might mean, with a share of `nonsense`.
    std::vector<Command> write(int count, double nonsense) {
        std::vector<Command> commands;
        while (static_cast<int>(commands.size()) < count) {
            if (chance(nonsense)) {
                commands.push_back(anything());
            } else if (nonsense == 0 && chance(0.1)) {
                // The pointers are set at once when a list is compiled, so where Begin and End may be out of
                // step this would not be the same program.
                commands.push_back(arrays());
            } else if (chance(0.3)) {
                commands.push_back(between_primitives());
            } else {
                write_primitive(commands, nonsense);
            }
        }
        return commands;
    }

    // Cuts the commands into consecutive parts.
    std::vector<std::vector<Command>> cut(const std::vector<Command>& commands) {
        std::vector<std::vector<Command>> parts(1);
        for (const Command& command : commands) {
            if (chance(0.05)) parts.emplace_back();
            parts.back().push_back(command);
        }
        return parts;
    }

    bool chance(double probability) { return std::bernoulli_distribution(probability)(m_random); }

  private:
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(m_random); }

    // Quarters, so that equal values, zeros and ones turn up.
    GLfloat number() { return static_cast<GLfloat>(below(9) - 4) / 4; }

    Command attribute() {
        const std::array<GLfloat, 4> v = {number(), number(), number(), chance(0.5) ? 1 : number()};
        switch (below(5)) {
            case 0:
                return [v] { glColor4fv(v.data()); };
            case 1:
                return [v] { glNormal3fv(v.data()); };
            case 2:
                return [v] { glTexCoord4fv(v.data()); };
            case 3:
                return [v] { glEdgeFlag(v[0] > 0); };
            default:
                return [v] { glIndexf(v[0]); };
        }
    }

    Command vertex() {
        const std::array<GLfloat, 4> v = {number() * 2, number() * 2, number(),
                                          m_perspective ? 1 + number() / 4 : 1};
        if (chance(0.3)) return [v] { glVertex2fv(v.data()); };
        if (chance(0.5)) return [v] { glVertex3fv(v.data()); };
        return [v] { glVertex4fv(v.data()); };
    }

    Command material() {
        const std::array<GLfloat, 4> v = {number(), number(), number(), number()};
        const GLenum face = chance(0.5) ? GL_FRONT_AND_BACK : GL_BACK;
        const GLenum name = chance(0.5) ? GL_DIFFUSE : GL_SPECULAR;
        return [=] { glMaterialfv(face, name, v.data()); };
    }

    Command between_primitives() {
        const GLfloat x = number() / 8;
        switch (below(8)) {
            case 0:
                return [x] { glTranslatef(x, -x, 0); };
            case 1:
                return [x] { glRectf(x, x, x + 0.3f, x + 0.2f); };
            case 2:
                return [x] { x > 0 ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING); };
            case 3:
                return [x] { x > 0 ? glEnable(GL_COLOR_MATERIAL) : glDisable(GL_COLOR_MATERIAL); };
            case 4:
                return [x] { glShadeModel(x > 0 ? GL_FLAT : GL_SMOOTH); };
            case 5:
                return material();
            default:
                return attribute();
        }
    }

    // What the current values are after arrays is not specified, so they are set again.
    Command arrays() {
        const GLint first = below(4);
        const auto mode = static_cast<GLenum>(below(10));
        const bool colors = chance(0.5);
        return [=, this] {
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, 24, m_array.data());
            if (colors) glEnableClientState(GL_COLOR_ARRAY);
            glColorPointer(3, GL_FLOAT, 24, m_array.data() + 3);
            const std::array<GLubyte, 6> indices = {0, 3, 1, 2, 5, 4};
            if (first % 2)
                glDrawArrays(mode, first, 7);
            else
                glDrawElements(mode, 6, GL_UNSIGNED_BYTE, indices.data());
            glDisableClientState(GL_COLOR_ARRAY);
            glDisableClientState(GL_VERTEX_ARRAY);
            glColor3f(0.5f, 0.25f, 1);
        };
    }

    Command anything() {
        switch (below(8)) {
            case 0:
                return [] { glBegin(GL_TRIANGLE_STRIP); };
            case 1:
                return [] { glBegin(77); };
            case 2:
                return [] { glEnd(); };
            case 3:
                return vertex();
            case 4:
                return material();
            case 5:
                return attribute();
            case 6:
                return [] { glMatrixMode(1); };
            default:
                return between_primitives();
        }
    }

    void write_primitive(std::vector<Command>& commands, double nonsense) {
        const auto mode = static_cast<GLenum>(below(10));
        commands.push_back([mode] { glBegin(mode); });
        const int vertices = below(9);
        for (int i = 0; i < vertices; ++i) {
            if (chance(0.4)) commands.push_back(attribute());
            if (chance(nonsense)) commands.push_back(chance(0.5) ? material() : anything());
            commands.push_back(vertex());
        }
        commands.push_back([] { glEnd(); });
    }

    std::mt19937 m_random;
    bool m_perspective;
    std::array<GLfloat, 128> m_array;
};

Outcome run_directly(const std::vector<Command>& commands) {
    const auto ctx = make_context();
    forget_errors(*ctx);
    for (const Command& command : commands) command();
    return outcome_of(*ctx);
}

// Some parts as lists, some directly. Lists cannot be made between Begin and End, so all are made first.
Outcome run_in_lists(const std::vector<std::vector<Command>>& parts, Program& program) {
    const auto ctx = make_context();
    std::vector<bool> is_list(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        is_list[i] = program.chance(0.8);
        if (!is_list[i]) continue;
        glNewList(static_cast<GLuint>(i + 1), GL_COMPILE);
        for (const Command& command : parts[i]) command();
        glEndList();
    }
    forget_errors(*ctx);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (is_list[i]) {
            glCallList(static_cast<GLuint>(i + 1));
        } else {
            for (const Command& command : parts[i]) command();
        }
    }
    return outcome_of(*ctx);
}

Outcome run_while_compiling(const std::vector<Command>& commands) {
    const auto ctx = make_context();
    forget_errors(*ctx);
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    for (const Command& command : commands) command();
    Outcome outcome = outcome_of(*ctx);  // queries and End are carried out while the list is open
    glEndList();
    return outcome;
}

int largest_difference(const Outcome& a, const Outcome& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<int>(a.pixels[i]) - static_cast<int>(b.pixels[i])));
    }
    return largest;
}

void expect_same(const Outcome& expected, const Outcome& found, int tolerance) {
    EXPECT_LE(largest_difference(expected, found), tolerance);
    EXPECT_EQ(expected.state, found.state);
    EXPECT_EQ(expected.error, found.error);
    EXPECT_EQ(expected.errors, found.errors);
}

struct Kind {
    double nonsense;
    bool perspective;
    // Under perspective an attribute that is equal in all vertices of a batch, and so not interpolated, may
    // round differently from one that is interpolated between equal values; lists and direct drawing batch
    // differently.
    int tolerance() const { return perspective ? 1 : 0; }
};

class ListGeometry : public testing::TestWithParam<Kind> {};

TEST_P(ListGeometry, IsWhatTheCommandsDraw) {
    std::size_t drawn = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Program program(seed, GetParam().perspective);
        const std::vector<Command> commands = program.write(60, GetParam().nonsense);
        const Outcome direct = run_directly(commands);
        expect_same(direct, run_in_lists(program.cut(commands), program), GetParam().tolerance());
        for (const std::byte value : direct.pixels) drawn += value != std::byte{0};
        if (HasFailure()) break;
    }
    make_current(nullptr);
    EXPECT_GT(drawn, 100000u);  // the comparison was not one of empty pictures
}

TEST_P(ListGeometry, CompilingAndExecutingDrawsTheSame) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        Program program(seed, GetParam().perspective);
        const std::vector<Command> commands = program.write(60, GetParam().nonsense);
        expect_same(run_directly(commands), run_while_compiling(commands), GetParam().tolerance());
        if (HasFailure()) break;
    }
    make_current(nullptr);
}

// One half of the picture, its texture coordinates divided by q.
void draw_half(GLfloat left, GLfloat q) {
    glBegin(GL_TRIANGLE_STRIP);
    for (const GLfloat x : {0.0f, 1.0f}) {
        for (const GLfloat y : {-1.0f, 1.0f}) {
            glTexCoord4f(x * q, y * q * q, 0, q);
            glVertex2f(left + x, y);
        }
    }
    glEnd();
}

TEST(ListTexture, CoordinatesMayNeedADivisionOnlyNow) {
    const auto picture = [](bool divided_first) {
        const auto ctx = make_context();
        glEnable(GL_TEXTURE_2D);
        glNewList(1, GL_COMPILE);
        draw_half(-1, 1);
        glEndList();
        if (!divided_first) glCallList(1);
        draw_half(0, 0.5f);
        if (divided_first) glCallList(1);
        return outcome_of(*ctx).pixels;
    };
    EXPECT_TRUE(picture(false) == picture(true));
    make_current(nullptr);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ListGeometry,
                         testing::Values(Kind{0, false}, Kind{0.02, false}, Kind{0.2, false}, Kind{0, true},
                                         Kind{0.02, true}));

}  // namespace
}  // namespace terrazzo::gl
