// Matrices, viewport and clip planes (GL 1.5 §2.11, §2.12).
#include "commands.h"

namespace terrazzo::test {
namespace {

const Enumerants kClipPlanes = {TERRAZZO_E(GL_CLIP_PLANE0), TERRAZZO_E(GL_CLIP_PLANE1),
                                TERRAZZO_E(GL_CLIP_PLANE5)};

// Matrices are kept moderate. When one becomes singular by rounding, the inverse that the reference finds
// depends on what it had looked at before: PopAttrib, for one, may work out an inverse that nothing asked
// for.
void play_clip_plane(Player& p) {
    const GLenum plane = p.enumerant(kClipPlanes);
    const auto values = p.moderate_numbers(4);
    const GLdouble equation[4] = {values[0], values[1], values[2], values[3]};
    p.gl().ClipPlane(plane, equation);
}

void play_volume(Player& p) {
    GLdouble side[6];
    for (GLdouble& value : side) value = p.moderate_number();
    if (p.pick(2)) {
        p.gl().Frustum(side[0], side[1], side[2], side[3], side[4], side[5]);
    } else {
        p.gl().Ortho(side[0], side[1], side[2], side[3], side[4], side[5]);
    }
}

void play_matrix(Player& p) {
    const auto values = p.moderate_numbers(16);
    if (p.pick(2)) {
        p.gl().MultMatrixf(values.data());
    } else {
        p.gl().LoadMatrixf(values.data());
    }
}

const Command kCommands[] = {
    {"glMatrixMode",
     [](Player& p) {
         p.gl().MatrixMode(
             p.enumerant({TERRAZZO_E(GL_MODELVIEW), TERRAZZO_E(GL_PROJECTION), TERRAZZO_E(GL_TEXTURE)}));
     }},
    {"glPushMatrix", [](Player& p) { p.gl().PushMatrix(); }},
    {"glPopMatrix", [](Player& p) { p.gl().PopMatrix(); }},
    {"glLoadIdentity", [](Player& p) { p.gl().LoadIdentity(); }},
    {"glRotatef",
     [](Player& p) {
         const auto v = p.moderate_numbers(4);
         p.gl().Rotatef(v[0], v[1], v[2], v[3]);
     }},
    {"glTranslatef",
     [](Player& p) {
         const auto v = p.moderate_numbers(3);
         p.gl().Translatef(v[0], v[1], v[2]);
     }},
    {"glScaled",
     [](Player& p) {
         const auto v = p.moderate_numbers(3);
         p.gl().Scaled(v[0], v[1], v[2]);
     }},
    {"glFrustum or glOrtho", play_volume},
    {"glMultMatrixf or glLoadMatrixf", play_matrix},
    {"glClipPlane", play_clip_plane},
    {"glViewport",
     [](Player& p) {
         const GLint v[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
         p.gl().Viewport(v[0], v[1], v[2], v[3]);
     }},
    {"glDepthRange and glClipControl",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().DepthRange(v[0], v[1]);
         p.gl().ClipControl(v[0] < 0.5 ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                            v[1] < 0.5 ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
     }},
};

}  // namespace

std::span<const Command> transformation_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
