// Lights, materials, fog and the sum of colours (GL 1.5 §2.14, §3.9, §3.10).
#include "commands.h"

namespace terrazzo::test {
namespace {

const Enumerants kLights = {TERRAZZO_E(GL_LIGHT0), TERRAZZO_E(GL_LIGHT1), TERRAZZO_E(GL_LIGHT7)};

const Enumerants kLightVectors = {TERRAZZO_E(GL_AMBIENT), TERRAZZO_E(GL_DIFFUSE), TERRAZZO_E(GL_SPECULAR),
                                  TERRAZZO_E(GL_POSITION), TERRAZZO_E(GL_SPOT_DIRECTION)};

const Enumerants kLightScalars = {TERRAZZO_E(GL_SPOT_EXPONENT), TERRAZZO_E(GL_SPOT_CUTOFF),
                                  TERRAZZO_E(GL_CONSTANT_ATTENUATION), TERRAZZO_E(GL_LINEAR_ATTENUATION),
                                  TERRAZZO_E(GL_QUADRATIC_ATTENUATION)};

const Enumerants kMaterialVectors = {TERRAZZO_E(GL_AMBIENT),
                                     TERRAZZO_E(GL_DIFFUSE),
                                     TERRAZZO_E(GL_SPECULAR),
                                     TERRAZZO_E(GL_EMISSION),
                                     TERRAZZO_E(GL_AMBIENT_AND_DIFFUSE),
                                     TERRAZZO_E(GL_COLOR_INDEXES)};

const Enumerants kMaterialColors = {TERRAZZO_E(GL_AMBIENT), TERRAZZO_E(GL_DIFFUSE), TERRAZZO_E(GL_SPECULAR),
                                    TERRAZZO_E(GL_EMISSION), TERRAZZO_E(GL_AMBIENT_AND_DIFFUSE)};

void play_fog(Player& p) {
    const GLenum pname = p.enumerant({TERRAZZO_E(GL_FOG_DENSITY), TERRAZZO_E(GL_FOG_START),
                                      TERRAZZO_E(GL_FOG_END), TERRAZZO_E(GL_FOG_INDEX)});
    if (p.pick(2)) {
        p.gl().Fogf(pname, p.number());
    } else {
        p.gl().Fogi(pname, p.integer());
    }
}

void play_fog_mode(Player& p) {
    p.gl().Fogf(GL_FOG_MODE,
                enumerant_number(p, {TERRAZZO_E(GL_LINEAR), TERRAZZO_E(GL_EXP), TERRAZZO_E(GL_EXP2)}));
}

// PopAttrib does not restore these two in the reference, so they stay as they are while something is saved.
void play_fog_sources(Player& p) {
    const GLfloat source =
        enumerant_number(p, {TERRAZZO_E(GL_FOG_COORDINATE), TERRAZZO_E(GL_FRAGMENT_DEPTH)});
    const unsigned choice = p.pick(3);
    p.note(std::to_string(choice));
    GLint depth = 0;
    p.gl().GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    if (depth > 0) return;
    if (choice == 0) return p.gl().Fogf(GL_FOG_COORDINATE_SOURCE, source);
    choice == 1 ? p.gl().Enable(GL_COLOR_SUM) : p.gl().Disable(GL_COLOR_SUM);
}

void play_light_vector(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightVectors);
    p.gl().Lightfv(light, pname, p.numbers(4).data());
}

void play_light_integers(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightVectors);
    const GLint values[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
    p.gl().Lightiv(light, pname, values);
}

void play_light_scalar(Player& p) {
    const GLenum light = p.enumerant(kLights);
    const GLenum pname = p.enumerant(kLightScalars);
    const GLfloat special[] = {45, 90, 91, 128, 129, 180, -0.5f};
    const GLfloat value = p.pick(2) ? special[p.pick(7)] : p.number();
    p.note(std::to_string(value));
    p.gl().Lightf(light, pname, value);
}

void play_light_model(Player& p) {
    switch (p.pick(4)) {
        case 0:
            return p.gl().LightModelfv(GL_LIGHT_MODEL_AMBIENT, p.numbers(4).data());
        case 1:
            return p.gl().LightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, p.number());
        case 2:
            return p.gl().LightModeli(GL_LIGHT_MODEL_TWO_SIDE, p.integer());
    }
    p.gl().LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                       static_cast<GLint>(p.enumerant(
                           {TERRAZZO_E(GL_SINGLE_COLOR), TERRAZZO_E(GL_SEPARATE_SPECULAR_COLOR)})));
}

void play_shininess(Player& p) {
    const GLenum face = p.enumerant(kFaces);
    p.gl().Materialf(face, GL_SHININESS, p.number());
}

const Command kCommands[] = {
    {"glFog", play_fog},
    {"glFog mode", play_fog_mode},
    {"glFogfv(GL_FOG_COLOR)", [](Player& p) { p.gl().Fogfv(GL_FOG_COLOR, p.numbers(4).data()); }},
    {"glLightfv", play_light_vector},
    {"glLightiv", play_light_integers},
    {"glLightf", play_light_scalar},
    {"glLightModel", play_light_model},
    {"glMaterialfv", play_material},
    {"glMaterialf(GL_SHININESS)", play_shininess},
    {"glColorMaterial",
     [](Player& p) {
         const GLenum face = p.enumerant(kFaces);
         p.gl().ColorMaterial(face, p.enumerant(kMaterialColors));
     }},
    {"glShadeModel",
     [](Player& p) {
         p.gl().ShadeModel(p.enumerant({TERRAZZO_E(GL_FLAT), TERRAZZO_E(GL_SMOOTH)}));
     }},
    {"colour sum and source of fog coordinates", play_fog_sources},
};

}  // namespace

void play_material(Player& p) {
    const GLenum face = p.enumerant(kFaces);
    const GLenum pname = p.enumerant(kMaterialVectors);
    p.gl().Materialfv(face, pname, p.numbers(4).data());
}

std::span<const Command> lighting_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
