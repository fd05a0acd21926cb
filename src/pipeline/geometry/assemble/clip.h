// Clipping of triangles against the view volume and the user's planes (GL 1.5 §2.12), as the reference does
// it (doc/reference.md §3): plane after plane, new vertices from the end nearer to the plane, the polygon
// fanned anew.
#pragma once

#include <cstdint>

#include "pipeline/geometry/shaded_vertices.h"
#include "pipeline/geometry/vertex_state.h"

namespace terrazzo::pipeline {

// A convex polygon by vertex slots; edge i leads from vertex i to the next.
struct ClippedPolygon {
    static constexpr int kMaxVertices = 3 + 6 + kMaxClipPlanes;
    int count = 0;
    int vertices[kMaxVertices];
    bool edges[kMaxVertices];  // the edge is part of the polygon's outline
};

// How many slots one clipped triangle may take.
inline constexpr int kMaxClipSlots = 2 * (6 + kMaxClipPlanes) + 2;

class Clipper {
  public:
    // `columns` is the number of columns in use; new vertices go to slots from `first_slot` on.
    Clipper(const VertexState& state, ShadedVertices& vertices, int columns, bool flat)
        : m_state(state), m_vertices(vertices), m_columns(columns), m_flat(flat) {}

    // Clips the triangle; the result has no vertex where nothing is left. `slot` is the next free slot.
    ClippedPolygon clip(const int (&triangle)[3], const bool (&edges)[3], int& slot);

    // Clips a line in place to two slots; false where nothing is left.
    bool clip_line(int& a, int& b, int& slot);

  private:
    int interpolate(float t, int from, int to, int& slot);
    float distance(int plane, int vertex) const;
    void copy_flat(int from, int to);

    const VertexState& m_state;
    ShadedVertices& m_vertices;
    int m_columns;
    bool m_flat;
};

}  // namespace terrazzo::pipeline
