// Stage: models from files, as plain data between the program that loads them and the child that draws them.
// Input: filled by load_model (OpenImageIO and tinygltf live only there). Output: packed bytes, or a Drawing.
// Invariant: every index is below its part's vertex count; a texture number is -1 or valid; no list is empty
// that its neighbours count on.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kit/drawing.h"

namespace terrazzo::gltf {

struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // the first row is texture coordinate t = 0
};

struct Texture {
    std::vector<Level> levels;  // down to 1x1 when the sampler asks for mipmaps, else one
    int wrap_s = GL_REPEAT;
    int wrap_t = GL_REPEAT;
    int mag_filter = GL_LINEAR;
    int min_filter = GL_LINEAR;
};

// glTF's metallic-roughness surface in the terms of fixed-function lighting.
struct Material {
    float diffuse[4] = {1, 1, 1, 1};
    float specular[3] = {0, 0, 0};
    float emission[3] = {0, 0, 0};
    float shininess = 1;
    int texture = -1;
    bool double_sided = false;
    bool blended = false;
    float alpha_cutoff = 0;  // 0: no alpha test
};

struct Part {
    int mode = GL_TRIANGLES;
    int material = 0;
    float matrix[16] = {};
    bool mirrored = false;         // the matrix turns the winding round
    std::vector<float> positions;  // 3 a vertex
    std::vector<float> normals;    // 3 a vertex, or empty: unlit
    std::vector<float> textures;   // 2 a vertex, or empty
    std::vector<float> colours;    // 4 a vertex, or empty
    std::vector<std::uint32_t> indices;
};

struct Model {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Part> parts;
    float centre[3] = {0, 0, 0};
    float radius = 1;
};

std::vector<std::uint8_t> pack(const Model& model);
Model unpack(
    std::span<const std::uint8_t> bytes);  // throws std::exception on bytes that pack() did not write

// The whole model in view from above, two directional lights, GL 1.1 arrays; other frames turn it.
std::unique_ptr<kit::Drawing> create_drawing(Model model);

}  // namespace terrazzo::gltf
