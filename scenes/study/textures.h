// Textures of the study's scenes, made by arithmetic from fixed seeds so that every machine draws the same
// texels.
#pragma once

#include <cstdint>
#include <vector>

#include "kit/drawing.h"

namespace terrazzo::study {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // rows from the bottom
};

// Integer hash of a lattice point, and value noise in 0..255 over cells of 2^cell_bits texels (no floats:
// exact).
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed);
int value_noise(int x, int y, int cell_bits, std::uint32_t seed);

Image make_bricks(int size, std::uint32_t seed);  // courses of bricks
Image make_crate(int size, std::uint32_t seed);   // planks in a frame
Image make_glaze(int size, std::uint32_t seed);   // porcelain with painted dots

// A new texture object: bilinear, repeating, no mipmaps, as the study samples.
GLuint create_texture(const kit::Gl& gl, const Image& image);
// The same of size x size texels: glazed floor tiles with joints, `tiles` each way. Each is uploaded by
// itself: there are four kinds, and the whole image never stands in the client's memory.
GLuint create_tiled_texture(const kit::Gl& gl, int size, int tiles, std::uint32_t seed);

}  // namespace terrazzo::study
