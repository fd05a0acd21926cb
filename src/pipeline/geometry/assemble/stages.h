// What may happen to a primitive between clipping and set-up: polygons drawn as lines or points (GL 1.5
// §3.5.4), line stipple (§3.4.2), smooth points and lines (§3.3.2, §3.4.3). Primitives come and go by vertex
// slot, in GL's order.
//
// The reference does all of it in a chain of stages of its own, with arithmetic of its own: polygons that
// pass it are faced by their unsnapped positions, and carry their offset and their side's colours in the
// vertices. So does this.
#pragma once

#include <cstdint>

#include "pipeline/geometry/assemble/smooth.h"
#include "pipeline/geometry/setup/primitive_setup.h"
#include "pipeline/geometry/shaded_vertices.h"

namespace terrazzo::pipeline {

class PrimitiveStages {
  public:
    // `stipple_counter` counts the pixels of a stippled strip and outlives the draw that is cut in two.
    PrimitiveStages(PrimitiveSetup& setup, ShadedVertices& vertices, const DrawState& state, int columns,
                    uint32_t& stipple_counter);

    // A piece of the draw is about to come. Where a vertex of it is clipped the reference sends all of it
    // through its chain, which faces polygons in another way.
    void begin_piece(bool clipped) { m_chained = clipped && m_state.raster.line_stipple; }
    // Whether filled polygons of this piece have to pass as well.
    bool takes_triangles() const { return m_takes_triangles || m_chained; }

    void point(int v);
    void line(int a, int b);
    // edges[i] says whether the edge from vertex i to the next is part of the polygon's outline; `restarts`:
    // the stipple begins anew with it within its polygon.
    void triangle(const int (&v)[3], const bool (&edges)[3], bool restarts);
    // The stipple begins anew with the line or polygon that comes next, or would have come had it not been
    // clipped away.
    void restart_lines() {
        m_stipple_counter = 0;
        m_setup.restart_lines();
    }

  private:
    // Vertices that stages make live in slots of their own, in turn: triangles that wait for set-up hold on
    // to theirs.
    static constexpr int kCopySlots = 3 * (PrimitiveSetup::kBatchTriangles + 1);
    static constexpr int kFirstCopy = ShadedVertices::kFirstStageSlot;
    static constexpr int kFlatEnd = kFirstCopy + kCopySlots;
    static constexpr int kFirstSegment = kFlatEnd + 1;
    static_assert(kFirstSegment + 2 <= SmoothShapes::kFirstSlot);

    void copy_vertex(int from, int to);
    void copy_colors(int from, int to);

    // unfilled.cpp
    struct Facing {
        float determinant;
        bool back;
    };
    Facing facing(const int (&v)[3]) const;
    void copy_triangle(const int (&v)[3], int (&copies)[3]);
    void take_back_colors(const int (&v)[3]);
    void offset_depth(const int (&v)[3], float determinant);

    // line_stipple.cpp
    void stippled_line(int a, int b);
    void segment(int a, int b, float t0, float t1);
    void solid_line(int a, int b) { m_state.raster.line_smooth ? m_smooth.line(a, b) : m_setup.line(a, b); }

    PrimitiveSetup& m_setup;
    ShadedVertices& m_vertices;
    const DrawState& m_state;
    const int m_columns;
    uint32_t& m_stipple_counter;
    const bool m_two_sided;
    bool m_takes_triangles;
    bool m_chained = false;
    SmoothShapes m_smooth;
    TriangleSetup m_filled;  // rules of filled polygons whose facing and offset are done with
    int m_next_copy = 0;
};

}  // namespace terrazzo::pipeline
