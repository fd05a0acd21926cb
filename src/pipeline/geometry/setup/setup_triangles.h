// Triangle set-up, 16 triangles at a time: orientation and culling, bounding boxes, planes and edges.
//
// Planes are the reference's operation for operation, from the unsnapped window positions; orientation and
// edges are exact integers of the snapped ones (doc/reference.md §3).
#pragma once

#include <algorithm>
#include <bit>

#include "pipeline/geometry/geometry_table.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace pipeline;
using raster::Edge;
using raster::Primitive;

// The values of one column at the three vertices.
struct Corners {
    F32x16 v0, v1, v2;
};
struct CornerIndices {
    I32x16 v0, v1, v2;
};

TERRAZZO_INLINE Corners corners(const float* column, const CornerIndices& i) {
    return {gather(column, i.v0), gather(column, i.v1), gather(column, i.v2)};
}

struct PlaneBasis {
    F32x16 dx01, dy01, dx20, dy20;  // divided by twice the signed area
    F32x16 cx, cy;                  // vertex 0 relative to the first pixel's centre, or its corner
};

struct PlaneArrays {
    // a0, d/dx and d/dy of each plane, a lane a triangle.
    alignas(64) float values[3][raster::kMaxPlanes][16];
};

// Bounds the error of a plane that is evaluated without fused steps, relative to the least 1/w of its
// triangle.
struct ErrorBound {
    F32x16 x, y;     // no pixel of the triangle lies beyond
    F32x16 largest;  // the largest sum of a plane's terms so far
};

// The error of a sum is below 2^-23 of its terms' sizes: beyond this, more than an eighth of 1/255.
inline constexpr float kVisibleTerms = 4096;

TERRAZZO_INLINE void store_plane(const PlaneBasis& basis, const Corners& a, int plane, PlaneArrays& out) {
    const F32x16 da01 = a.v0 - a.v1, da20 = a.v2 - a.v0;
    const F32x16 dadx = da01 * basis.dy20 - da20 * basis.dy01;
    const F32x16 dady = da20 * basis.dx01 - da01 * basis.dx20;
    store(a.v0 - (dadx * basis.cx + dady * basis.cy), out.values[0][plane]);
    store(dadx, out.values[1][plane]);
    store(dady, out.values[2][plane]);
}

TERRAZZO_INLINE void store_constant_plane(F32x16 value, int plane, PlaneArrays& out) {
    store(value, out.values[0][plane]);
    store(F32x16(0.0f), out.values[1][plane]);
    store(F32x16(0.0f), out.values[2][plane]);
}

TERRAZZO_INLINE void bound_error(const PlaneArrays& planes, int plane, float weight, ErrorBound& bound) {
    const auto size = [&](int part) { return abs(load(planes.values[part][plane])); };
    const F32x16 terms = size(0) + size(1) * bound.x + size(2) * bound.y;
    bound.largest = max(bound.largest, terms * F32x16(weight));
}

inline void store_varyings(const TriangleSetup& setup, const ShadedVertices& vertices,
                           const CornerIndices& index, const Corners& oow, const PlaneBasis& basis,
                           Mask16 back_facing, PlaneArrays& planes, ErrorBound& bound) {
    const raster::Varyings& v = setup.state->varyings;
    const bool perspective = setup.state->key.perspective;
    for (int i = 0; i < v.count; ++i) {
        const bool color = v.is_color(i);
        Corners a = corners(vertices.column(kFirstVarying + i), index);
        if (color && setup.two_sided) {
            const Corners b = corners(vertices.column(kFirstVarying + v.count + i), index);
            a = {select(back_facing, b.v0, a.v0), select(back_facing, b.v1, a.v1),
                 select(back_facing, b.v2, a.v2)};
        }
        if (color && setup.flat) {
            store_constant_plane(a.v2, 2 + i, planes);
            continue;
        }
        if (perspective) a = {a.v0 * oow.v0, a.v1 * oow.v1, a.v2 * oow.v2};
        store_plane(basis, a, 2 + i, planes);
        bound_error(planes, 2 + i, setup.state->error_weights[static_cast<size_t>(i)], bound);
    }
}

// Window-space slope of depth for polygon offset (GL 1.5 §3.5.5): m * factor + r * units. The sides are not
// yet divided by the area.
TERRAZZO_INLINE F32x16 depth_offset(const TriangleSetup& setup, const PlaneBasis& sides, F32x16 ooa,
                                    const Corners& z) {
    const F32x16 dz01 = z.v0 - z.v1, dz20 = z.v2 - z.v0;
    const F32x16 slope_x = abs((dz20 * sides.dy01 - sides.dy20 * dz01) * ooa);
    const F32x16 slope_y = abs((sides.dx20 * dz01 - dz20 * sides.dx01) * ooa);
    return max(slope_x, slope_y) * F32x16(setup.offset_factor) + F32x16(setup.offset_units);
}

