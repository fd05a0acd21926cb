// Clipping; see clip.h. Arithmetic is not fused, unlike the vertex program's viewport step.
#include "pipeline/geometry/assemble/clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/geometry/program/snap.h"

namespace terrazzo::pipeline {

namespace {

// In the order of the outcode's bits.
constexpr float kVolume[6][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1},
                                 {0, 1, 0, 1},  {0, 0, 1, 1}, {0, 0, -1, 1}};
constexpr float kNearAtZero[4] = {0, 0, 1, 0};

}  // namespace

float Clipper::distance(int plane, int vertex) const {
    const float* const p = plane >= 6                          ? m_state.clip_planes[plane - 6]
                           : plane == 4 && m_state.zero_to_one ? kNearAtZero
                                                               : kVolume[plane];
    return m_vertices.column(kClipX)[vertex] * p[0] + m_vertices.column(kClipY)[vertex] * p[1] +
           m_vertices.column(kClipZ)[vertex] * p[2] + m_vertices.column(kClipW)[vertex] * p[3];
}

int Clipper::interpolate(float t, int from, int to, int& slot) {
    const int made = slot++;
    const auto lerp = [&](int index) {
        float* const column = m_vertices.column(index);
        column[made] = column[from] + t * (column[to] - column[from]);
        return column[made];
    };
    float clip[3];
    for (int axis = 0; axis < 3; ++axis) clip[axis] = lerp(kClipX + axis);
    const float oow = 1.0f / lerp(kClipW);
    for (int axis = 0; axis < 3; ++axis)
        m_vertices.column(kWindowX + axis)[made] =
            clip[axis] * oow * m_state.viewport_scale[axis] + m_state.viewport_translate[axis];
    m_vertices.column(kWindowOow)[made] = oow;
    m_vertices.integers(kSnappedX)[made] = snap_even(m_vertices.column(kWindowX)[made], m_state.snap_origin);
    m_vertices.integers(kSnappedY)[made] = snap_even(m_vertices.column(kWindowY)[made], m_state.snap_origin);
    m_vertices.integers(kOutcode)[made] = 0;
    if (m_state.point_attenuated) lerp(kPointSizeColumn);
    for (int column = kFirstVarying; column < m_columns; ++column) lerp(column);
    return made;
}

void Clipper::copy_flat(int from, int to) {
    const raster::Varyings& v = m_state.varyings;
    const auto copy = [&](int first, int count) {
        for (int i = 0; first >= 0 && i < count; ++i) {
            for (int column = kFirstVarying + first + i; column < m_columns; column += v.count)
                m_vertices.column(column)[to] = m_vertices.column(column)[from];
        }
    };
    copy(v.color, 4);
    copy(v.secondary, 3);
}

ClippedPolygon Clipper::clip(const int (&triangle)[3], const bool (&edges)[3], int& slot) {
    const int32_t* const outcodes = m_vertices.integers(kOutcode);
    const int32_t planes = outcodes[triangle[0]] | outcodes[triangle[1]] | outcodes[triangle[2]];
    ClippedPolygon polygon;
    polygon.count = 3;
    std::copy_n(triangle, 3, polygon.vertices);
    std::copy_n(edges, 3, polygon.edges);

    for (int plane = 0; plane < 6 + kMaxClipPlanes && polygon.count >= 3; ++plane) {
        if (!(planes >> plane & 1)) continue;
        ClippedPolygon kept;
        int previous = polygon.vertices[0];
        float previous_distance = distance(plane, previous);
        if (!std::isfinite(previous_distance)) return {};
        for (int i = 1; i <= polygon.count; ++i) {
            const int current = polygon.vertices[i % polygon.count];
            const float current_distance = distance(plane, current);
            if (!std::isfinite(current_distance)) return {};
            const bool edge = polygon.edges[i - 1];
            bool crossing;
            if (previous_distance >= 0) {
                kept.vertices[kept.count] = previous;
                kept.edges[kept.count++] = edge;
                crossing = current_distance < 0;
            } else {
                crossing = !(current_distance < 0);
            }
            if (crossing) {
                const float denominator = current_distance - previous_distance;
                const bool leaving = current_distance < 0;
                const bool from_current = leaving ? -current_distance < previous_distance
                                                  : !(-previous_distance < current_distance);
                kept.vertices[kept.count] =
                    from_current ? interpolate(current_distance / denominator, current, previous, slot)
                                 : interpolate(-previous_distance / denominator, previous, current, slot);
                // Leaving, the next edge runs along the plane; only a user's plane makes it part of the
                // outline.
                kept.edges[kept.count++] = leaving ? plane >= 6 : edge;
            }
            previous = current;
            previous_distance = current_distance;
        }
        polygon = kept;
    }
    if (polygon.count < 3) return {};
    if (m_flat && polygon.vertices[0] != triangle[2]) {
        const int copy = interpolate(0.0f, polygon.vertices[0], polygon.vertices[0], slot);
        for (int column = 0; column < m_columns; ++column)
            m_vertices.column(column)[copy] = m_vertices.column(column)[polygon.vertices[0]];
        copy_flat(triangle[2], copy);
        polygon.vertices[0] = copy;
    }
    return polygon;
}

bool Clipper::clip_line(int& a, int& b, int& slot) {
    const int32_t* const outcodes = m_vertices.integers(kOutcode);
    const int32_t planes = outcodes[a] | outcodes[b];
    if (outcodes[a] & outcodes[b]) return false;
    if (planes == 0) return true;
    float t0 = 0, t1 = 0;
    for (int plane = 0; plane < 6 + kMaxClipPlanes; ++plane) {
        if (!(planes >> plane & 1)) continue;
        const float d0 = distance(plane, a), d1 = distance(plane, b);
        if (!std::isfinite(d0) || !std::isfinite(d1)) return false;
        if (d1 < 0) t1 = std::max(t1, d1 / (d1 - d0));
        if (d0 < 0) t0 = std::max(t0, d0 / (d0 - d1));
        if (t0 + t1 >= 1) return false;
    }
    const int from = a, to = b;
    if (t0 > 0) a = interpolate(t0, from, to, slot);
    if (t1 > 0) b = interpolate(t1, to, from, slot);
    if (m_flat && b != to) copy_flat(to, b);
    if (m_flat && a != from) copy_flat(to, a);
    return true;
}

}  // namespace terrazzo::pipeline
