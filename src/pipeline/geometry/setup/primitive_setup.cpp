// Set-up of triangles in batches and what all primitives share; see primitive_setup.h.
#include "pipeline/geometry/setup/primitive_setup.h"

#include <algorithm>
#include <new>

namespace terrazzo::pipeline {

using raster::Primitive;

TriangleSetup triangle_setup(const DrawState& state) {
    const RasterState& r = state.raster;
    TriangleSetup setup;
    setup.state = &state.fragment->fill;
    setup.x0 = r.x0, setup.y0 = r.y0, setup.x1 = r.x1, setup.y1 = r.y1;
    setup.cull_front = r.cull_front;
    setup.cull_back = r.cull_back;
    setup.front_is_clockwise = r.front_is_clockwise;
    setup.row0_is_top = r.row0_is_top;
    setup.multisample = state.fragment->fill.multisample;
    setup.flat = r.flat;
    setup.two_sided = state.vertex.lighting.enabled && state.vertex.lighting.two_sided;
    setup.offset = r.offset_fill;
    setup.offset_factor = r.offset_factor;
    setup.offset_units = r.offset_units;
    return setup;
}

PrimitiveSetup::PrimitiveSetup(BinLists& lists, const ShadedVertices& vertices, const DrawState& state,
                               PrimitiveObserver* observer)
    : m_lists(lists), m_vertices(vertices), m_state(state), m_geometry(geometry()), m_observer(observer) {
    m_sink.lists = &lists;
    m_sink.allocate = [](PrimitiveSink& sink, int plane_count) {
        Arena& arena = static_cast<Sink&>(sink).lists->arena();
        return new (arena.allocate(Primitive::size_of(plane_count))) Primitive;
    };
    m_sink.commit = [](PrimitiveSink& sink, Primitive& primitive) {
        static_cast<Sink&>(sink).lists->add(primitive);
    };
}

void PrimitiveSetup::flush() {
    if (m_batch.count == 0) return;
    if (m_observer) {
        const int count = m_batch.count;
        m_batch.count = 0;
        for (int i = 0; i < count; ++i)
            m_observer->triangle(m_vertices, m_batch.v0[i], m_batch.v1[i], m_batch.v2[i]);
        return;
    }
    for (int i = m_batch.count; i < kBatchTriangles; ++i)
        m_batch.v0[i] = m_batch.v1[i] = m_batch.v2[i] = m_batch.v0[0];
    m_geometry.setup_triangles(*m_rules, m_vertices, m_batch, m_sink);
    m_batch.count = 0;
}

Primitive* PrimitiveSetup::new_primitive(const raster::FragmentState& state, const Box& box, int edge_count) {
    const RasterState& r = m_state.raster;
    const int32_t x0 = std::max(box.x0, r.x0), x1 = std::min(box.x1, r.x1);
    const int32_t y0 = std::max(box.y0, r.y0), y1 = std::min(box.y1, r.y1);
    if (x0 >= x1 || y0 >= y1) return nullptr;
    const int plane_count = 2 + state.varyings.count;
    Primitive* const p = new (m_lists.arena().allocate(Primitive::size_of(plane_count))) Primitive;
    p->state = &state;
    p->x0 = static_cast<int16_t>(x0);
    p->y0 = static_cast<int16_t>(y0);
    p->x1 = static_cast<int16_t>(x1);
    p->y1 = static_cast<int16_t>(y1);
    p->edge_count = static_cast<uint8_t>(edge_count);
    p->plane_count = static_cast<uint8_t>(plane_count);
    p->back_facing = m_back_facing;
    p->steep = false;
    p->is_cut = true;
    p->depth_offset = 0;
    p->data = raster::RectangleData::kNone;
    return p;
}

void PrimitiveSetup::set_edges(Primitive& primitive, const int32_t (&x)[4], const int32_t (&y)[4]) const {
    for (int e = 0; e < 4; ++e) {
        const int next = (e + 1) & 3;
        primitive.edges[e] = raster::Edge::between(x[e], y[e], x[next], y[next], m_state.raster.row0_is_top,
                                                   primitive.state->multisample);
    }
}

}  // namespace terrazzo::pipeline
