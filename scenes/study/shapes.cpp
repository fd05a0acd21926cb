// Simple meshes of the study's scenes, and how any mesh is drawn.
#include "shapes.h"

namespace terrazzo::study {

Mesh make_floor(float half_edge, float height) {
    const float e = half_edge;
    return {{{{-e, height, e}, {0, 0}},
             {{e, height, e}, {1, 0}},
             {{e, height, -e}, {1, 1}},
             {{-e, height, -e}, {0, 1}}},
            {0, 1, 2, 0, 2, 3}};
}

Mesh make_cube() {
    // Per face: normal axis direction, then the two axes that span it, right-handed as seen from outside.
    constexpr float kFaces[6][3][3] = {
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
        {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
    constexpr float kCorners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Mesh mesh;
    for (const auto& [normal, right, up] : kFaces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [s, t] : kCorners) {
            Vertex vertex{};
            for (int axis = 0; axis < 3; ++axis)
                vertex.position[axis] = normal[axis] + s * right[axis] + t * up[axis];
            vertex.texture[0] = (s + 1) / 2;
            vertex.texture[1] = (t + 1) / 2;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t offset : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + offset);
    }
    return mesh;
}

Mesh make_open_pyramid() {
    constexpr float kBase[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    Mesh mesh;
    for (int side = 0; side < 4; ++side) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto& from = kBase[side];
        const auto& to = kBase[(side + 1) % 4];
        mesh.vertices.push_back({{from[0], -1, from[1]}, {0, 0}});
        mesh.vertices.push_back({{to[0], -1, to[1]}, {1, 0}});
        mesh.vertices.push_back({{0, 1, 0}, {0.5F, 1}});
        for (const std::uint32_t offset : {0U, 1U, 2U}) mesh.indices.push_back(first + offset);
    }
    return mesh;
}

void draw_mesh(const kit::Gl& gl, const Mesh& mesh) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), mesh.vertices[0].position);
    gl.TexCoordPointer(2, GL_FLOAT, sizeof(Vertex), mesh.vertices[0].texture);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT,
                    mesh.indices.data());
    gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.DisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace terrazzo::study
