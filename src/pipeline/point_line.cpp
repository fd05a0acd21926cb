// Points and lines (GL 1.5 §3.3, §3.4) as primitives: a point is a rectangle of pixels, a line a
// parallelogram of four edges; and polygons drawn as either (§3.5.4).
#include <algorithm>
#include <cmath>
#include <new>

#include "pipeline/assemble.h"

namespace terrazzo::pipeline {

namespace {

int32_t snap(float v) {
    return static_cast<int32_t>(std::lrintf(std::clamp(v * 256.0f, -8388608.0f, 8388608.0f)));
}

}  // namespace

raster::Primitive& PrimitiveAssembler::new_primitive(int edge_count, bool back_facing) {
    const int plane_count = 2 + m_setup.state->varyings.count;
    raster::Primitive& p =
        *new (m_frame.arena().allocate(raster::Primitive::size_of(plane_count))) raster::Primitive;
    p.state = m_setup.state;
    p.edge_count = static_cast<uint8_t>(edge_count);
    p.plane_count = static_cast<uint8_t>(plane_count);
    p.back_facing = back_facing;
    p.depth_offset = 0;
    return p;
}

void PrimitiveAssembler::point(int v) {
    if (m_vertices.integers(kOutcode)[v] == 0) set_up_point(v);
}

void PrimitiveAssembler::set_up_point(int v) {
    const int32_t size = std::max((snap(m_state.raster.point_size) + 127) & ~255, 256) >> 8;
    const int32_t x = m_vertices.integers(kSnappedX)[v], y = m_vertices.integers(kSnappedY)[v];
    const auto start = [&](int32_t center) {
        return size & 1 ? ((center + 128) >> 8) - (size - 1) / 2 : ((center + 255) >> 8) - size / 2;
    };
    const int32_t x0 = start(x), y0 = start(y);
    raster::Primitive& p = new_primitive(0, false);
    p.x0 = static_cast<int16_t>(std::max(x0, m_setup.x0));
    p.y0 = static_cast<int16_t>(std::max(y0, m_setup.y0));
    p.x1 = static_cast<int16_t>(std::min(x0 + size, m_setup.x1));
    p.y1 = static_cast<int16_t>(std::min(y0 + size, m_setup.y1));
    if (p.x0 >= p.x1 || p.y0 >= p.y1) return;
    float* const a0 = p.planes();
    std::fill_n(a0, 3 * p.plane_count, 0.0f);
    const float oow = m_vertices.column(kWindowOow)[v];
    a0[0] = m_vertices.column(kWindowZ)[v];
    a0[1] = oow;
    for (int i = 0; i < p.plane_count - 2; ++i) a0[2 + i] = m_vertices.column(kFirstVarying + i)[v] * oow;
    m_frame.add(p);
}

void PrimitiveAssembler::line(int a, int b, bool) {
    make_room(kMaxClipSlots);
    if (m_clipper.clip_line(a, b, m_next_slot)) set_up_line(a, b);
}

void PrimitiveAssembler::set_up_line(int a, int b) {
    const float x[2] = {m_vertices.column(kWindowX)[a], m_vertices.column(kWindowX)[b]};
    const float y[2] = {m_vertices.column(kWindowY)[a], m_vertices.column(kWindowY)[b]};
    const float dx = x[1] - x[0], dy = y[1] - y[0];
    const float length2 = dx * dx + dy * dy;
    if (!(length2 > 0)) return;
    const float half = std::max(1.0f, std::rint(m_state.raster.line_width)) * 0.5f;
    const bool x_major = std::fabs(dx) >= std::fabs(dy);
    const float ox = x_major ? 0 : half, oy = x_major ? half : 0;
    float cx[4] = {x[0] - ox, x[1] - ox, x[1] + ox, x[0] + ox},
          cy[4] = {y[0] - oy, y[1] - oy, y[1] + oy, y[0] + oy};
    const bool reversed = x_major ? dx < 0 : dy > 0;
    if (reversed) std::swap(cx[1], cx[3]), std::swap(cy[1], cy[3]);
    int32_t px[4], py[4];
    for (int i = 0; i < 4; ++i) px[i] = snap(cx[i] - 0.5f), py[i] = snap(cy[i] - 0.5f);
    raster::Primitive& p = new_primitive(4, false);
    const auto [low_x, high_x] = std::minmax_element(px, px + 4);
    const auto [low_y, high_y] = std::minmax_element(py, py + 4);
    p.x0 = static_cast<int16_t>(std::max(*low_x >> 8, m_setup.x0));
    p.y0 = static_cast<int16_t>(std::max(*low_y >> 8, m_setup.y0));
    p.x1 = static_cast<int16_t>(std::min((*high_x >> 8) + 1, m_setup.x1));
    p.y1 = static_cast<int16_t>(std::min((*high_y >> 8) + 1, m_setup.y1));
    if (p.x0 >= p.x1 || p.y0 >= p.y1) return;
    for (int e = 0; e < 4; ++e) {
        const int n = (e + 1) & 3;
        const int32_t dcdx = py[e] - py[n], dcdy = px[e] - px[n];
        int64_t c = int64_t{dcdx} * px[e] - int64_t{dcdy} * py[e];
        if (dcdx < 0 || (dcdx == 0 && (m_setup.row0_is_top ? dcdy < 0 : dcdy > 0))) ++c;
        p.edges[e] = {(c - 1) >> 8, -dcdx, dcdy};
    }
    float* const a0 = p.planes();
    float *const dadx = a0 + p.plane_count, *const dady = dadx + p.plane_count;
    const auto plane = [&](int index, float va, float vb) {
        dadx[index] = (vb - va) * (dx / length2);
        dady[index] = (vb - va) * (dy / length2);
        a0[index] = va - (dadx[index] * (x[0] - 0.5f) + dady[index] * (y[0] - 0.5f));
    };
    const float wa = m_vertices.column(kWindowOow)[a], wb = m_vertices.column(kWindowOow)[b];
    plane(0, m_vertices.column(kWindowZ)[a], m_vertices.column(kWindowZ)[b]);
    plane(1, wa, wb);
    for (int i = 0; i < p.plane_count - 2; ++i)
        plane(2 + i, m_vertices.column(kFirstVarying + i)[a] * wa,
              m_vertices.column(kFirstVarying + i)[b] * wb);
    m_frame.add(p);
}

void PrimitiveAssembler::unfilled_triangle(const int (&v)[3], const bool (&edges)[3]) {
    const float* const x = m_vertices.column(kWindowX);
    const float* const y = m_vertices.column(kWindowY);
    const float area = (x[v[0]] - x[v[1]]) * (y[v[2]] - y[v[0]]) - (x[v[2]] - x[v[0]]) * (y[v[0]] - y[v[1]]);
    const bool counter_clockwise = m_setup.row0_is_top ? area > 0 : area < 0;
    const bool back = counter_clockwise == m_setup.front_is_clockwise;
    if (back ? m_setup.cull_back : m_setup.cull_front) return;
    switch (m_state.raster.fill[back ? 1 : 0]) {
        case FillMode::kFill: {
            const int i = m_batch.count++;
            m_batch.v0[i] = v[0], m_batch.v1[i] = v[1], m_batch.v2[i] = v[2];
            if (m_batch.count == 16) flush_triangles();
            return;
        }
        case FillMode::kLine:
            flush_triangles();
            for (int e = 0; e < 3; ++e)
                if (edges[e]) set_up_line(v[e], v[(e + 1) % 3]);
            return;
        case FillMode::kPoint:
            flush_triangles();
            for (int e = 0; e < 3; ++e)
                if (edges[e]) set_up_point(v[e]);
            return;
    }
}

}  // namespace terrazzo::pipeline
