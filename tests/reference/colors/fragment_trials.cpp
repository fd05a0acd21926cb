// Trials of the fragment side: interpolation, texture environments, fog, alpha test, blending, logic
// operations and clears, in every kind of buffer.
#include "colors/trial.h"

namespace terrazzo::test {
namespace {

constexpr int kCell = 4;  // pixels
constexpr int kCells = kTrialSize / kCell;

// Object coordinates are pixels.
void pixel_view(const Gl& gl) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0, kTrialSize, 0, kTrialSize, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
}

// A colour in each cell, exactly.
template <typename Function>
void cells(const Gl& gl, Function color_of) {
    gl.ShadeModel(GL_FLAT);
    for (int i = 0; i < kCells * kCells; ++i) {
        const int x = i % kCells * kCell, y = i / kCells * kCell;
        const std::array<float, 4> color = color_of(i);
        gl.Begin(GL_TRIANGLE_STRIP);
        gl.Color4fv(color.data());
        gl.Vertex2i(x, y);
        gl.Vertex2i(x + kCell, y);
        gl.Vertex2i(x, y + kCell);
        gl.Vertex2i(x + kCell, y + kCell);
        gl.End();
    }
}

// Channels that fall on every step of the buffer, between steps, and outside [0, 1].
std::array<float, 4> random_color(Dice& dice) {
    switch (dice.pick(4)) {
        case 0: {
            std::array<float, 4> c;
            for (float& v : c) v = static_cast<float>(dice.pick(256)) / 255.0f;
            return c;
        }
        case 1: {
            std::array<float, 4> c;
            for (float& v : c) v = (static_cast<float>(dice.pick(512)) * 0.5f) / 255.0f;
            return c;
        }
        case 2:
            return {dice.one_of({0.0f, 0.5f, 1.0f}), dice.one_of({0.0f, 0.5f, 1.0f}),
                    dice.one_of({0.0f, 0.5f, 1.0f}), dice.one_of({0.0f, 0.5f, 1.0f})};
        default:
            return dice.numbers<4>(-0.1f, 1.1f);
    }
}

void backdrop(const Gl& gl, Dice& dice) {
    pixel_view(gl);
    cells(gl, [&](int) { return random_color(dice); });
}

void blend(const Gl& gl, Dice& dice) {
    backdrop(gl, dice);
    constexpr GLenum kFactors[] = {GL_ZERO,
                                   GL_ONE,
                                   GL_SRC_COLOR,
                                   GL_ONE_MINUS_SRC_COLOR,
                                   GL_DST_COLOR,
                                   GL_ONE_MINUS_DST_COLOR,
                                   GL_SRC_ALPHA,
                                   GL_ONE_MINUS_SRC_ALPHA,
                                   GL_DST_ALPHA,
                                   GL_ONE_MINUS_DST_ALPHA,
                                   GL_CONSTANT_COLOR,
                                   GL_ONE_MINUS_CONSTANT_COLOR,
                                   GL_CONSTANT_ALPHA,
                                   GL_ONE_MINUS_CONSTANT_ALPHA,
                                   GL_SRC_ALPHA_SATURATE};
    constexpr GLenum kEquations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    gl.Enable(GL_BLEND);
    if (dice.pick(4) == 0) gl.ColorMask(dice.chance(), dice.chance(), dice.chance(), dice.chance());
    cells(gl, [&](int) {
        gl.BlendFunc(kFactors[dice.pick(15)], kFactors[dice.pick(14)]);
        gl.BlendEquation(kEquations[dice.pick(5)]);
        gl.BlendColor(dice.number(-0.2f, 1.2f), dice.number(0, 1), dice.number(0, 1), dice.number(0, 1));
        return random_color(dice);
    });
}

void logic_op(const Gl& gl, Dice& dice) {
    backdrop(gl, dice);
    gl.Enable(GL_COLOR_LOGIC_OP);
    cells(gl, [&](int) {
        gl.LogicOp(static_cast<GLenum>(GL_CLEAR + dice.pick(16)));
        return random_color(dice);
    });
}

void alpha_test(const Gl& gl, Dice& dice) {
    backdrop(gl, dice);
    gl.Enable(GL_ALPHA_TEST);
    cells(gl, [&](int) {
        std::array<float, 4> color = random_color(dice);
        const float reference =
            dice.one_of({color[3], color[3] + 1e-4f, color[3] - 1e-3f, dice.number(-0.1f, 1.1f)});
        gl.AlphaFunc(static_cast<GLenum>(GL_NEVER + dice.pick(8)), reference);
        return color;
    });
}

void clears(const Gl& gl, Dice& dice) {
    if (dice.chance()) {
        const std::array<float, 4> color = random_color(dice);
        gl.ClearColor(color[0], color[1], color[2], color[3]);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    if (dice.chance()) return;
    gl.Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < kCells * kCells; ++i) {
        const std::array<float, 4> color = random_color(dice);
        gl.Scissor(i % kCells * kCell, i / kCells * kCell, kCell, kCell);
        gl.ClearColor(color[0], color[1], color[2], color[3]);
        gl.ColorMask(dice.pick(4) > 0, dice.pick(4) > 0, dice.pick(4) > 0, dice.pick(4) > 0);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    }
}

// Triangles of all shapes, in perspective or not.
void choose_perspective(const Gl& gl, Dice& dice) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (dice.chance())
        gl.Frustum(-1, 1, -1, 1, 1, 20);
    else
        gl.Ortho(-3, 3, -3, 3, 0, 9);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -3);
}

