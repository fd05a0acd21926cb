// Meshes of the study's scenes: indexed triangles with positions and texture coordinates, counter-clockwise
// outside.
#pragma once

#include <cstdint>
#include <vector>

#include "kit/drawing.h"

namespace terrazzo::study {

struct Vertex {
    float position[3];
    float texture[2];
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

Mesh make_floor(float half_edge, float height);
Mesh make_cube();          // half edge 1, one texture tile a face
Mesh make_open_pyramid();  // apex (0,1,0), base corners (+-1,-1,+-1), no base
// The Utah teapot: 4096 triangles, about 3 wide, standing on y = 0.
Mesh make_teapot();

// Client arrays and one glDrawElements.
void draw_mesh(const kit::Gl& gl, const Mesh& mesh);

}  // namespace terrazzo::study
