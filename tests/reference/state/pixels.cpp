// Pixel store, transfer, maps and zoom, and the raster position (GL 1.5 §3.6, §2.13).
#include <iterator>

#include "commands.h"

namespace terrazzo::test {
namespace {

void play_window_position(Player& p) {
    const auto v = p.moderate_numbers(3);
    if (p.pick(2)) return p.gl().WindowPos3f(v[0], v[1], v[2]);
    p.gl().WindowPos2i(p.integer(), 7);
}

void play_pixel_store(Player& p) {
    const GLenum pname = p.enumerant(
        {TERRAZZO_E(GL_UNPACK_SWAP_BYTES), TERRAZZO_E(GL_UNPACK_LSB_FIRST), TERRAZZO_E(GL_UNPACK_ROW_LENGTH),
         TERRAZZO_E(GL_UNPACK_SKIP_ROWS), TERRAZZO_E(GL_UNPACK_SKIP_PIXELS), TERRAZZO_E(GL_UNPACK_ALIGNMENT),
         TERRAZZO_E(GL_UNPACK_IMAGE_HEIGHT), TERRAZZO_E(GL_UNPACK_SKIP_IMAGES),
         TERRAZZO_E(GL_PACK_SWAP_BYTES), TERRAZZO_E(GL_PACK_LSB_FIRST), TERRAZZO_E(GL_PACK_ROW_LENGTH),
         TERRAZZO_E(GL_PACK_SKIP_ROWS), TERRAZZO_E(GL_PACK_SKIP_PIXELS), TERRAZZO_E(GL_PACK_ALIGNMENT),
         TERRAZZO_E(GL_PACK_IMAGE_HEIGHT), TERRAZZO_E(GL_PACK_SKIP_IMAGES)});
    // Small, because glPolygonStipple reads its pattern by them.
    const GLint value = static_cast<GLint>(p.pick(12)) - 2;
    p.note(std::to_string(value));
    p.gl().PixelStorei(pname, value);
}

void play_pixel_transfer(Player& p) {
    const GLenum pname =
        p.enumerant({TERRAZZO_E(GL_MAP_COLOR), TERRAZZO_E(GL_MAP_STENCIL), TERRAZZO_E(GL_RED_SCALE),
                     TERRAZZO_E(GL_RED_BIAS), TERRAZZO_E(GL_GREEN_SCALE), TERRAZZO_E(GL_BLUE_BIAS),
                     TERRAZZO_E(GL_ALPHA_SCALE), TERRAZZO_E(GL_DEPTH_SCALE), TERRAZZO_E(GL_DEPTH_BIAS)});
    if (p.pick(3)) return p.gl().PixelTransferf(pname, p.moderate_number());
    const GLenum integer = p.enumerant({TERRAZZO_E(GL_INDEX_SHIFT), TERRAZZO_E(GL_INDEX_OFFSET)});
    const GLint value = static_cast<GLint>(p.pick(64)) - 32;
    p.note(std::to_string(value));
    p.gl().PixelTransferi(integer, value);
}

void play_pixel_map(Player& p) {
    constexpr GLsizei kSizes[] = {1, 2, 8, 16, 0, -1, 512};  // the reference lets I_TO_I have any
    const GLsizei size = kSizes[p.pick(std::size(kSizes))];
    p.note(std::to_string(size));
    const std::vector<GLfloat> values(512, 0.5f);
    p.gl().PixelMapfv(GL_PIXEL_MAP_I_TO_I + p.pick(10), size, values.data());
}

const Command kCommands[] = {
    {"glWindowPos", play_window_position},
    {"glPixelStorei", play_pixel_store},
    {"glPixelTransferf", play_pixel_transfer},
    {"glPixelMapfv", play_pixel_map},
    {"glPixelZoom",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().PixelZoom(v[0], v[1]);
     }},
};

}  // namespace

std::span<const Command> pixels_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