struct SnappedTriangles {
    alignas(64) int32_t x[3][16], y[3][16];
    alignas(64) int32_t x0[16], y0[16], x1[16], y1[16];
    alignas(64) float offset[16];
};

// What is known of one triangle beyond its numbers.
struct LaneFacts {
    bool back_facing, steep, is_cut;
};

TERRAZZO_INLINE void write_primitive(const TriangleSetup& setup, const SnappedTriangles& t,
                                     const PlaneArrays& planes, int lane, LaneFacts facts,
                                     PrimitiveSink& sink) {
    const int plane_count = 2 + setup.state->varyings.count;
    Primitive* const primitive = sink.allocate(sink, plane_count);
    if (primitive == nullptr) return;
    primitive->state = setup.state;
    primitive->x0 = static_cast<int16_t>(t.x0[lane]);
    primitive->y0 = static_cast<int16_t>(t.y0[lane]);
    primitive->x1 = static_cast<int16_t>(t.x1[lane]);
    primitive->y1 = static_cast<int16_t>(t.y1[lane]);
    primitive->edge_count = 3;
    primitive->plane_count = static_cast<uint8_t>(plane_count);
    primitive->back_facing = facts.back_facing;
    primitive->steep = facts.steep;
    primitive->is_cut = facts.is_cut;
    primitive->data = raster::RectangleData::kNone;
    primitive->depth_offset = t.offset[lane];
    for (int e = 0; e < 3; ++e) {
        const int next = e == 2 ? 0 : e + 1;
        primitive->edges[e] = Edge::between(t.x[e][lane], t.y[e][lane], t.x[next][lane], t.y[next][lane],
                                            setup.row0_is_top, setup.multisample);
    }
    float* out = primitive->planes();
    for (int part = 0; part < 3; ++part)
        for (int plane = 0; plane < plane_count; ++plane) *out++ = planes.values[part][plane][lane];
    sink.commit(sink, *primitive);
}

// The triangles that are culled for their facing before snapping, where a sliver may face the other way;
// those of no area are back sides. Chunks with a clipped vertex undergo this in the reference
// (doc/reference.md §3.2).
inline uint32_t culled_unsnapped(const TriangleSetup& setup, const ShadedVertices& vertices,
                                 const CornerIndices& index) {
    const Corners x = corners(vertices.column(kWindowX), index),
                  y = corners(vertices.column(kWindowY), index);
    const F32x16 determinant = (x.v0 - x.v2) * (y.v1 - y.v2) - (y.v0 - y.v2) * (x.v1 - x.v2);
    const F32x16 zero(0.0f);
    const uint32_t counter_clockwise = bits_of(setup.row0_is_top ? determinant < zero : determinant > zero);
    const uint32_t back =
        (setup.front_is_clockwise ? counter_clockwise : ~counter_clockwise) | bits_of(determinant == zero);
    return (setup.cull_front ? ~back : 0) | (setup.cull_back ? back : 0);
}

