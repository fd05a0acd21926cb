// Smooth lines and points (GL 1.5 §3.3.2, §3.4.3) as two triangles each, whose coverage varyings tell the
// pixel kernel where a fragment stands (raster/pixel/coverage.h). Geometry and arithmetic are the reference's
// (doc/reference.md §3.3).
#include <cmath>

#include "pipeline/geometry/assemble/stages.h"
#include "pipeline/geometry/program/snap.h"
#include "simd/trigonometry.h"

namespace terrazzo::pipeline {

namespace {

TriangleSetup smooth_setup(const DrawState& state, const raster::FragmentState& fragment, Side side) {
    TriangleSetup setup = triangle_setup(state);
    setup.state = &fragment;
    setup.cull_front = setup.cull_back = false;
    setup.two_sided = false;
    setup.side = side;
    setup.offset = false;
    return setup;
}

}  // namespace

SmoothShapes::SmoothShapes(PrimitiveSetup& setup, ShadedVertices& vertices, const DrawState& state,
                           int columns)
    : m_setup(setup),
      m_vertices(vertices),
      m_state(state),
      m_columns(columns),
      m_line{smooth_setup(state, state.fragment->line, Side::kFront),
             smooth_setup(state, state.fragment->line, Side::kBack)},
      m_point{smooth_setup(state, state.fragment->point, Side::kFront),
              smooth_setup(state, state.fragment->point, Side::kBack)} {}

int SmoothShapes::corner(int slot, int from, float dx, float dy, const float (&coverage)[4]) {
    for (int column = 0; column < m_columns; ++column) {
        float* const values = m_vertices.column(column);
        values[slot] = values[from];
    }
    const auto move = [&](Column window, Column snapped, float by) {
        float& position = m_vertices.column(window)[slot];
        position += by;
        m_vertices.integers(snapped)[slot] = snap_even(position, m_state.vertex.snap_origin);
    };
    move(kWindowX, kSnappedX, dx);
    move(kWindowY, kSnappedY, dy);
    // Where two-sided lighting has its back colours, which are done with by now.
    const int first = kFirstVarying + m_state.vertex.varyings.count;
    for (int i = 0; i < 4; ++i) m_vertices.column(first + i)[slot] = coverage[i];
    return slot;
}

int SmoothShapes::take_slots() {
    const int first = kFirstSlot + m_next_slot;
    m_next_slot = (m_next_slot + 4) % kSlots;
    return first;
}

void SmoothShapes::line(int a, int b) {
    const float dx = m_vertices.column(kWindowX)[b] - m_vertices.column(kWindowX)[a];
    const float dy = m_vertices.column(kWindowY)[b] - m_vertices.column(kWindowY)[a];
    if (!is_window_coordinate(dx) || !is_window_coordinate(dy)) return;
    const float angle = simd::arc_tangent(dy, dx);
    const float c = simd::cosine(angle), s = simd::sine(angle);
    const float width = m_state.raster.line_width;
    const float half_width = width <= 1 ? 1.0f : 0.5f * width + 0.5f;
    float half_length = 0.5f * std::sqrt(dx * dx + dy * dy);
    // A line shorter than a pixel fades with its length.
    half_length = half_length < 0.5f ? 2.0f * half_length : half_length + 0.5f;

    const int slot = take_slots();
    const int v[4] = {
        corner(slot, a, -0.5f * c - half_width * s, -0.5f * s + half_width * c,
               {-half_width, half_width, -half_length, half_length}),
        corner(slot + 1, a, -0.5f * c + half_width * s, -0.5f * s - half_width * c,
               {half_width, half_width, -half_length, half_length}),
        corner(slot + 2, b, 0.5f * c - half_width * s, 0.5f * s + half_width * c,
               {-half_width, half_width, half_length, half_length}),
        corner(slot + 3, b, 0.5f * c + half_width * s, 0.5f * s - half_width * c,
               {half_width, half_width, half_length, half_length}),
    };
    const TriangleSetup& rules = m_line[m_setup.back_facing()];
    m_setup.triangle(rules, v[2], v[1], v[0]);
    m_setup.triangle(rules, v[3], v[1], v[2]);
}

void SmoothShapes::point(int v) {
    const float size =
        m_state.vertex.point_attenuated ? m_vertices.column(kPointSizeColumn)[v] : m_state.raster.point_size;
    const float radius = size <= 2 ? 1.0f : 0.5f * size;
    // Squared distance from the centre, in radii, where the rim begins: it is a pixel wide.
    const float reciprocal = 1.0f / radius;
    const float rim = 1.0f - 2.0f * reciprocal + reciprocal * reciprocal;
    const int slot = take_slots();
    const int corners[4] = {
        corner(slot, v, -radius, -radius, {-1, -1, rim, 1}),
        corner(slot + 1, v, radius, -radius, {1, -1, rim, 1}),
        corner(slot + 2, v, radius, radius, {1, 1, rim, 1}),
        corner(slot + 3, v, -radius, radius, {-1, 1, rim, 1}),
    };
    const TriangleSetup& rules = m_point[m_setup.back_facing()];
    m_setup.triangle(rules, corners[0], corners[1], corners[2]);
    m_setup.triangle(rules, corners[0], corners[2], corners[3]);
}

}  // namespace terrazzo::pipeline
