// Primitive assembly; see assemble.h.
#include "pipeline/assemble.h"

#include <algorithm>

namespace terrazzo::pipeline {

namespace {

// Vertices of one chunk: the most that ShadedVertices holds before clipping adds some.
constexpr uint32_t kChunkVertices = 12288;

int column_count(const VertexState& state) {
    const bool back_colors = state.lighting.enabled && state.lighting.two_sided;
    return kFirstVarying + state.varyings.count * (back_colors ? 2 : 1);
}

TriangleSetup triangle_setup(const DrawState& state) {
    const RasterState& r = state.raster;
    TriangleSetup setup;
    setup.state = &state.fragment->state;
    setup.x0 = r.x0, setup.y0 = r.y0, setup.x1 = r.x1, setup.y1 = r.y1;
    setup.cull_front = r.cull_front;
    setup.cull_back = r.cull_back;
    setup.front_is_clockwise = r.front_is_clockwise;
    setup.row0_is_top = r.row0_is_top;
    setup.flat = r.flat;
    setup.two_sided = state.vertex.lighting.enabled && state.vertex.lighting.two_sided;
    setup.offset = r.offset_fill;
    setup.offset_factor = r.offset_factor;
    setup.offset_units = r.offset_units;
    return setup;
}

// How many primitives `count` vertices make.
uint32_t primitive_count(PrimitiveMode mode, uint32_t count) {
    const auto beyond = [&](uint32_t used) { return count > used ? count - used : 0; };
    switch (mode) {
        case PrimitiveMode::kPoints:
            return count;
        case PrimitiveMode::kLines:
            return count / 2;
        case PrimitiveMode::kLineLoop:
            return count >= 2 ? count : 0;
        case PrimitiveMode::kLineStrip:
            return beyond(1);
        case PrimitiveMode::kTriangles:
            return count / 3;
        case PrimitiveMode::kTriangleStrip:
        case PrimitiveMode::kTriangleFan:
        case PrimitiveMode::kPolygon:
            return beyond(2);
        case PrimitiveMode::kQuads:
            return count / 4;
        case PrimitiveMode::kQuadStrip:
            return beyond(2) / 2;
    }
    return 0;
}

// Positions [first, end) that primitives [first, last) use, besides the pivot.
struct Positions {
    uint32_t first, end;
};
Positions positions_of(PrimitiveMode mode, uint32_t first, uint32_t last, uint32_t count) {
    switch (mode) {
        case PrimitiveMode::kPoints:
            return {first, last};
        case PrimitiveMode::kLines:
            return {2 * first, 2 * last};
        case PrimitiveMode::kLineLoop:
            return {first, std::min(last + 1, count)};
        case PrimitiveMode::kLineStrip:
            return {first, last + 1};
        case PrimitiveMode::kTriangles:
            return {3 * first, 3 * last};
        case PrimitiveMode::kTriangleStrip:
            return {first, last + 2};
        case PrimitiveMode::kTriangleFan:
        case PrimitiveMode::kPolygon:
            return {first + 1, last + 2};
        case PrimitiveMode::kQuads:
            return {4 * first, 4 * last};
        case PrimitiveMode::kQuadStrip:
            return {2 * first, 2 * last + 2};
    }
    return {0, 0};
}

bool has_pivot(PrimitiveMode mode) {
    return mode == PrimitiveMode::kTriangleFan || mode == PrimitiveMode::kPolygon ||
           mode == PrimitiveMode::kLineLoop;
}

// Primitives whose positions, and the pivot, fit a chunk.
uint32_t chunk_primitives(PrimitiveMode mode) {
    switch (mode) {
        case PrimitiveMode::kTriangles:
            return kChunkVertices / 3;
        case PrimitiveMode::kQuads:
            return kChunkVertices / 4;
        case PrimitiveMode::kLines:
        case PrimitiveMode::kQuadStrip:
            return kChunkVertices / 2 - 2;
        default:
            return kChunkVertices - 16;
    }
}

}  // namespace

PrimitiveAssembler::PrimitiveAssembler(Frame& frame, ShadedVertices& vertices, ShadedVertices& pivot,
                                       const DrawState& state, const VertexInput& input)
    : m_frame(frame),
      m_vertices(vertices),
      m_state(state),
      m_input(input),
      m_geometry(geometry()),
      m_setup(triangle_setup(state)),
      m_clipper(state.vertex, vertices, column_count(state.vertex), state.raster.flat),
      m_pivot(pivot) {
    m_sink.frame = &frame;
    m_sink.allocate = [](PrimitiveSink& sink, int plane_count) {
        Arena& arena = static_cast<Sink&>(sink).frame->arena();
        return new (arena.allocate(raster::Primitive::size_of(plane_count))) raster::Primitive;
    };
    m_sink.commit = [](PrimitiveSink& sink, raster::Primitive& primitive) {
        static_cast<Sink&>(sink).frame->add(primitive);
    };
    vertices.reserve(column_count(state.vertex));
}

void PrimitiveAssembler::draw(PrimitiveMode mode, const VertexRange& range) {
    const uint32_t primitives = primitive_count(mode, range.count);
    const uint32_t step = chunk_primitives(mode);
    for (uint32_t first = 0; first < primitives; first += step) {
        // The frame may be drawn and begun again between chunks; what this draw needs is kept by each anew.
        if (m_frame.full()) m_frame.draw();
        m_frame.keep(m_state.fragment);
        const uint32_t last = std::min(first + step, primitives);
        if (range.indices == nullptr || !draw_index_range(mode, range, first, last))
            draw_positions(mode, range, first, last);
    }
}

// Shades each vertex of an indexed draw once, where the indices lie close enough together for that to be less
// work.
bool PrimitiveAssembler::draw_index_range(PrimitiveMode mode, const VertexRange& range, uint32_t first,
                                          uint32_t last) {
    const Positions at = positions_of(mode, first, last, range.count);
    const auto [low, high] = std::minmax_element(range.indices + at.first, range.indices + at.end);
    const uint32_t pivot = range.indices[0];
    const uint32_t base = has_pivot(mode) ? std::min(*low, pivot) : *low;
    const uint32_t top = has_pivot(mode) ? std::max(*high, pivot) : *high;
    const uint32_t span = top - base;  // one less than the vertices
    if (span >= at.end - at.first || span >= kChunkVertices) return false;
    m_geometry.shade_vertices(m_state.vertex, m_input, nullptr, base, static_cast<int>(span + 1), m_vertices);
    m_chunk = {};
    m_chunk.indices = range.indices;
    m_chunk.index_base = base;
    m_shaded = m_next_slot = static_cast<int>(span + 1);
    assemble(mode, range.count, first, last);
    return true;
}

// Shades the vertex at each position.
void PrimitiveAssembler::draw_positions(PrimitiveMode mode, const VertexRange& range, uint32_t first,
                                        uint32_t last) {
    const Positions at = positions_of(mode, first, last, range.count);
    const uint32_t* const elements = range.indices ? range.indices + at.first : nullptr;
    m_chunk = {};
    m_chunk.first_position = at.first;
    m_shaded = static_cast<int>(at.end - at.first);
    if (has_pivot(mode) && at.first > 0) {
        // Sixteen slots at the end of the chunk, so that the vertex program can work on whole batches.
        m_chunk.pivot_slot = (m_shaded + 15) & ~15;
        m_pivot.reserve(column_count(m_state.vertex));
        m_geometry.shade_vertices(m_state.vertex, m_input, range.indices, range.indices ? 0 : range.first, 1,
                                  m_pivot);
        m_shaded = m_chunk.pivot_slot + 1;
    }
    m_geometry.shade_vertices(m_state.vertex, m_input, elements, range.first + at.first,
                              static_cast<int>(at.end - at.first), m_vertices);
    if (m_chunk.pivot_slot >= 0) {
        for (int column = 0; column < column_count(m_state.vertex); ++column)
            m_vertices.column(column)[m_chunk.pivot_slot] = m_pivot.column(column)[0];
    }
    m_next_slot = m_shaded;
    assemble(mode, range.count, first, last);
}

int PrimitiveAssembler::slot(uint32_t position) const {
    if (m_chunk.indices) return static_cast<int>(m_chunk.indices[position] - m_chunk.index_base);
    if (position == 0 && m_chunk.pivot_slot >= 0) return m_chunk.pivot_slot;
    return static_cast<int>(position - m_chunk.first_position);
}

void PrimitiveAssembler::assemble(PrimitiveMode mode, uint32_t count, uint32_t first, uint32_t last) {
    switch (mode) {
        case PrimitiveMode::kPoints:
            for (uint32_t i = first; i < last; ++i) point(slot(i));
            break;
        case PrimitiveMode::kLines:
            for (uint32_t i = first; i < last; ++i) line(slot(2 * i), slot(2 * i + 1), true);
            break;
        case PrimitiveMode::kLineStrip:
        case PrimitiveMode::kLineLoop:
            for (uint32_t i = first; i < last; ++i) line(slot(i), slot(i + 1 == count ? 0 : i + 1), i == 0);
            break;
        case PrimitiveMode::kTriangles:
            for (uint32_t i = first; i < last; ++i) {
                const int a = slot(3 * i), b = slot(3 * i + 1), c = slot(3 * i + 2);
                triangle(a, b, c, edge_flag(a), edge_flag(b), edge_flag(c));
            }
            break;
        case PrimitiveMode::kTriangleStrip:
            for (uint32_t i = first; i < last; ++i)
                triangle(slot(i + (i & 1)), slot(i + 1 - (i & 1)), slot(i + 2), true, true, true);
            break;
        case PrimitiveMode::kTriangleFan:
            for (uint32_t i = first; i < last; ++i)
                triangle(slot(0), slot(i + 1), slot(i + 2), true, true, true);
            break;
        case PrimitiveMode::kQuads:
            for (uint32_t i = first; i < last; ++i) {
                const int v[4] = {slot(4 * i), slot(4 * i + 1), slot(4 * i + 2), slot(4 * i + 3)};
                triangle(v[0], v[1], v[3], edge_flag(v[0]), false, edge_flag(v[3]));
                triangle(v[1], v[2], v[3], edge_flag(v[1]), edge_flag(v[2]), false);
            }
            break;
        case PrimitiveMode::kQuadStrip:
            for (uint32_t i = first; i < last; ++i) {
                const int v[4] = {slot(2 * i + 2), slot(2 * i), slot(2 * i + 1), slot(2 * i + 3)};
                triangle(v[0], v[1], v[3], true, false, true);
                triangle(v[1], v[2], v[3], true, true, false);
            }
            break;
        case PrimitiveMode::kPolygon:
            for (uint32_t i = first; i < last; ++i) {
                const int a = slot(i + 1), b = slot(i + 2), c = slot(0);
                triangle(a, b, c, edge_flag(a), i + 3 == count && edge_flag(b), i == 0 && edge_flag(c));
            }
            break;
    }
    flush_triangles();
}

// Clipping is about to need slots: when the chunk's are used up, primitives that wait for theirs are set up
// first.
void PrimitiveAssembler::make_room(int slots) {
    if (m_next_slot + slots <= ShadedVertices::kCapacity) return;
    flush_triangles();
    m_next_slot = m_shaded;
}

void PrimitiveAssembler::triangle(int a, int b, int c, bool ab, bool bc, bool ca) {
    const int32_t* const outcodes = m_vertices.integers(kOutcode);
    if (outcodes[a] & outcodes[b] & outcodes[c]) return;
    if ((outcodes[a] | outcodes[b] | outcodes[c]) == 0) {
        emit_triangle(a, b, c, ab, bc, ca);
        return;
    }
    make_room(kMaxClipSlots);
    const ClippedPolygon polygon = m_clipper.clip({a, b, c}, {ab, bc, ca}, m_next_slot);
    for (int i = 2; i < polygon.count; ++i) {
        emit_triangle(polygon.vertices[i - 1], polygon.vertices[i], polygon.vertices[0], polygon.edges[i - 1],
                      i + 1 == polygon.count && polygon.edges[i], i == 2 && polygon.edges[0]);
    }
}

void PrimitiveAssembler::emit_triangle(int a, int b, int c, bool ab, bool bc, bool ca) {
    if (m_state.raster.fill[0] != FillMode::kFill || m_state.raster.fill[1] != FillMode::kFill) {
        unfilled_triangle({a, b, c}, {ab, bc, ca});
        return;
    }
    const int i = m_batch.count++;
    m_batch.v0[i] = a, m_batch.v1[i] = b, m_batch.v2[i] = c;
    if (m_batch.count == 16) flush_triangles();
}

void PrimitiveAssembler::flush_triangles() {
    if (m_batch.count == 0) return;
    for (int i = m_batch.count; i < 16; ++i) m_batch.v0[i] = m_batch.v1[i] = m_batch.v2[i] = m_batch.v0[0];
    m_geometry.setup_triangles(m_setup, m_vertices, m_batch, m_sink);
    m_batch.count = 0;
}

}  // namespace terrazzo::pipeline
