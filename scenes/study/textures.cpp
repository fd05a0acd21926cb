// Textures of the study's scenes. Integer arithmetic only: a few milliseconds for the largest, the same
// everywhere.
#include "textures.h"

#include <algorithm>
#include <array>

namespace terrazzo::study {
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t value = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
    value = (value ^ (value >> 15)) * 0x2C1B3C6DU;
    value = (value ^ (value >> 12)) * 0x297A2D39U;
    return value ^ (value >> 15);
}

namespace {

struct NoiseCorners {
    int bottom_left, bottom_right, top_left, top_right;  // 0 to 255
};

NoiseCorners noise_corners(int column, int row, std::uint32_t seed) {
    const auto corner = [&](int dx, int dy) {
        return static_cast<int>(
            hash(static_cast<std::uint32_t>(column + dx), static_cast<std::uint32_t>(row + dy), seed) >> 24);
    };
    return {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
}

int mix_corners(const NoiseCorners& c, int x, int y, int cell_bits) {
    const int cell = 1 << cell_bits;
    const int fx = x & (cell - 1), fy = y & (cell - 1);
    const int bottom = c.bottom_left * (cell - fx) + c.bottom_right * fx;
    const int top = c.top_left * (cell - fx) + c.top_right * fx;
    return (bottom * (cell - fy) + top * fy) >> (2 * cell_bits);
}

struct Colour {
    int r, g, b;
};

template <typename Shade>
Image fill(int size, Shade shade) {
    Image image{size, size, std::vector<std::uint8_t>(static_cast<std::size_t>(size) * size * 4)};
    std::uint8_t* texel = image.rgba.data();
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x, texel += 4) {
            const Colour colour = shade(x, y);
            texel[0] = static_cast<std::uint8_t>(std::clamp(colour.r, 0, 255));
            texel[1] = static_cast<std::uint8_t>(std::clamp(colour.g, 0, 255));
            texel[2] = static_cast<std::uint8_t>(std::clamp(colour.b, 0, 255));
            texel[3] = 255;
        }
    return image;
}

Colour scaled(Colour colour, int numerator, int denominator) {
    return {colour.r * numerator / denominator, colour.g * numerator / denominator,
            colour.b * numerator / denominator};
}

// value_noise() for texels that come row by row: a cell's corners are found once.
class NoiseRows {
  public:
    NoiseRows(int cell_bits, std::uint32_t seed) : m_cell_bits(cell_bits), m_seed(seed) {}

    int at(int x, int y) {
        const int column = x >> m_cell_bits, row = y >> m_cell_bits;
        if (column != m_column || row != m_row) {
            m_column = column, m_row = row;
            m_corners = noise_corners(column, row, m_seed);
        }
        return mix_corners(m_corners, x, y, m_cell_bits);
    }

  private:
    int m_cell_bits;
    std::uint32_t m_seed;
    int m_column = -1, m_row = -1;
    NoiseCorners m_corners{};
};

// Coarse plus fine noise around 256, as a brightness factor.
class Grain {
  public:
    Grain(int coarse_bits, std::uint32_t seed) : m_coarse(coarse_bits, seed), m_fine(1, seed + 1) {}
    int at(int x, int y) { return 200 + m_coarse.at(x, y) / 4 + m_fine.at(x, y) / 8; }

  private:
    NoiseRows m_coarse, m_fine;
};

GLuint create_repeating(const kit::Gl& gl, int width, int height, const void* texels) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    return name;
}

}  // namespace

int value_noise(int x, int y, int cell_bits, std::uint32_t seed) {
    return mix_corners(noise_corners(x >> cell_bits, y >> cell_bits, seed), x, y, cell_bits);
}

Image make_bricks(int size, std::uint32_t seed) {
    constexpr Colour kMortar{170, 164, 152};
    constexpr Colour kBrick{168, 74, 52};
    const int course = size / 8, length = size / 4;
    return fill(size, [=, grain = Grain(3, seed)](int x, int y) mutable {
        const int row = y / course;
        const int shifted = x + (row & 1) * length / 2;
        const int column = shifted / length % 4;
        const bool mortar = y % course < course / 8 + 1 || shifted % length < course / 8 + 1;
        const int fired =
            200 + static_cast<int>(
                      hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), seed) >> 25);
        return scaled(scaled(mortar ? kMortar : kBrick, grain.at(x, y), 256), mortar ? 256 : fired, 256);
    });
}

Image make_crate(int size, std::uint32_t seed) {
    constexpr Colour kFrame{150, 104, 58};
    constexpr Colour kPlank{188, 140, 86};
    const int border = size / 10, plank = size / 5;
    return fill(size, [=](int x, int y) {
        const int edge = std::min(std::min(x, size - 1 - x), std::min(y, size - 1 - y));
        const bool diagonal = std::abs(x - y) < border / 2;
        const bool gap = !diagonal && edge >= border && x % plank < 2;
        const bool frame = edge < border || diagonal;
        const int wood = 190 + value_noise(frame ? x : x * 8, y, 4, seed) / 4;
        return gap ? Colour{48, 32, 20} : scaled(frame ? kFrame : kPlank, wood, 256);
    });
}

Image make_glaze(int size, std::uint32_t seed) {
    constexpr Colour kPorcelain{232, 236, 240};
    constexpr Colour kBlue{34, 66, 150};
    const int cell = size / 8;
    return fill(size, [=, grain = Grain(4, seed)](int x, int y) mutable {
        const int dx = x % cell - cell / 2, dy = y % cell - cell / 2;
        const bool dot = (x / cell + y / cell) % 2 == 0 && dx * dx + dy * dy < cell * cell / 9;
        const bool band = y < cell / 2 || y >= size - cell / 2;
        return scaled(dot || band ? kBlue : kPorcelain, grain.at(x, y), 256);
    });
}

GLuint create_texture(const kit::Gl& gl, const Image& image) {
    return create_repeating(gl, image.width, image.height, image.rgba.data());
}

GLuint create_tiled_texture(const kit::Gl& gl, int size, int tiles, std::uint32_t seed) {
    constexpr Colour kJoint{70, 66, 62};
    constexpr Colour kGlazes[] = {{196, 178, 150}, {150, 92, 70}, {92, 112, 128}, {212, 206, 192}};
    const int edge = size / tiles, joint = edge / 24 + 1;
    std::vector<int> grains(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge));
    Grain grain(4, seed);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) grains[static_cast<std::size_t>(y * edge + x)] = grain.at(x, y);
    std::array<Image, 4> glazed;
    for (std::size_t i = 0; i < glazed.size(); ++i) {
        glazed[i] = fill(edge, [&](int x, int y) {
            return scaled(x < joint || y < joint ? kJoint : kGlazes[i],
                          grains[static_cast<std::size_t>(y * edge + x)], 256);
        });
    }
    const GLuint name = create_repeating(gl, size, size, nullptr);
    for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
            const std::uint32_t dice =
                hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), seed);
            const Image& tile = glazed[((column + row) & 1) + 2 * (dice >> 31)];
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, column * edge, row * edge, edge, edge, GL_RGBA,
                             GL_UNSIGNED_BYTE, tile.rgba.data());
        }
    }
    return name;
}

}  // namespace terrazzo::study
