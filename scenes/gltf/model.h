// Stage: models from files, as plain data between the program that loads them and the child that draws them.
// Input: filled by load_model (OpenImageIO and tinygltf live only there). Output: packed bytes, or a Drawing.
// Invariant: every index is below its geometry's vertex count; a texture number is -1 or valid, a geometry's
// and a material's number are valid; no list is empty that its neighbours count on.
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

// A texture with the matrix that its coordinates go through.
struct TextureUse {
    int texture = -1;
    float matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

// glTF's metallic-roughness surface in the terms of fixed-function lighting (doc/models.md).
struct Material {
    float diffuse[4] = {1, 1, 1, 1};
    float specular[3] = {0, 0, 0};
    float emission[3] = {0, 0, 0};
    float shininess = 1;
    TextureUse base;      // multiplies
    TextureUse emissive;  // is added, its factor already in it
    bool metal = false;   // the highlight has the surface's own colour
    bool unlit = false;
    bool double_sided = false;
    bool blended = false;
    float alpha_cutoff = 0;  // 0: no alpha test
};

struct Geometry {
    int mode = GL_TRIANGLES;
    std::vector<float> positions;             // 3 a vertex
    std::vector<float> normals;               // 3 a vertex, or empty: unlit
    std::vector<float> base_coordinates;      // 2 a vertex, or empty
    std::vector<float> emissive_coordinates;  // 2 a vertex, or empty
    std::vector<float> colours;               // 4 a vertex with the material's diffuse colour in it, or empty
    std::vector<std::uint32_t> indices;
};

// One place of a geometry.
struct Part {
    int geometry = 0;
    int material = 0;
    float matrix[16] = {};
    float centre[3] = {0, 0, 0};  // of its bounding box, in the scene
    bool mirrored = false;        // the matrix turns the winding round
};

struct Camera {
    std::string name;
    float view[16] = {};  // from the scene to the eye
    bool perspective = true;
    float field_of_view = 0;      // vertical, in radians; perspective
    float half_size[2] = {1, 1};  // orthographic
    float near_plane = 0;
    float far_plane = 0;  // 0: endless; perspective
};

struct Model {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Geometry> geometries;
    std::vector<Part> parts;
    std::vector<Camera> cameras;
    float centre[3] = {0, 0, 0};
    float radius = 1;
};

std::vector<std::uint8_t> pack(const Model& model);
Model unpack(
    std::span<const std::uint8_t> bytes);  // throws std::exception on bytes that pack() did not write

// Seen by one of the model's cameras, or, with -1, from where the whole model fits. Throws
// std::runtime_error when there is no such camera.
std::unique_ptr<kit::Drawing> create_drawing(Model model, int camera = -1);

}  // namespace terrazzo::gltf
