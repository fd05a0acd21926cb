// Set-up of points (GL 1.5 §3.3.1): a square of whole pixels with constant planes, or a sprite
// (ARB_point_sprite): a square of any size, across which texture coordinates may run from 0 to 1. With
// multisampling (§3.3.3) all are squares of any size, whose samples are covered or not. They are placed as
// the reference does it (doc/reference.md §3, "Points").
#include <algorithm>

#include "pipeline/geometry/program/snap.h"
#include "pipeline/geometry/setup/primitive_setup.h"

namespace terrazzo::pipeline {

namespace {

// The first of `size` pixels round a sub-pixel position.
int32_t first_pixel(int32_t position, int32_t size) {
    return size & 1 ? (position >> 8) - (size - 1) / 2 : ((position + 128) >> 8) - size / 2;
}

}  // namespace

float PrimitiveSetup::point_size(int v) const {
    return m_state.vertex.point_attenuated ? m_vertices.column(kPointSizeColumn)[v]
                                           : m_state.raster.point_size;
}

void PrimitiveSetup::point(int v) {
    flush();
    if (m_observer) return m_observer->point(m_vertices, v);
    const float window_x = m_vertices.column(kWindowX)[v], window_y = m_vertices.column(kWindowY)[v];
    if (!is_window_coordinate(window_x) || !is_window_coordinate(window_y)) return;
    if (m_state.raster.point_sprite || m_state.fragment->point.multisample) return sprite(v);
    const int32_t size = std::max((snap_away(point_size(v)) + 127) & ~255, 256) >> 8;
    // A position on the line between two rows belongs to the one that is lower in GL's orientation.
    const int32_t y = snap_away(window_y) - (m_state.raster.row0_is_top ? 1 : 0);
    const int32_t x0 = first_pixel(snap_away(window_x), size), y0 = first_pixel(y, size);
    if (raster::Primitive* const p = constant_square(v, {x0, y0, x0 + size, y0 + size}, 0)) m_lists.add(*p);
}

// A rectangle of pixels with the planes of one vertex; null where nothing of it is to be drawn. Edges are
// left to be set.
raster::Primitive* PrimitiveSetup::constant_square(int v, const Box& box, int edge_count) {
    const raster::FragmentState& state = m_state.fragment->point;
    raster::Primitive* const p = new_primitive(state, box, edge_count);
    if (p == nullptr) return nullptr;
    float* const planes = p->planes();
    std::fill_n(planes, 3 * p->plane_count, 0.0f);
    const float oow = m_vertices.column(kWindowOow)[v];
    planes[0] = m_vertices.column(kWindowZ)[v];
    planes[1] = oow;
    for (int i = 0; i < p->plane_count - 2; ++i) {
        const float value = m_vertices.column(kFirstVarying + i)[v];
        planes[2 + i] = m_state.raster.flat && state.varyings.is_color(i) ? value : value * oow;
    }
    return p;
}

void PrimitiveSetup::sprite(int v) {
    const float window_x = m_vertices.column(kWindowX)[v], window_y = m_vertices.column(kWindowY)[v];
    const float origin = m_state.vertex.snap_origin;
    const int32_t size = std::max(snap_away(point_size(v)), 256);
    const int32_t x0 = snap_away(window_x - origin) - size / 2, y0 = snap_away(window_y - origin) - size / 2;
    const bool row0_is_top = m_state.raster.row0_is_top;
    const bool multisample = m_state.fragment->point.multisample;
    raster::Primitive* const p = multisample
                                     ? constant_square(v, touched_pixels(x0, y0, x0 + size, y0 + size), 4)
                                     : constant_square(v, pixels_within(x0, y0, x0 + size, y0 + size), 0);
    if (p == nullptr) return;
    if (multisample) {
        set_edges(*p, {x0, x0 + size, x0 + size, x0}, {y0 + size, y0 + size, y0, y0});
        if (!m_state.raster.point_sprite) return m_lists.add(*p);
    }
    // Coordinates begin at pixels' centres with multisampling too: the reference's way.
    const float x = window_x - 0.5f, y = window_y - 0.5f;
    const raster::Varyings& varyings = p->state->varyings;
    const float oow = m_vertices.column(kWindowOow)[v], slope = 256.0f / static_cast<float>(size);
    float *const a0 = p->planes(), *const dadx = a0 + p->plane_count, *const dady = dadx + p->plane_count;
    for (int unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
        const int first = varyings.texture[static_cast<size_t>(unit)];
        if (first < 0 || !(m_state.raster.sprite_units >> unit & 1)) continue;
        const int s = 2 + first, t = s + 1;
        // t runs downwards in the window.
        const float down = row0_is_top ? slope : -slope;
        a0[s] = static_cast<float>(0.5 - static_cast<double>(slope * x)) * oow;
        dadx[s] = slope * oow;
        a0[t] = static_cast<float>(0.5 - static_cast<double>(down * y)) * oow;
        dady[t] = down * oow;
        if (varyings.uses_r >> unit & 1) a0[t + 1] = 0;
        if (varyings.projective >> unit & 1) a0[t + 2] = oow;
    }
    m_lists.add(*p);
}

}  // namespace terrazzo::pipeline
