// Smooth lines and points: pairs of triangles in vertex slots of their own.
#pragma once

#include "pipeline/geometry/setup/primitive_setup.h"
#include "pipeline/geometry/shaded_vertices.h"

namespace terrazzo::pipeline {

class SmoothShapes {
  public:
    SmoothShapes(PrimitiveSetup& setup, ShadedVertices& vertices, const DrawState& state, int columns);

    void line(int a, int b);
    void point(int v);

    // Two triangles take four slots; those that wait for set-up hold on to theirs.
    static constexpr int kSlots = 4 * (PrimitiveSetup::kBatchTriangles / 2 + 1);
    static constexpr int kFirstSlot = ShadedVertices::kCapacity - kSlots;

  private:
    int take_slots();
    // Makes slot `slot` of vertex `from`, moved within the window and with coverage varyings.
    int corner(int slot, int from, float dx, float dy, const float (&coverage)[4]);

    PrimitiveSetup& m_setup;
    ShadedVertices& m_vertices;
    const DrawState& m_state;
    const int m_columns;
    // Front and back sides: of lines and points that are a polygon's.
    const TriangleSetup m_line[2], m_point[2];
    int m_next_slot = 0;
};

}  // namespace terrazzo::pipeline
