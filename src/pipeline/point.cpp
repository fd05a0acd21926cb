// Set-up of points (GL 1.5 §3.3.1): a square of whole pixels with constant planes, placed as the reference
// does it (doc/reference.md §3, "Points").
#include <algorithm>

#include "pipeline/primitive_setup.h"
#include "pipeline/snap.h"

namespace terrazzo::pipeline {

namespace {

// The first of `size` pixels round a sub-pixel position.
int32_t first_pixel(int32_t position, int32_t size) {
    return size & 1 ? (position >> 8) - (size - 1) / 2 : ((position + 128) >> 8) - size / 2;
}

}  // namespace

void PrimitiveSetup::point(int v) {
    flush();
    if (m_observer) return m_observer->point(m_vertices, v);
    const float window_x = m_vertices.column(kWindowX)[v], window_y = m_vertices.column(kWindowY)[v];
    if (!is_window_coordinate(window_x) || !is_window_coordinate(window_y)) return;
    const float wanted =
        m_state.vertex.point_attenuated ? m_vertices.column(kPointSizeColumn)[v] : m_state.raster.point_size;
    const int32_t size = std::max((snap_away(wanted) + 127) & ~255, 256) >> 8;
    // A position on the line between two rows belongs to the one that is lower in GL's orientation.
    const int32_t y = snap_away(window_y) - (m_state.raster.row0_is_top ? 1 : 0);
    const int32_t x0 = first_pixel(snap_away(window_x), size), y0 = first_pixel(y, size);
    const raster::FragmentState& state = m_state.fragment->point;
    raster::Primitive* const p = new_primitive(state, {x0, y0, x0 + size, y0 + size}, 0);
    if (p == nullptr) return;

    float* const planes = p->planes();
    std::fill_n(planes, 3 * p->plane_count, 0.0f);
    const float oow = m_vertices.column(kWindowOow)[v];
    planes[0] = m_vertices.column(kWindowZ)[v];
    planes[1] = oow;
    for (int i = 0; i < p->plane_count - 2; ++i) {
        const float value = m_vertices.column(kFirstVarying + i)[v];
        planes[2 + i] = m_state.raster.flat && state.varyings.is_color(i) ? value : value * oow;
    }
    m_frame.add(*p);
}

}  // namespace terrazzo::pipeline
