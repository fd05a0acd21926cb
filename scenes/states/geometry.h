// Stage: client side, the meshes of `terrazzo bench states`.
// Input: cells and sheets, the mode they are drawn in. Output: vertices with every attribute, indices in
// runs, one of glDrawElements each. Invariant: sheets are waves at several depths that partly hide one
// another; every second one shows its back.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kit/library.h"

namespace terrazzo::states {

struct Vertex {
    float position[3];
    float normal[3];
    float colour[4];
    std::uint8_t colour_bytes[4];
    float texture[3];    // of unit 0, 2, ...: thrice over a sheet; the third between 0 and 1
    float direction[3];  // of a cube map
    float light_map[2];  // of unit 1, 3, ...: once over a sheet
};

struct Mesh {
    GLenum mode = GL_TRIANGLES;
    std::vector<Vertex> vertices;
    std::vector<GLuint> indices;
    struct Run {
        GLsizei first, count;
    };
    std::vector<Run> runs;
};

// Any mode but GL_POLYGON and GL_LINE_LOOP; an even number of cells.
Mesh make_mesh(int cells, int sheets, GLenum mode);

}  // namespace terrazzo::states
