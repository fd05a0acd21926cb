// Primitive assembly; see assemble.h.
#include "pipeline/geometry/assemble/assemble.h"

#include <algorithm>
#include <utility>

namespace terrazzo::pipeline {

namespace {

static_assert(PieceSizes::kMost + 16 <= ShadedVertices::kChunkSlots);

int column_count(const VertexState& state) {
    const bool back_colors = state.lighting.enabled && state.lighting.two_sided;
    return kFirstVarying + state.varyings.count * (back_colors ? 2 : 1);
}

}  // namespace

PrimitiveAssembler::PrimitiveAssembler(BinLists& lists, PieceVertices& vertices, uint32_t& stipple_counter,
                                       const DrawState& state, const VertexInput& input,
                                       PrimitiveObserver* observer)
    : m_vertices(vertices.shaded),
      m_pivot(vertices.pivot),
      m_state(state),
      m_input(input),
      m_geometry(geometry()),
      m_filled(triangle_setup(state)),
      m_setup(lists, m_vertices, state, observer),
      m_stages(m_setup, m_vertices, state, column_count(state.vertex), stipple_counter),
      m_clipper(state.vertex, m_vertices, column_count(state.vertex), state.raster.flat) {
    // Smooth shapes put four columns behind the front colours' (smooth.cpp).
    m_vertices.reserve(std::max(column_count(state.vertex), kFirstVarying + state.vertex.varyings.count + 4));
}

void PrimitiveAssembler::draw(const Piece& piece) {
    if (piece.range.indices == nullptr || !shade_index_range(piece)) shade_positions(piece);
    m_next_slot = m_shaded;
    const bool clipped = is_clipped();
    m_filled.cull_unsnapped = clipped;
    m_stages.begin_piece(clipped);
    m_direct = !clipped && !m_stages.takes_triangles();
    assemble(piece);
    m_setup.flush();
}

// Shades each vertex of an indexed draw once, where the indices lie close enough together for that to be less
// work.
bool PrimitiveAssembler::shade_index_range(const Piece& piece) {
    const uint32_t* const indices = piece.range.indices;
    const Positions at = positions_of(piece);
    const auto [low, high] = std::minmax_element(indices + at.first, indices + at.end);
    const uint32_t base = has_pivot(piece.mode) ? std::min(*low, indices[0]) : *low;
    const uint32_t top = has_pivot(piece.mode) ? std::max(*high, indices[0]) : *high;
    const uint32_t span = top - base;  // one less than the vertices
    if (span >= at.end - at.first || span >= PieceSizes::kMost) return false;
    m_shaded = static_cast<int>(span + 1);
    m_geometry.shade_vertices(m_state.vertex, m_input, nullptr, base, m_shaded, m_vertices);
    m_chunk = {};
    m_chunk.indices = indices;
    m_chunk.index_base = base;
    return true;
}

// Shades the vertex at each position.
void PrimitiveAssembler::shade_positions(const Piece& piece) {
    const VertexRange& range = piece.range;
    const Positions at = positions_of(piece);
    const uint32_t* const elements = range.indices ? range.indices + at.first : nullptr;
    const int count = static_cast<int>(at.end - at.first);
    m_chunk = {};
    m_chunk.first_position = at.first;
    m_shaded = count;
    m_geometry.shade_vertices(m_state.vertex, m_input, elements, range.first + at.first, count, m_vertices);
    if (!has_pivot(piece.mode) || at.first == 0) return;
    // Behind the last whole batch that the vertex program wrote.
    m_chunk.pivot_slot = (count + 15) & ~15;
    m_shaded = m_chunk.pivot_slot + 1;
    m_pivot.reserve(column_count(m_state.vertex));
    m_geometry.shade_vertices(m_state.vertex, m_input, range.indices, range.indices ? 0 : range.first, 1,
                              m_pivot);
    for (int column = 0; column < column_count(m_state.vertex); ++column)
        m_vertices.column(column)[m_chunk.pivot_slot] = m_pivot.column(column)[0];
    // Slots between are none of the chunk's vertices.
    for (int slot = count; slot < m_chunk.pivot_slot; ++slot) m_vertices.integers(kOutcode)[slot] = 0;
}

// Whether any vertex of the chunk is outside a clipping plane.
bool PrimitiveAssembler::is_clipped() const {
    const int32_t* const outcodes = m_vertices.integers(kOutcode);
    int32_t any = 0;
    for (int slot = 0; slot < m_shaded; ++slot) any |= outcodes[slot];
    return any != 0;
}

int PrimitiveAssembler::slot(uint32_t position) const {
    if (m_chunk.indices) return static_cast<int>(m_chunk.indices[position] - m_chunk.index_base);
    if (position == 0 && m_chunk.pivot_slot >= 0) return m_chunk.pivot_slot;
    return static_cast<int>(position - m_chunk.first_position);
}

void PrimitiveAssembler::assemble(const Piece& piece) {
    const auto [first, last] = std::pair(piece.first, piece.last);
    const uint32_t count = piece.range.count;
    switch (piece.mode) {
        case PrimitiveMode::kPoints:
            for (uint32_t i = first; i < last; ++i) point(slot(i));
            break;
        case PrimitiveMode::kLines:
            for (uint32_t i = first; i < last; ++i) line(slot(2 * i), slot(2 * i + 1), true);
            break;
        case PrimitiveMode::kLineStrip:
        case PrimitiveMode::kLineLoop:
            for (uint32_t i = first; i < last; ++i)
                line(slot(i), slot(i + 1 == count ? 0 : i + 1), i == 0 && !piece.range.continues);
            break;
        case PrimitiveMode::kTriangles:
            for (uint32_t i = first; i < last; ++i) triangle(slot(3 * i), slot(3 * i + 1), slot(3 * i + 2));
            break;
        case PrimitiveMode::kTriangleStrip:
            for (uint32_t i = first; i < last; ++i)
                triangle(slot(i + (i & 1)), slot(i + 1 - (i & 1)), slot(i + 2));
            break;
        case PrimitiveMode::kTriangleFan:
            for (uint32_t i = first; i < last; ++i) triangle(slot(0), slot(i + 1), slot(i + 2));
            break;
        case PrimitiveMode::kQuads:
            assemble_quads(piece);
            break;
        case PrimitiveMode::kQuadStrip:
            assemble_quad_strip(piece);
            break;
        case PrimitiveMode::kPolygon:
            assemble_polygon(piece);
            break;
    }
}

void PrimitiveAssembler::assemble_quads(const Piece& piece) {
    for (uint32_t i = piece.first; i < piece.last; ++i) {
        const int a = slot(4 * i), b = slot(4 * i + 1), c = slot(4 * i + 2), d = slot(4 * i + 3);
        if (m_direct && piece.range.in_order && !m_state.raster.flat) {
            triangle(a, b, c, Inside::kThird);
            triangle(a, c, d, Inside::kNone, false);
        } else {
            triangle(a, b, d, Inside::kSecond);
            triangle(b, c, d, Inside::kThird, false);
        }
    }
}

void PrimitiveAssembler::assemble_quad_strip(const Piece& piece) {
    for (uint32_t i = piece.first; i < piece.last; ++i) {
        const int a = slot(2 * i), b = slot(2 * i + 1), c = slot(2 * i + 2), d = slot(2 * i + 3);
        if (m_direct) {
            triangle(a, b, d);
            triangle(c, a, d);
        } else {
            triangle(c, a, d, Inside::kSecond);
            triangle(a, b, d, Inside::kThird, false);
        }
    }
}

void PrimitiveAssembler::assemble_polygon(const Piece& piece) {
    const VertexRange& range = piece.range;
    for (uint32_t i = piece.first; i < piece.last; ++i) {
        const int a = slot(i + 1), b = slot(i + 2), c = slot(0);
        const bool first = i == 0 && !range.continues, last = i + 3 == range.count && !range.is_continued;
        triangle_with_edges({a, b, c}, {edge_flag(a), last && edge_flag(b), first && edge_flag(c)}, first);
    }
}

// Clipping is about to need slots: when the chunk's are used up, primitives that wait for theirs are set up
// first.
void PrimitiveAssembler::make_room() {
    if (m_next_slot + kMaxClipSlots <= ShadedVertices::kFirstStageSlot) return;
    m_setup.flush();
    m_next_slot = m_shaded;
}

void PrimitiveAssembler::point(int v) {
    if (m_vertices.integers(kOutcode)[v] == 0) m_stages.point(v);
}

void PrimitiveAssembler::line(int a, int b, bool restarts) {
    make_room();
    if (restarts) m_stages.restart_lines();
    if (m_clipper.clip_line(a, b, m_next_slot)) m_stages.line(a, b);
}

void PrimitiveAssembler::triangle_with_edges(const int (&v)[3], const bool (&edges)[3], bool starts_polygon) {
    if (starts_polygon && m_stages.takes_triangles()) m_stages.restart_lines();
    const int32_t* const outcodes = m_vertices.integers(kOutcode);
    const int32_t a = outcodes[v[0]], b = outcodes[v[1]], c = outcodes[v[2]];
    if ((a | b | c) == 0) return emit_triangle(v, edges, false);
    if (a & b & c) return;
    make_room();
    const ClippedPolygon polygon = m_clipper.clip(v, edges, m_next_slot);
    for (int i = 2; i < polygon.count; ++i) {
        const bool last = i + 1 == polygon.count;
        // Where a clipped part's stipple begins is left to us (GL 1.5 §3.4.2): anew, as in the reference.
        emit_triangle({polygon.vertices[i - 1], polygon.vertices[i], polygon.vertices[0]},
                      {polygon.edges[i - 1], last && polygon.edges[i], i == 2 && polygon.edges[0]}, i == 2);
    }
}

void PrimitiveAssembler::emit_triangle(const int (&v)[3], const bool (&edges)[3], bool restarts) {
    if (m_stages.takes_triangles()) return m_stages.triangle(v, edges, restarts);
    m_setup.triangle(m_filled, v[0], v[1], v[2]);
}

}  // namespace terrazzo::pipeline
