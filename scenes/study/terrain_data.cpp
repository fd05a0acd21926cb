// T6's landscape from integer value noise. The texture has four texels a cell; its light is a Lambert term
// from the height differences of neighbouring texels, computed once here, as the study's texture brings it
// baked.
#include "terrain_data.h"

#include <algorithm>
#include <cmath>

namespace terrazzo::study {
namespace {

constexpr int kCells = 256;
constexpr int kTexelsPerCell = 4;
constexpr int kTexels = kCells * kTexelsPerCell;
constexpr float kHighest = 3;
constexpr std::uint32_t kSeed = 20;

// Octaves from 256 texels down to 8, each of half the height. Sums to 0..252.
int fractal_height(int x, int y) {
    int sum = 0;
    for (int octave = 0; octave < 6; ++octave)
        sum += value_noise(x, y, 8 - octave, kSeed + static_cast<std::uint32_t>(octave)) * 32 >> octave;
    return sum / 64;
}

struct Heights {
    int width = kTexels + 1;
    std::vector<float> values;
    float at(int x, int y) const { return values[static_cast<std::size_t>(y) * width + x]; }
};

Heights make_heights() {
    Heights heights;
    heights.values.resize(static_cast<std::size_t>(heights.width) * heights.width);
    for (int y = 0; y < heights.width; ++y)
        for (int x = 0; x < heights.width; ++x)
            heights.values[static_cast<std::size_t>(y) * heights.width + x] =
                kHighest * static_cast<float>(fractal_height(x, y)) / 252.0F;
    return heights;
}

Mesh make_mesh(const Heights& heights) {
    constexpr std::uint32_t kRow = kCells + 1;
    Mesh mesh;
    mesh.vertices.reserve(kRow * kRow);
    for (int z = 0; z <= kCells; ++z)
        for (int x = 0; x <= kCells; ++x)
            mesh.vertices.push_back(
                {{static_cast<float>(x - kCells / 2), heights.at(x * kTexelsPerCell, z * kTexelsPerCell),
                  static_cast<float>(z - kCells / 2)},
                 {static_cast<float>(x) / kCells, static_cast<float>(z) / kCells}});
    mesh.indices.reserve(static_cast<std::size_t>(kCells) * kCells * 6);
    for (std::uint32_t z = 0; z < kCells; ++z)
        for (std::uint32_t x = 0; x < kCells; ++x) {
            const std::uint32_t a = z * kRow + x, b = a + 1, c = a + kRow, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, d, a, d, b});
        }
    return mesh;
}

// Water, sand, grass, rock, snow by height; the light falls from the left.
void shade(float height, float slope_x, float slope_z, int dither, std::uint8_t* texel) {
    struct Band {
        float from;
        float r, g, b;
    };
    constexpr Band kBands[] = {{0.0F, 40, 76, 130},
                               {1.05F, 190, 176, 128},
                               {1.2F, 84, 128, 56},
                               {1.75F, 118, 104, 88},
                               {2.1F, 236, 238, 242}};
    const Band* band = kBands;
    const float bent = height + static_cast<float>(dither - 128) / 700.0F;
    for (const Band& candidate : kBands)
        if (bent >= candidate.from) band = &candidate;
    const bool water = band == kBands;
    const float nx = water ? 0 : -slope_x * 2.2F, nz = water ? 0 : -slope_z * 2.2F;
    const float lambert = (0.75F - 0.62F * nx + 0.22F * nz) / std::sqrt(1 + nx * nx + nz * nz);
    const float light =
        std::clamp(0.25F + 0.95F * lambert, 0.15F, 1.15F) * (0.94F + static_cast<float>(dither) / 4096);
    texel[0] = static_cast<std::uint8_t>(std::min(255.0F, band->r * light));
    texel[1] = static_cast<std::uint8_t>(std::min(255.0F, band->g * light));
    texel[2] = static_cast<std::uint8_t>(std::min(255.0F, band->b * light));
    texel[3] = 255;
}

Image make_image(const Heights& heights) {
    Image image{kTexels, kTexels, std::vector<std::uint8_t>(static_cast<std::size_t>(kTexels) * kTexels * 4)};
    std::uint8_t* texel = image.rgba.data();
    for (int z = 0; z < kTexels; ++z)
        for (int x = 0; x < kTexels; ++x, texel += 4) {
            const int left = std::max(x - 2, 0), right = std::min(x + 2, kTexels);
            const int down = std::max(z - 2, 0), up = std::min(z + 2, kTexels);
            const float slope_x =
                (heights.at(right, z) - heights.at(left, z)) * 16 / static_cast<float>(right - left);
            const float slope_z =
                (heights.at(x, up) - heights.at(x, down)) * 16 / static_cast<float>(up - down);
            shade(heights.at(x, z), slope_x, slope_z, value_noise(x, z, 2, kSeed + 9), texel);
        }
    return image;
}

}  // namespace

HeightField make_height_field() {
    const Heights heights = make_heights();
    return {make_mesh(heights), make_image(heights)};
}

}  // namespace terrazzo::study
