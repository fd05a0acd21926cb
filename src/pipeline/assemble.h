// Primitive assembly (GL 1.5 §2.6.1): a draw is cut into chunks of vertices, each chunk is shaded, and its
// points, lines and triangles go on to clipping and set-up in order. Triangles are cut from quads and
// polygons as the reference cuts them; the last vertex of each is the provoking one.
#pragma once

#include "pipeline/clip.h"
#include "pipeline/frame.h"
#include "pipeline/renderer.h"

namespace terrazzo::pipeline {

class PrimitiveAssembler {
  public:
    PrimitiveAssembler(Frame& frame, ShadedVertices& vertices, ShadedVertices& pivot, const DrawState& state,
                       const VertexInput& input);

    void draw(PrimitiveMode mode, const VertexRange& range);

  private:
    // One chunk: where the vertex at a position of the draw stands among the shaded ones.
    struct Chunk {
        uint32_t first_position = 0;  // of the contiguous part
        uint32_t pivot_position = 0;  // of the one vertex outside it (fan centre, start of a loop)
        int pivot_slot = -1;
        const uint32_t* indices = nullptr;  // set where slots are index - index_base
        uint32_t index_base = 0;
    };

    bool draw_index_range(PrimitiveMode mode, const VertexRange& range, uint32_t first, uint32_t last);
    void draw_positions(PrimitiveMode mode, const VertexRange& range, uint32_t first, uint32_t last);
    void assemble(PrimitiveMode mode, uint32_t count, uint32_t first, uint32_t last);
    int slot(uint32_t position) const;
    bool edge_flag(int slot) const {
        return !m_state.vertex.edge_flags || m_vertices.integers(kEdgeFlagColumn)[slot] != 0;
    }

    void point(int v);
    // `restarts` is set where the line stipple starts anew.
    void line(int a, int b, bool restarts);
    void triangle(int a, int b, int c, bool ab, bool bc, bool ca);
    void emit_triangle(int a, int b, int c, bool ab, bool bc, bool ca);
    void unfilled_triangle(const int (&v)[3], const bool (&edges)[3]);
    void flush_triangles();
    void make_room(int slots);

    // Points and lines as primitives (point_line.cpp).
    void set_up_point(int v);
    void set_up_line(int a, int b);
    raster::Primitive& new_primitive(int edge_count, bool back_facing);

    struct Sink : PrimitiveSink {
        Frame* frame;
    };

    Frame& m_frame;
    ShadedVertices& m_vertices;
    const DrawState& m_state;
    const VertexInput& m_input;
    const GeometryTable& m_geometry;
    TriangleSetup m_setup;
    TriangleBatch m_batch;
    Clipper m_clipper;
    Sink m_sink;
    Chunk m_chunk;
    ShadedVertices& m_pivot;  // holds the vertex of a fan or loop that a chunk does not contain
    int m_shaded = 0;         // slots the vertex program filled
    int m_next_slot = 0;      // first slot free for clipping
};

}  // namespace terrazzo::pipeline