template <typename Function>
void smooth_triangles(const Gl& gl, Dice& dice, int count, Function before_vertex) {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < count; ++i) {
        const std::array<float, 3> center = dice.numbers<3>(-1.5f, 1.5f);
        const float size = dice.one_of({0.2f, 1.0f, 3.0f});
        for (int v = 0; v < 3; ++v) {
            before_vertex();
            const std::array<float, 3> offset = dice.numbers<3>(-size, size);
            gl.Vertex3f(center[0] + offset[0], center[1] + offset[1], center[2] + offset[2]);
        }
    }
    gl.End();
}

void colors(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    smooth_triangles(gl, dice, 40, [&] { gl.Color4fv(dice.numbers<4>(0, 1).data()); });
}

void flat_colors(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    gl.ShadeModel(GL_FLAT);
    smooth_triangles(gl, dice, 40, [&] { gl.Color4fv(dice.numbers<4>(0, 1).data()); });
}

// Needles: two corners close together or all on a line.
void slivers(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 60; ++i) {
        const std::array<float, 3> from = dice.numbers<3>(-2, 2), to = dice.numbers<3>(-2, 2);
        const float thin = dice.one_of({0.1f, 0.02f, 0.005f});
        for (int v = 0; v < 3; ++v) {
            gl.Color4fv(dice.numbers<4>(0, 1).data());
            const float at = v == 0 ? 0 : v == 1 ? 1 : dice.number(0, 1);
            const std::array<float, 3> offset = dice.numbers<3>(-thin, thin);
            gl.Vertex3f(from[0] + at * (to[0] - from[0]) + offset[0],
                        from[1] + at * (to[1] - from[1]) + offset[1],
                        from[2] + at * (to[2] - from[2]) + offset[2]);
        }
    }
    gl.End();
}

void fog(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, dice.one_of({GL_LINEAR, GL_EXP, GL_EXP2}));
    gl.Fogf(GL_FOG_DENSITY, dice.number(0, 0.6f));
    const float start = dice.number(-1, 4);
    gl.Fogf(GL_FOG_START, start);
    gl.Fogf(GL_FOG_END, dice.one_of({start, start + dice.number(0, 5), dice.number(-2, 6)}));
    gl.Fogfv(GL_FOG_COLOR, dice.numbers<4>(-0.2f, 1.2f).data());
    if (dice.chance()) {
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.Lightfv(GL_LIGHT0, GL_POSITION, dice.numbers<4>(-1, 1).data());
        gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, dice.pick(2));
        gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                       dice.one_of({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}));
        gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, dice.number(0, 20));
        gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, dice.numbers<4>(0, 1).data());
    }
    smooth_triangles(gl, dice, 30, [&] {
        gl.Color4fv(dice.numbers<4>(0, 1).data());
        gl.Normal3fv(dice.numbers<3>(-0.7f, 0.7f).data());
    });
}

// Secondary colours that vary or do not, with and without lighting, shading and fog.
void color_sum(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    gl.Enable(GL_COLOR_SUM);
    if (dice.chance()) gl.ShadeModel(GL_FLAT);
    if (dice.pick(4) == 0) {
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                       dice.one_of({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}));
    }
    if (dice.chance()) gl.Enable(GL_FOG);
    const bool primary = dice.chance(), secondary = dice.chance();
    gl.Color4fv(dice.numbers<4>(-0.1f, 1.1f).data());
    gl.SecondaryColor3fv(dice.numbers<3>(-0.1f, 1.1f).data());
    smooth_triangles(gl, dice, 30, [&] {
        if (primary) gl.Color4fv(dice.numbers<4>(-0.1f, 1.1f).data());
        if (secondary) gl.SecondaryColor3fv(dice.numbers<3>(-0.1f, 1.1f).data());
    });
}