inline void setup_triangles(const TriangleSetup& setup, const ShadedVertices& vertices,
                            const TriangleBatch& batch, PrimitiveSink& sink) {
    CornerIndices index{load(batch.v0), load(batch.v1), load(batch.v2)};
    const int32_t* const snapped_x = vertices.integers(kSnappedX);
    const int32_t* const snapped_y = vertices.integers(kSnappedY);
    I32x16 x0 = gather(snapped_x, index.v0), x1 = gather(snapped_x, index.v1);
    I32x16 y0 = gather(snapped_y, index.v0), y1 = gather(snapped_y, index.v1);
    const I32x16 x2 = gather(snapped_x, index.v2), y2 = gather(snapped_y, index.v2);

    // Positive: counter-clockwise in GL's upward y where rows count downwards, clockwise where they count
    // upwards.
    const F32x16 area = cross(x0 - x1, y2 - y0, x2 - x0, y0 - y1);
    const Mask16 positive = area > F32x16(0.0f), negative = area < F32x16(0.0f);
    const Mask16 counter_clockwise = setup.row0_is_top ? positive : negative;
    const Mask16 back = setup.front_is_clockwise ? counter_clockwise : ~counter_clockwise;
    uint32_t alive = bits_of(positive | negative) & ((1u << batch.count) - 1);
    if (setup.cull_front) alive &= bits_of(back);
    if (setup.cull_back) alive &= ~bits_of(back);
    if (setup.cull_unsnapped && (setup.cull_front || setup.cull_back))
        alive &= ~culled_unsnapped(setup, vertices, index);
    if (alive == 0) return;

    // From here on every triangle is positive: a negative one has its first two vertices exchanged.
    const auto exchange = [&](I32x16& a, I32x16& b) {
        const I32x16 old = a;
        a = select(negative, b, a);
        b = select(negative, old, b);
    };
    exchange(index.v0, index.v1);
    exchange(x0, x1);
    exchange(y0, y1);

    SnappedTriangles t;
    store(x0, t.x[0]), store(x1, t.x[1]), store(x2, t.x[2]);
    store(y0, t.y[0]), store(y1, t.y[1]), store(y2, t.y[2]);
    const auto low = [](I32x16 a, I32x16 b, I32x16 c) { return min(min(a, b), c); };
    const auto high = [](I32x16 a, I32x16 b, I32x16 c) { return max(max(a, b), c); };
    // A pixel centre on the box's inclusive edge counts: left, and lower in GL's orientation.
    const I32x16 up(setup.row0_is_top ? 1 : 0), down(setup.row0_is_top ? 0 : 1);
    const I32x16 whole_x0 = shift_right<8>(low(x0, x1, x2)), whole_y0 = shift_right<8>(low(y0, y1, y2) + up);
    const I32x16 whole_x1 = shift_right<8>(high(x0, x1, x2) - I32x16(1)) + I32x16(1),
                 whole_y1 = shift_right<8>(high(y0, y1, y2) - down) + I32x16(1);
    const I32x16 box_x0 = max(whole_x0, I32x16(setup.x0)), box_y0 = max(whole_y0, I32x16(setup.y0));
    const I32x16 box_x1 = min(whole_x1, I32x16(setup.x1)), box_y1 = min(whole_y1, I32x16(setup.y1));
    const uint32_t cut_bits =
        ~bits_of((box_x0 == whole_x0) & (box_y0 == whole_y0) & (box_x1 == whole_x1) & (box_y1 == whole_y1));
    alive &= bits_of((box_x0 < box_x1) & (box_y0 < box_y1));
    if (alive == 0) return;
    store(box_x0, t.x0), store(box_y0, t.y0), store(box_x1, t.x1), store(box_y1, t.y1);

    const Corners x = corners(vertices.column(kWindowX), index),
                  y = corners(vertices.column(kWindowY), index);
    const F32x16 origin(setup.multisample ? 0.0f : 0.5f);
    PlaneBasis basis{x.v0 - x.v1, y.v0 - y.v1, x.v2 - x.v0, y.v2 - y.v0, x.v0 - origin, y.v0 - origin};
    const F32x16 ooa = F32x16(1.0f) / (basis.dx01 * basis.dy20 - basis.dy01 * basis.dx20);
    const Corners z = corners(vertices.column(kWindowZ), index);
    store(setup.offset ? depth_offset(setup, basis, ooa, z) : F32x16(0.0f), t.offset);
    basis.dx01 = basis.dx01 * ooa, basis.dy01 = basis.dy01 * ooa;
    basis.dx20 = basis.dx20 * ooa, basis.dy20 = basis.dy20 * ooa;

    PlaneArrays planes;
    store_plane(basis, z, 0, planes);
    const Corners oow = corners(vertices.column(kWindowOow), index);
    store_plane(basis, oow, 1, planes);
    ErrorBound bound{to_float(box_x1), to_float(box_y1), F32x16(0.0f)};
    bound_error(planes, 1, 1.0f, bound);
    store_varyings(setup, vertices, index, oow, basis, back, planes, bound);
    const F32x16 least_oow = min(min(oow.v0, oow.v1), oow.v2);
    const uint32_t steep_bits = bits_of(bound.largest > least_oow * F32x16(kVisibleTerms));

    const uint32_t back_bits = setup.side == Side::kOwn    ? bits_of(back)
                               : setup.side == Side::kBack ? 0xffff
                                                           : 0;
    while (alive != 0) {
        const int lane = std::countr_zero(alive);
        alive &= alive - 1;
        const LaneFacts facts{(back_bits >> lane & 1) != 0, (steep_bits >> lane & 1) != 0,
                              (cut_bits >> lane & 1) != 0};
        write_primitive(setup, t, planes, lane, facts, sink);
    }
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
