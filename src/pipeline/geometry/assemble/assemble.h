// Primitive assembly (GL 1.5 §2.6.1): the vertices of a piece of a draw are shaded, and its points, lines and
// triangles go through clipping and the stages behind it to set-up, in order. Quads and polygons are cut into
// triangles as the reference cuts them; the last vertex of each triangle is the provoking one.
#pragma once

#include "pipeline/geometry/assemble/clip.h"
#include "pipeline/geometry/assemble/pieces.h"
#include "pipeline/geometry/assemble/stages.h"
#include "pipeline/geometry/draw_state.h"
#include "pipeline/geometry/setup/primitive_setup.h"
#include "pipeline/schedule/bin_lists.h"

namespace terrazzo::pipeline {

// Memory for the vertices of a piece. One serves all draws of a thread.
struct PieceVertices {
    ShadedVertices shaded;
    ShadedVertices pivot;  // the vertex of a fan or loop that a piece does not contain
};

class PrimitiveAssembler {
  public:
    // Throws std::bad_alloc.
    PrimitiveAssembler(BinLists& lists, PieceVertices& vertices, uint32_t& stipple_counter,
                       const DrawState& state, const VertexInput& input,
                       PrimitiveObserver* observer = nullptr);

    // Throws std::bad_alloc.
    void draw(const Piece& piece);

  private:
    // One chunk: where the vertex at a position of the draw stands among the shaded ones.
    struct Chunk {
        uint32_t first_position = 0;        // of the contiguous part
        int pivot_slot = -1;                // of the one vertex outside it (fan centre, start of a loop)
        const uint32_t* indices = nullptr;  // set where slots are index - index_base
        uint32_t index_base = 0;
    };
    bool shade_index_range(const Piece& piece);
    void shade_positions(const Piece& piece);
    bool is_clipped() const;
    void assemble(const Piece& piece);
    void assemble_quads(const Piece& piece);
    void assemble_quad_strip(const Piece& piece);
    void assemble_polygon(const Piece& piece);
    int slot(uint32_t position) const;
    bool edge_flag(int slot) const {
        return !m_state.vertex.edge_flags || m_vertices.integers(kEdgeFlagColumn)[slot] != 0;
    }

    void point(int v);
    void line(int a, int b, bool restarts);
    // Which edges of a triangle are inside the polygon it is a part of, whatever their vertices' flags.
    enum class Inside : uint8_t { kNone, kSecond, kThird };
    void triangle(int a, int b, int c, Inside inside = Inside::kNone, bool starts_polygon = true) {
        triangle_with_edges({a, b, c},
                            {edge_flag(a), inside != Inside::kSecond && edge_flag(b),
                             inside != Inside::kThird && edge_flag(c)},
                            starts_polygon);
    }
    void triangle_with_edges(const int (&v)[3], const bool (&edges)[3], bool starts_polygon);
    void emit_triangle(const int (&v)[3], const bool (&edges)[3], bool restarts);
    void make_room();

    ShadedVertices& m_vertices;
    ShadedVertices& m_pivot;
    const DrawState& m_state;
    const VertexInput& m_input;
    const GeometryTable& m_geometry;
    TriangleSetup m_filled;
    PrimitiveSetup m_setup;
    PrimitiveStages m_stages;
    Clipper m_clipper;
    Chunk m_chunk;
    // Nothing of this chunk is clipped and its polygons pass no stage: the reference then cuts quads another
    // way.
    bool m_direct = false;
    int m_shaded = 0;     // slots the vertex program filled
    int m_next_slot = 0;  // first slot free for clipping
};

}  // namespace terrazzo::pipeline
