// What the chapters' commands (the other files here) are made of, and what they share.
//
// A command draws its arguments from the player and notes them. Arguments are drawn in statements of their
// own where a command takes several: the order in which C++ evaluates arguments is not defined, and both
// libraries must get the same calls.
#pragma once

#include <span>

#include "player.h"

#define TERRAZZO_E(name) \
    Player::Enumerant {  \
        name, #name      \
    }

namespace terrazzo::test {

using Player = StatePlayer;
using Enumerants = std::vector<Player::Enumerant>;

struct Command {
    const char* name;
    void (*play)(Player& p);
};

std::span<const Command> transformation_commands();
std::span<const Command> lighting_commands();
std::span<const Command> rasterization_commands();
std::span<const Command> texturing_commands();
std::span<const Command> fragments_commands();
std::span<const Command> vertices_commands();
std::span<const Command> pixels_commands();
std::span<const Command> modes_commands();

// Enumerants as the values that parameter commands take.
inline GLfloat enumerant_number(Player& p, const Enumerants& valid) {
    return static_cast<GLfloat>(p.enumerant(valid));
}

// One of the texture units.
GLenum texture_unit(Player& p);
void play_material(Player& p);

inline const Enumerants kCapabilities = {TERRAZZO_E(GL_ALPHA_TEST),
                                         TERRAZZO_E(GL_BLEND),
                                         TERRAZZO_E(GL_CLIP_PLANE0),
                                         TERRAZZO_E(GL_CLIP_PLANE5),
                                         TERRAZZO_E(GL_COLOR_LOGIC_OP),
                                         TERRAZZO_E(GL_COLOR_MATERIAL),
                                         TERRAZZO_E(GL_CULL_FACE),
                                         TERRAZZO_E(GL_DEPTH_TEST),
                                         TERRAZZO_E(GL_DITHER),
                                         TERRAZZO_E(GL_FOG),
                                         TERRAZZO_E(GL_INDEX_LOGIC_OP),
                                         TERRAZZO_E(GL_LIGHT0),
                                         TERRAZZO_E(GL_LIGHT7),
                                         TERRAZZO_E(GL_LIGHTING),
                                         TERRAZZO_E(GL_LINE_SMOOTH),
                                         TERRAZZO_E(GL_LINE_STIPPLE),
                                         TERRAZZO_E(GL_MULTISAMPLE),
                                         TERRAZZO_E(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                         TERRAZZO_E(GL_SAMPLE_ALPHA_TO_ONE),
                                         TERRAZZO_E(GL_SAMPLE_COVERAGE),
                                         TERRAZZO_E(GL_NORMALIZE),
                                         TERRAZZO_E(GL_POINT_SMOOTH),
                                         TERRAZZO_E(GL_POINT_SPRITE),
                                         TERRAZZO_E(GL_POLYGON_OFFSET_FILL),
                                         TERRAZZO_E(GL_POLYGON_OFFSET_LINE),
                                         TERRAZZO_E(GL_POLYGON_OFFSET_POINT),
                                         TERRAZZO_E(GL_POLYGON_SMOOTH),
                                         TERRAZZO_E(GL_POLYGON_STIPPLE),
                                         TERRAZZO_E(GL_RESCALE_NORMAL),
                                         TERRAZZO_E(GL_SCISSOR_TEST),
                                         TERRAZZO_E(GL_STENCIL_TEST),
                                         TERRAZZO_E(GL_STENCIL_TEST_TWO_SIDE_EXT),
                                         TERRAZZO_E(GL_TEXTURE_1D),
                                         TERRAZZO_E(GL_TEXTURE_2D),
                                         TERRAZZO_E(GL_TEXTURE_3D),
                                         TERRAZZO_E(GL_TEXTURE_CUBE_MAP),
                                         TERRAZZO_E(GL_TEXTURE_GEN_Q),
                                         TERRAZZO_E(GL_TEXTURE_GEN_R),
                                         TERRAZZO_E(GL_TEXTURE_GEN_S),
                                         TERRAZZO_E(GL_TEXTURE_GEN_T)};

inline const Enumerants kComparisons = {
    TERRAZZO_E(GL_NEVER),   TERRAZZO_E(GL_LESS),     TERRAZZO_E(GL_EQUAL),  TERRAZZO_E(GL_LEQUAL),
    TERRAZZO_E(GL_GREATER), TERRAZZO_E(GL_NOTEQUAL), TERRAZZO_E(GL_GEQUAL), TERRAZZO_E(GL_ALWAYS)};

inline const Enumerants kFaces = {TERRAZZO_E(GL_FRONT), TERRAZZO_E(GL_BACK), TERRAZZO_E(GL_FRONT_AND_BACK)};

}  // namespace terrazzo::test
