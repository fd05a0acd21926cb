// Set-up, the last stage before the bins: points, lines and triangles by vertex slot become primitives
// in bin lists.
//
// Points and lines are set up at once, triangles sixteen at a time; all reach the lists in the order of the
// calls, the triangles by the next flush().
#pragma once

#include "pipeline/geometry/draw_state.h"
#include "pipeline/geometry/geometry_table.h"
#include "pipeline/geometry/primitive_observer.h"
#include "pipeline/schedule/bin_lists.h"

namespace terrazzo::pipeline {

// How the filled polygons of a draw are set up.
TriangleSetup triangle_setup(const DrawState& state);

class PrimitiveSetup {
  public:
    // With an observer nothing is set up.
    PrimitiveSetup(BinLists& lists, const ShadedVertices& vertices, const DrawState& state,
                   PrimitiveObserver* observer);
    PrimitiveSetup(const PrimitiveSetup&) = delete;
    PrimitiveSetup& operator=(const PrimitiveSetup&) = delete;

    // The rules and the vertices must stay as they are until the next flush().
    void triangle(const TriangleSetup& rules, int a, int b, int c) {
        if (m_rules != &rules) flush();
        m_rules = &rules;
        const int i = m_batch.count++;
        m_batch.v0[i] = a, m_batch.v1[i] = b, m_batch.v2[i] = c;
        if (m_batch.count == kBatchTriangles) flush();
    }
    void flush();

    // A square of pixels round the vertex, or a sprite (point.cpp).
    void point(int v);
    // A parallelogram along the major axis (line.cpp).
    void line(int a, int b);

    // The points and lines that follow are those of a polygon's back side, or not: to the stencil test they
    // are still polygons (GL 2.0 §4.1.4).
    void set_back_facing(bool back) { m_back_facing = back; }
    bool back_facing() const { return m_back_facing; }

    bool is_observed() const { return m_observer != nullptr; }
    // The next line is one where a line stipple would begin anew.
    void restart_lines() { m_restarts = true; }

    static constexpr int kBatchTriangles = 16;

  private:
    struct Sink : PrimitiveSink {
        BinLists* lists;
    };
    // A rectangle of pixels, x1 and y1 exclusive.
    struct Box {
        int32_t x0, y0, x1, y1;
    };

    float point_size(int v) const;
    void sprite(int v);
    raster::Primitive* constant_square(int v, const Box& box, int edge_count);

    // The pixels whose centres a rectangle of sub-pixels holds. Of its borders the left one counts, and the
    // one that is lower in GL's orientation.
    Box pixels_within(int32_t x0, int32_t y0, int32_t x1, int32_t y1) const {
        const int32_t beyond = m_state.raster.row0_is_top ? 256 : 255;
        return {(x0 + 255) >> 8, (y0 + beyond) >> 8, (x1 + 255) >> 8, (y1 + beyond) >> 8};
    }
    // Whatever pixel a rectangle of sub-pixels touches, counted from its corner.
    static Box touched_pixels(int32_t x0, int32_t y0, int32_t x1, int32_t y1) {
        return {x0 >> 8, y0 >> 8, (x1 >> 8) + 1, (y1 >> 8) + 1};
    }
    // The outline of four corners, a positive one.
    void set_edges(raster::Primitive& primitive, const int32_t (&x)[4], const int32_t (&y)[4]) const;

    // Null where nothing of the box lies within the scissor.
    raster::Primitive* new_primitive(const raster::FragmentState& state, const Box& box, int edge_count);

    BinLists& m_lists;
    const ShadedVertices& m_vertices;
    const DrawState& m_state;
    const GeometryTable& m_geometry;
    Sink m_sink;
    const TriangleSetup* m_rules = nullptr;
    TriangleBatch m_batch;
    PrimitiveObserver* const m_observer;
    bool m_restarts = false;
    bool m_back_facing = false;
};

}  // namespace terrazzo::pipeline
