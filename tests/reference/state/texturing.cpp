// Texture objects, their parameters, environments and coordinate generation (GL 1.5 §2.11.4, §3.8).
#include "commands.h"

namespace terrazzo::test {
namespace {

const Enumerants kCoordinates = {TERRAZZO_E(GL_S), TERRAZZO_E(GL_T), TERRAZZO_E(GL_R), TERRAZZO_E(GL_Q)};

// Units beyond those of fixed function exist there for shaders.
void play_active_texture(Player& p) {
    p.gl().ActiveTexture(p.pick(8) ? texture_unit(p) : p.enumerant({TERRAZZO_E(GL_TEXTURE)}));
}

void play_texgen(Player& p) {
    const GLenum coordinate = p.enumerant(kCoordinates);
    if (p.pick(3) == 0) {
        return p.gl().TexGenf(coordinate, GL_TEXTURE_GEN_MODE,
                              enumerant_number(p, {TERRAZZO_E(GL_OBJECT_LINEAR), TERRAZZO_E(GL_EYE_LINEAR),
                                                   TERRAZZO_E(GL_SPHERE_MAP), TERRAZZO_E(GL_REFLECTION_MAP),
                                                   TERRAZZO_E(GL_NORMAL_MAP)}));
    }
    const GLenum pname = p.enumerant({TERRAZZO_E(GL_OBJECT_PLANE), TERRAZZO_E(GL_EYE_PLANE)});
    p.gl().TexGenfv(coordinate, pname, p.numbers(4).data());
}

void play_combiner(Player& p) {
    const GLenum operands[2] = {p.enumerant({TERRAZZO_E(GL_SRC_COLOR), TERRAZZO_E(GL_ONE_MINUS_SRC_COLOR)}),
                                p.enumerant({TERRAZZO_E(GL_SRC_ALPHA), TERRAZZO_E(GL_ONE_MINUS_SRC_ALPHA)})};
    const GLenum source = p.enumerant(
        {TERRAZZO_E(GL_TEXTURE), TERRAZZO_E(GL_PREVIOUS), TERRAZZO_E(GL_CONSTANT), TERRAZZO_E(GL_ONE),
         TERRAZZO_E(GL_PRIMARY_COLOR), TERRAZZO_E(GL_ZERO), TERRAZZO_E(GL_TEXTURE7)});
    const GLenum function =
        p.enumerant({TERRAZZO_E(GL_REPLACE), TERRAZZO_E(GL_MODULATE), TERRAZZO_E(GL_ADD),
                     TERRAZZO_E(GL_ADD_SIGNED), TERRAZZO_E(GL_INTERPOLATE), TERRAZZO_E(GL_SUBTRACT),
                     TERRAZZO_E(GL_DOT3_RGB), TERRAZZO_E(GL_DOT3_RGBA), TERRAZZO_E(GL_DOT3_RGB_EXT),
                     TERRAZZO_E(GL_MODULATE_ADD_ATI), TERRAZZO_E(GL_DECAL)});
    const unsigned number = p.pick(3), scale = p.pick(5);
    p.note(std::to_string(number) + ' ' + std::to_string(scale));
    const auto set = [&](GLenum pname, GLenum value) {
        p.gl().TexEnvf(GL_TEXTURE_ENV, pname, static_cast<GLfloat>(value));
    };
    switch (p.pick(8)) {
        case 0:
            return set(GL_COMBINE_RGB, function);
        case 1:
            return set(GL_COMBINE_ALPHA, function);
        case 2:
            return set(GL_SRC0_RGB + number, source);
        case 3:
            return set(GL_SRC0_ALPHA + number, source);
        case 4:
            return set(GL_OPERAND0_RGB + number, operands[scale & 1]);
        case 5:
            return set(GL_OPERAND0_ALPHA + number, operands[scale & 1]);
        case 6:
            return set(GL_RGB_SCALE, scale);
    }
    set(GL_ALPHA_SCALE, scale);
}

void play_texture_environment(Player& p) {
    if (p.pick(2)) return p.gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, p.numbers(4).data());
    const GLenum target = p.enumerant({TERRAZZO_E(GL_TEXTURE_ENV)});
    p.gl().TexEnvi(target, GL_TEXTURE_ENV_MODE,
                   static_cast<GLint>(
                       p.enumerant({TERRAZZO_E(GL_MODULATE), TERRAZZO_E(GL_DECAL), TERRAZZO_E(GL_BLEND),
                                    TERRAZZO_E(GL_REPLACE), TERRAZZO_E(GL_ADD), TERRAZZO_E(GL_COMBINE)})));
}

void play_texture(Player& p) {
    const GLenum target = p.enumerant({TERRAZZO_E(GL_TEXTURE_1D), TERRAZZO_E(GL_TEXTURE_2D),
                                       TERRAZZO_E(GL_TEXTURE_3D), TERRAZZO_E(GL_TEXTURE_CUBE_MAP)});
    switch (p.pick(8)) {
        case 0: {
            const GLuint kind = target == GL_TEXTURE_1D         ? 1
                                : target == GL_TEXTURE_3D       ? 2
                                : target == GL_TEXTURE_CUBE_MAP ? 3
                                                                : 4;
            return p.gl().BindTexture(target, p.pick(3) * 4 + (p.pick(8) ? kind : p.pick(5)));
        }
        case 1: {
            const GLuint names[2] = {p.pick(12), p.pick(12)};
            return p.gl().DeleteTextures(2, names);
        }
        case 4:
            return p.gl().TexParameteri(
                target, GL_DEPTH_TEXTURE_MODE,
                static_cast<GLint>(
                    p.enumerant({TERRAZZO_E(GL_LUMINANCE), TERRAZZO_E(GL_INTENSITY), TERRAZZO_E(GL_ALPHA)})));
        case 5:
            return p.gl().TexParameteri(
                target, GL_TEXTURE_COMPARE_MODE,
                static_cast<GLint>(p.enumerant({TERRAZZO_E(GL_NONE), TERRAZZO_E(GL_COMPARE_R_TO_TEXTURE)})));
        case 6:
            return p.gl().TexParameteri(target, GL_TEXTURE_COMPARE_FUNC,
                                        static_cast<GLint>(p.enumerant(kComparisons)));
        case 2:
            return p.gl().TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, p.moderate_numbers(4).data());
        case 3:
            return p.gl().TexParameteri(
                target, GL_TEXTURE_WRAP_S,
                static_cast<GLint>(p.enumerant(
                    {TERRAZZO_E(GL_CLAMP), TERRAZZO_E(GL_REPEAT), TERRAZZO_E(GL_CLAMP_TO_EDGE)})));
    }
    p.gl().TexParameteri(
        target, GL_TEXTURE_MIN_FILTER,
        static_cast<GLint>(p.enumerant({TERRAZZO_E(GL_NEAREST), TERRAZZO_E(GL_LINEAR_MIPMAP_LINEAR)})));
}

const Command kCommands[] = {
    // Not of a unit: the reference's PopAttrib makes that one 0.
    {"glTexParameteri(GL_GENERATE_MIPMAP)",
     [](Player& p) { p.gl().TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, p.flag()); }},
    {"texture bias",
     [](Player& p) { p.gl().TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, p.moderate_number()); }},
    {"degree of anisotropy",
     [](Player& p) {
         p.gl().TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, p.moderate_number());
     }},
    {"sprite",
     [](Player& p) {
         const GLint value = static_cast<GLint>(p.pick(5)) - 1;
         p.note(std::to_string(value));
         p.gl().TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, value);
     }},
    {"glActiveTexture", play_active_texture},
    {"glTexGen", play_texgen},
    {"glTexEnv", play_texture_environment},
    {"combiner", play_combiner},
    {"texture", play_texture},
};

}  // namespace

GLenum texture_unit(Player& p) {
    const GLenum number = p.pick(8);
    p.note(std::to_string(number));
    return GL_TEXTURE0 + number;
}

std::span<const Command> texturing_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
