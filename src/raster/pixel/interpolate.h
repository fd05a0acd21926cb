// Interpolation: a primitive's planes at the 16 pixels of a tile.
//
// Depth is what the reference computes with two fused multiply-adds, fma(dz/dy, y, fma(dz/dx, x, a0)), got without
// them: the products of a float and a pixel number are exact in double, so a column's inner sum is rounded to float once
// and a pixel is one double addition and one rounding. Other varyings need no such care: they use plain
// multiplications and additions relative to pixel coordinates.
#pragma once

#include "raster/primitive.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
// Four doubles, one a column, in as many native vectors as it takes.
inline constexpr int kNativeDoubles = HWY_LANES(double) < 4 ? HWY_LANES(double) : 4;
using TagD = hn::CappedTag<double, kNativeDoubles>;
using TagDToF = hn::Rebind<float, TagD>;
using Row = hn::Vec<hn::FixedTag<float, 4>>;

// float(columns[i] + row) for the four columns.
template <int kVectors>
TERRAZZO_INLINE Row tile_row(const hn::Vec<TagD> (&columns)[kVectors], double row) {
    const hn::Vec<TagD> r = hn::Set(TagD(), row);
    const auto low = hn::DemoteTo(TagDToF(), hn::Add(columns[0], r));
    if constexpr (kVectors == 1) {
        return low;
    } else {
        return hn::Combine(hn::FixedTag<float, 4>(), hn::DemoteTo(TagDToF(), hn::Add(columns[1], r)), low);
    }
}

TERRAZZO_INLINE F32x16 from_rows(Row row0, Row row1, Row row2, Row row3) {
    F32x16 z;
#if HWY_MAX_BYTES >= 64
    using Tag8 = hn::FixedTag<float, 8>;
    z.part[0] = hn::Combine(TagF(), hn::Combine(Tag8(), row3, row2), hn::Combine(Tag8(), row1, row0));
#elif HWY_MAX_BYTES >= 32
    z.part[0] = hn::Combine(TagF(), row1, row0);
    z.part[1] = hn::Combine(TagF(), row3, row2);
#else
    z.part[0] = row0, z.part[1] = row1, z.part[2] = row2, z.part[3] = row3;
#endif
    return z;
}
#endif

// z at the pixels of the tile whose first pixel is (x, y), before clamping.
TERRAZZO_INLINE F32x16 interpolate_depth(float a0, float dadx, float dady, int x, int y) {
    const double slope_x = dadx, slope_y = dady;
#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
    hn::Vec<TagD> columns[4 / kNativeDoubles];
    for (int i = 0; i < 4 / kNativeDoubles; ++i) {
        const auto numbers = hn::Iota(TagD(), static_cast<double>(x + i * kNativeDoubles));
        const auto exact = hn::Add(hn::Mul(numbers, hn::Set(TagD(), slope_x)), hn::Set(TagD(), static_cast<double>(a0)));
        columns[i] = hn::PromoteTo(TagD(), hn::DemoteTo(TagDToF(), exact));
    }
    return from_rows(tile_row(columns, slope_y * y), tile_row(columns, slope_y * (y + 1)),
                     tile_row(columns, slope_y * (y + 2)), tile_row(columns, slope_y * (y + 3)));
#else
    alignas(64) float z[16];
    for (int i = 0; i < 4; ++i) {
        const float column = static_cast<float>(slope_x * (x + i) + static_cast<double>(a0));
        for (int j = 0; j < 4; ++j) z[4 * j + i] = static_cast<float>(slope_y * (y + j) + static_cast<double>(column));
    }
    return load(z);
#endif
}

// The varyings of one primitive, evaluated a tile at a time.
class Interpolator {
  public:
    TERRAZZO_INLINE explicit Interpolator(const Primitive& primitive)
        : m_a0(primitive.a0()), m_dadx(primitive.dadx()), m_dady(primitive.dady()) {}

    TERRAZZO_INLINE void move_to(int x, int y) {
        m_tile_x = x;
        m_tile_y = y;
        m_x = to_float(lane_x() + I32x16(x));
        m_y = to_float(lane_y() + I32x16(y));
    }
    TERRAZZO_INLINE F32x16 plane(int index) const {
        return F32x16(m_a0[index]) + F32x16(m_dadx[index]) * m_x + F32x16(m_dady[index]) * m_y;
    }
    TERRAZZO_INLINE F32x16 depth() const { return interpolate_depth(m_a0[0], m_dadx[0], m_dady[0], m_tile_x, m_tile_y); }
    // What perspective varyings are to be multiplied by.
    TERRAZZO_INLINE F32x16 w() const { return F32x16(1.0f) / plane(1); }
    // A varying's plane; they follow z and 1/w.
    TERRAZZO_INLINE F32x16 varying(int index) const { return plane(2 + index); }

  private:
    const float *m_a0, *m_dadx, *m_dady;
    int m_tile_x = 0, m_tile_y = 0;
    F32x16 m_x, m_y;
};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
