// Polygons on their way to lines, points or a fill of their own (GL 1.5 §3.5.4): facing, culling, the colours
// of the side that shows, depth offset, the provoking vertex's colours, then the edges or corners that are
// part of the outline. See stages.h; the arithmetic is that of doc/reference.md §3.3.
#include <algorithm>
#include <cmath>

#include "pipeline/geometry/assemble/stages.h"

namespace terrazzo::pipeline {

namespace {

// Into [0, 1]; NaN becomes 0.
float saturate(float v) {
    return v > 0 ? (v > 1 ? 1.0f : v) : 0.0f;
}

float larger(float a, float b) {
    return a > b ? a : b;
}

}  // namespace

PrimitiveStages::PrimitiveStages(PrimitiveSetup& setup, ShadedVertices& vertices, const DrawState& state,
                                 int columns, uint32_t& stipple_counter)
    : m_setup(setup),
      m_vertices(vertices),
      m_state(state),
      m_columns(columns),
      m_stipple_counter(stipple_counter),
      m_two_sided(state.vertex.lighting.enabled && state.vertex.lighting.two_sided),
      m_smooth(setup, vertices, state, columns),
      m_filled(triangle_setup(state)) {
    const RasterState& r = state.raster;
    const bool unfilled = r.fill[0] != FillMode::kFill || r.fill[1] != FillMode::kFill;
    const bool in_use = unfilled || r.point_smooth || r.line_smooth || r.line_stipple || r.polygon_stipple;
    // Any of the offsets sends a draw through the reference's chain, though each moves only its own kind.
    const bool offsets = r.offset_fill || r.offset_line || r.offset_point;
    m_takes_triangles =
        setup.is_observed() || (in_use && (unfilled || r.polygon_stipple || offsets || m_two_sided));
    m_filled.two_sided = false;
    m_filled.offset = false;
}

void PrimitiveStages::copy_vertex(int from, int to) {
    for (int column = 0; column < m_columns; ++column) {
        float* const values = m_vertices.column(column);
        values[to] = values[from];
    }
}

void PrimitiveStages::copy_colors(int from, int to) {
    const raster::Varyings& varyings = m_state.vertex.varyings;
    for (int i = 0; i < varyings.count; ++i) {
        if (!varyings.is_color(i)) continue;
        float* const values = m_vertices.column(kFirstVarying + i);
        values[to] = values[from];
    }
}

PrimitiveStages::Facing PrimitiveStages::facing(const int (&v)[3]) const {
    const float* const x = m_vertices.column(kWindowX);
    const float* const y = m_vertices.column(kWindowY);
    const float ex = x[v[0]] - x[v[2]], ey = y[v[0]] - y[v[2]];
    const float fx = x[v[1]] - x[v[2]], fy = y[v[1]] - y[v[2]];
    const float determinant = ex * fy - ey * fx;
    // Of no area: a back side, whichever way round the front is.
    const bool counter_clockwise = m_state.raster.row0_is_top ? determinant < 0 : determinant > 0;
    return {determinant, determinant == 0 || counter_clockwise == m_state.raster.front_is_clockwise};
}

void PrimitiveStages::copy_triangle(const int (&v)[3], int (&copies)[3]) {
    for (int i = 0; i < 3; ++i) {
        copies[i] = kFirstCopy + m_next_copy + i;
        copy_vertex(v[i], copies[i]);
    }
    m_next_copy = (m_next_copy + 3) % kCopySlots;
}

void PrimitiveStages::take_back_colors(const int (&v)[3]) {
    const raster::Varyings& varyings = m_state.vertex.varyings;
    for (int i = 0; i < varyings.count; ++i) {
        if (!varyings.is_color(i)) continue;
        float* const front = m_vertices.column(kFirstVarying + i);
        const float* const back = m_vertices.column(kFirstVarying + varyings.count + i);
        for (const int slot : v) front[slot] = back[slot];
    }
}

void PrimitiveStages::offset_depth(const int (&v)[3], float determinant) {
    const float* const x = m_vertices.column(kWindowX);
    const float* const y = m_vertices.column(kWindowY);
    float* const z = m_vertices.column(kWindowZ);
    const float ex = x[v[0]] - x[v[2]], ey = y[v[0]] - y[v[2]], ez = z[v[0]] - z[v[2]];
    const float fx = x[v[1]] - x[v[2]], fy = y[v[1]] - y[v[2]], fz = z[v[1]] - z[v[2]];
    const float inverse = 1.0f / determinant;
    const float dzdx = std::fabs((ey * fz - ez * fy) * inverse);
    const float dzdy = std::fabs((ez * fx - ex * fz) * inverse);
    const float offset = m_state.raster.offset_units + larger(dzdx, dzdy) * m_state.raster.offset_factor;
    for (const int slot : v) z[slot] = saturate(z[slot] + offset);
}

void PrimitiveStages::triangle(const int (&polygon)[3], const bool (&edges)[3], bool restarts) {
    const RasterState& r = m_state.raster;
    const Facing side = facing(polygon);
    if (side.back ? r.cull_back : r.cull_front) return;
    const FillMode mode = r.fill[side.back ? 1 : 0];
    const bool flattens = r.flat && mode != FillMode::kFill;
    const bool offsets = mode == FillMode::kFill   ? r.offset_fill
                         : mode == FillMode::kLine ? r.offset_line
                                                   : r.offset_point;
    int v[3] = {polygon[0], polygon[1], polygon[2]};
    if (m_two_sided || offsets || flattens) copy_triangle(polygon, v);
    if (m_two_sided && side.back && side.determinant != 0) take_back_colors(v);
    if (offsets) offset_depth(v, side.determinant);
    if (flattens) copy_colors(v[2], v[0]), copy_colors(v[2], v[1]);
    m_setup.set_back_facing(side.back);
    switch (mode) {
        case FillMode::kFill:
            m_setup.triangle(m_filled, v[0], v[1], v[2]);
            return;
        case FillMode::kLine:
            if (restarts) restart_lines();
            // From the last corner on: that is the order in which a polygon's stipple runs round it.
            if (edges[2]) line(v[2], v[0]);
            if (edges[0]) line(v[0], v[1]);
            if (edges[1]) line(v[1], v[2]);
            return;
        case FillMode::kPoint:
            for (int i = 0; i < 3; ++i)
                if (edges[i]) point(v[i]);
            return;
    }
}

void PrimitiveStages::point(int v) {
    if (m_state.raster.point_smooth) return m_smooth.point(v);
    m_setup.point(v);
}

}  // namespace terrazzo::pipeline