void fog_coordinates(const Gl& gl, Dice& dice) {
    choose_perspective(gl, dice);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    gl.Fogi(GL_FOG_MODE, dice.one_of({GL_LINEAR, GL_EXP, GL_EXP2}));
    gl.Fogf(GL_FOG_DENSITY, dice.number(0, 1));
    gl.Fogf(GL_FOG_START, dice.number(-1, 1));
    gl.Fogf(GL_FOG_END, dice.number(1, 3));
    gl.Fogfv(GL_FOG_COLOR, dice.numbers<4>(0, 1).data());
    const bool varies = dice.pick(4) > 0;
    gl.FogCoordf(dice.number(-1, 3));
    smooth_triangles(gl, dice, 30, [&] {
        gl.Color4fv(dice.numbers<4>(0, 1).data());
        if (varies) gl.FogCoordf(dice.number(-1, 3));
    });
}

// Every environment with every base format; texels are looked up exactly.
void environments(const Gl& gl, Dice& dice) {
    pixel_view(gl);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    constexpr GLenum kFormats[] = {GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                   GL_INTENSITY8, GL_RGB8,       GL_RGBA8};
    const GLenum format = kFormats[dice.pick(6)];
    unsigned char texels[8 * 8 * 4];
    for (unsigned char& t : texels) t = static_cast<unsigned char>(dice.pick(256));
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    cells(gl, [&](int i) {
        GLint mode = dice.one_of({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD});
        // Undefined for the others (GL 1.5 table 3.22).
        if (mode == GL_DECAL && format != GL_RGB8 && format != GL_RGBA8) mode = GL_MODULATE;
        gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
        gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, dice.numbers<4>(-0.2f, 1.2f).data());
        gl.TexCoord2f((static_cast<float>(i % 8) + 0.5f) / 8, (static_cast<float>(i / 8 % 8) + 0.5f) / 8);
        return random_color(dice);
    });
}

// Exact where nothing is interpolated; where it is, far below a step but for rounding at a step's edge.
constexpr Bound kExact{};
constexpr Bound kClose{0.25, 0.0001, 2};

}  // namespace

std::vector<Trial> fragment_trials() {
    return {
        {"colors", colors, 20, kClose},
        {"flat_colors", flat_colors, 10, kExact},
        {"slivers", slivers, 20, kClose},
        {"fog", fog, 24, kClose},
        {"color_sum", color_sum, 24, kClose},
        {"fog_coordinates", fog_coordinates, 24, kClose},
        {"environments", environments, 24, kExact},
        {"blend", blend, 12, kExact, GL_UNSIGNED_BYTE},
        {"blend_bgra", blend, 4, kExact, GL_UNSIGNED_BYTE, OSMESA_BGRA},
        {"blend_16", blend, 12, kExact, GL_UNSIGNED_SHORT},
        {"blend_565", blend, 12, kExact, GL_UNSIGNED_SHORT_5_6_5, OSMESA_RGB_565},
        {"blend_float", blend, 12, kExact},
        {"logic_op", logic_op, 6, kExact, GL_UNSIGNED_BYTE},
        {"logic_op_16", logic_op, 6, kExact, GL_UNSIGNED_SHORT},
        {"logic_op_565", logic_op, 6, kExact, GL_UNSIGNED_SHORT_5_6_5, OSMESA_RGB_565},
        {"logic_op_float", logic_op, 6, kExact},
        {"alpha_test", alpha_test, 12, kExact, GL_UNSIGNED_BYTE},
        {"alpha_test_16", alpha_test, 12, kExact, GL_UNSIGNED_SHORT},
        {"alpha_test_565", alpha_test, 12, kExact, GL_UNSIGNED_SHORT_5_6_5, OSMESA_RGB_565},
        {"alpha_test_float", alpha_test, 12, kExact},
        {"clears", clears, 40, kExact, GL_UNSIGNED_BYTE},
        {"clears_16", clears, 40, kExact, GL_UNSIGNED_SHORT},
        {"clears_565", clears, 40, kExact, GL_UNSIGNED_SHORT_5_6_5, OSMESA_RGB_565},
        {"clears_float", clears, 40, kExact},
    };
}

}  // namespace terrazzo::test
