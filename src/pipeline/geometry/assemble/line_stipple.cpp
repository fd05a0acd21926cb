// Line stipple (GL 1.5 §3.4.2) by cutting: each run of set bits becomes a line of its own, whose ends are
// interpolated in the window, every attribute alike. The counter takes a step for each pixel of the major
// axis and goes on with the next line of a strip; what restarts it, does so whether it gets here or is
// clipped.
#include <cmath>

#include "pipeline/geometry/assemble/stages.h"

namespace terrazzo::pipeline {

void PrimitiveStages::line(int a, int b) {
    const RasterState& r = m_state.raster;
    if (r.flat && (r.line_stipple || r.line_smooth)) {
        // What follows interpolates: both ends get the last vertex's colour first.
        copy_vertex(a, kFlatEnd);
        copy_colors(b, kFlatEnd);
        a = kFlatEnd;
    }
    if (!r.line_stipple) return solid_line(a, b);
    stippled_line(a, b);
}

void PrimitiveStages::stippled_line(int a, int b) {
    const float dx = std::fabs(m_vertices.column(kWindowX)[a] - m_vertices.column(kWindowX)[b]);
    const float dy = std::fabs(m_vertices.column(kWindowY)[a] - m_vertices.column(kWindowY)[b]);
    const bool rectangular = m_state.raster.line_smooth || m_state.raster.multisample;
    const float length = rectangular ? std::sqrt(dx * dx + dy * dy) : dx > dy ? dx : dy;
    if (!(length < 131072.0f)) return;  // not a number, or more than a viewport can hold
    const auto steps = static_cast<uint32_t>(std::ceil(length));
    const auto factor = static_cast<uint32_t>(m_state.raster.line_stipple_factor);
    const auto is_set = [&](uint32_t step) {
        return (m_state.raster.line_stipple_pattern >> ((m_stipple_counter + step) / factor & 15) & 1) != 0;
    };
    uint32_t step = 0;
    while (step < steps) {
        while (step < steps && !is_set(step)) ++step;
        const uint32_t start = step;
        while (step < steps && is_set(step)) ++step;
        if (start == step) break;
        const float t0 = static_cast<float>(start) / length;
        segment(a, b, t0, step < steps ? static_cast<float>(step) / length : 1.0f);
    }
    m_stipple_counter += steps;
}

void PrimitiveStages::segment(int a, int b, float t0, float t1) {
    int ends[2] = {a, b};
    const auto cut = [&](int end, float t) {
        ends[end] = kFirstSegment + end;
        for (int column = 0; column < m_columns; ++column) {
            float* const values = m_vertices.column(column);
            values[ends[end]] = values[a] + t * (values[b] - values[a]);
        }
    };
    if (t0 > 0) cut(0, t0);
    if (t1 < 1) cut(1, t1);
    solid_line(ends[0], ends[1]);
}

}  // namespace terrazzo::pipeline
