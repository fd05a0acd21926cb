// Trials of texture units: the environment GL_COMBINE with random functions, sources, operands and scales.
#include "colors/trial.h"

namespace terrazzo::test {
namespace {

constexpr GLint kFunctions[] = {GL_REPLACE,
                                GL_MODULATE,
                                GL_ADD,
                                GL_ADD_SIGNED,
                                GL_INTERPOLATE,
                                GL_SUBTRACT,
                                GL_MODULATE_ADD_ATI,
                                GL_MODULATE_SIGNED_ADD_ATI,
                                GL_MODULATE_SUBTRACT_ATI,
                                GL_DOT3_RGB,
                                GL_DOT3_RGBA,
                                GL_DOT3_RGB_EXT,
                                GL_DOT3_RGBA_EXT};

// The source GL_TEXTUREn of a unit without texture is undefined, so only those below `units` are named.
GLint random_source(Dice& dice, int units) {
    const int source = dice.pick(5 + units);
    constexpr GLint kSources[] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_PRIMARY_COLOR};
    return source < 4    ? kSources[source]
           : source == 4 ? dice.one_of({GL_ZERO, GL_ONE})
                         : GL_TEXTURE0 + source - 5;
}

void random_combiner(const Gl& gl, Dice& dice, int units) {
    const auto set = [&](GLenum pname, GLint value) { gl.TexEnvi(GL_TEXTURE_ENV, pname, value); };
    set(GL_TEXTURE_ENV_MODE,
        dice.pick(6) ? GL_COMBINE : dice.one_of({GL_MODULATE, GL_REPLACE, GL_ADD, GL_BLEND}));
    set(GL_COMBINE_RGB, kFunctions[dice.pick(13)]);
    set(GL_COMBINE_ALPHA, kFunctions[dice.pick(9)]);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<GLenum>(i);
        set(GL_SRC0_RGB + n, random_source(dice, units));
        set(GL_SRC0_ALPHA + n, random_source(dice, units));
        set(GL_OPERAND0_RGB + n,
            dice.one_of({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
        set(GL_OPERAND0_ALPHA + n, dice.one_of({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
    }
    set(GL_RGB_SCALE, dice.one_of({1, 1, 2, 4}));
    set(GL_ALPHA_SCALE, dice.one_of({1, 1, 2, 4}));
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, dice.numbers<4>(-0.2f, 1.2f).data());
}

// Texels are looked up exactly, 8 x 8 of them a unit, over stripes whose colours vary along their edges
// alone.
void combine(const Gl& gl, Dice& dice) {
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(0, kTrialSize, 0, kTrialSize, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    const int units = 1 + dice.pick(4);
    constexpr GLint kFormats[] = {GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                  GL_INTENSITY8, GL_RGB8,       GL_RGBA8};
    for (int unit = 0; unit < units; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.Enable(GL_TEXTURE_2D);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        unsigned char texels[8 * 8 * 4];
        for (unsigned char& t : texels) t = static_cast<unsigned char>(dice.pick(256));
        const GLint format = dice.chance() ? GL_RGBA8 : kFormats[dice.pick(6)];
        gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
    constexpr int kStripes = 4, kHeight = kTrialSize / kStripes;
    for (int stripe = 0; stripe < kStripes; ++stripe) {
        for (int unit = 0; unit < units; ++unit) {
            gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            random_combiner(gl, dice, units);
        }
        for (int i = 0; i < kTrialSize / 4; ++i) {
            gl.ShadeModel(GL_FLAT);
            gl.Color4fv(dice.numbers<4>(-0.1f, 1.1f).data());
            for (int unit = 0; unit < units; ++unit)
                gl.MultiTexCoord2f(GL_TEXTURE0 + static_cast<GLenum>(unit),
                                   (static_cast<float>(dice.pick(8)) + 0.5f) / 8,
                                   (static_cast<float>(dice.pick(8)) + 0.5f) / 8);
            gl.Recti(i * 4, stripe * kHeight, i * 4 + 4, stripe * kHeight + kHeight);
        }
    }
}

constexpr Bound kExact{};
// The reference's compiler simplifies sums and products of arguments that occur twice or are constant:
// rounding errors of floats, a ten-thousandth of a step, that bytes do not show.
constexpr Bound kRounding{0.0001, 0, 0.0001};

}  // namespace

std::vector<Trial> combine_trials() {
    return {
        {"combine", combine, 40, kRounding},
        {"combine_bytes", combine, 10, kExact, GL_UNSIGNED_BYTE},
    };
}

}  // namespace terrazzo::test
