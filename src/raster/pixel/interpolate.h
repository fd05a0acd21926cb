// Interpolation: a primitive's planes at the 16 pixels of a tile.
//
// Depth is what the reference computes with two fused multiply-adds, fma(dz/dy, y, fma(dz/dx, x, a0)), got
// without them: the products of a float and a pixel number are exact in double, so a column's inner sum is
// rounded to float once and a pixel is one double addition and one rounding. Other varyings use plain
// multiplications and additions, whose error set-up has found too small to be seen; where it has not
// (slivers, Primitive::steep) they are as exact as depth.
#pragma once

#include "raster/primitive.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// One plane at the 16 pixels of a tile, with the reference's roundings.
class ExactPlane {
  public:
    TERRAZZO_INLINE ExactPlane(float a0, float dadx, float dady)
        : m_a0(a0), m_slope_x(dadx), m_slope_y(dady) {}

    // The tile's first pixel is (x, y).
    TERRAZZO_INLINE F32x16 at(int x, int y) const {
        alignas(64) static constexpr double kX[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
        alignas(64) static constexpr double kY[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
#if HWY_TARGET != HWY_SCALAR && HWY_HAVE_FLOAT64
        // Vectors of doubles, as wide as the floats': two cover what one of floats does.
        using TagD = hn::Repartition<double, TagF>;
        using TagHalf = hn::Half<TagF>;
        constexpr int kDoubles = kNativeLanes / 2;
        constexpr int kColumnVectors = kDoubles < 4 ? 4 / kDoubles : 1;
        const auto slope_x = hn::Set(TagD(), m_slope_x), slope_y = hn::Set(TagD(), m_slope_y);
        const auto first_x = hn::Set(TagD(), static_cast<double>(x)),
                   first_y = hn::Set(TagD(), static_cast<double>(y));
        hn::Vec<TagD> columns[kColumnVectors];
        for (int i = 0; i < kColumnVectors; ++i) {
            const auto exact = hn::Mul(hn::Add(hn::Load(TagD(), kX + i * kDoubles), first_x), slope_x);
            columns[i] =
                hn::PromoteTo(TagD(), hn::DemoteTo(TagHalf(), hn::Add(exact, hn::Set(TagD(), m_a0))));
        }
        const auto part = [&](int i) {
            const auto exact = hn::Mul(hn::Add(hn::Load(TagD(), kY + i * kDoubles), first_y), slope_y);
            return hn::DemoteTo(TagHalf(), hn::Add(exact, columns[i % kColumnVectors]));
        };
        F32x16 z;
        TERRAZZO_FOR_PARTS z.part[p] = hn::Combine(TagF(), part(2 * p + 1), part(2 * p));
        return z;
#else
        alignas(64) float z[16];
        for (int i = 0; i < 16; ++i) {
            const float column = static_cast<float>(m_slope_x * (x + kX[i]) + m_a0);
            z[i] = static_cast<float>(m_slope_y * (y + kY[i]) + static_cast<double>(column));
        }
        return load(z);
#endif
    }

  private:
    double m_a0, m_slope_x, m_slope_y;
};

// The varyings of one primitive, evaluated a tile at a time.
class Interpolator {
  public:
    TERRAZZO_INLINE Interpolator(const Primitive& primitive, bool steep)
        : m_steep(steep),
          m_a0(primitive.a0()),
          m_dadx(primitive.dadx()),
          m_dady(primitive.dady()),
          m_depth(m_a0[0], m_dadx[0], m_dady[0]) {}

    TERRAZZO_INLINE void move_to(int x, int y) {
        m_tile_x = x;
        m_tile_y = y;
        m_x = to_float(lane_x() + I32x16(x));
        m_y = to_float(lane_y() + I32x16(y));
    }
    TERRAZZO_INLINE F32x16 plane(int index) const {
        if (m_steep) return steep_plane(index);
        return F32x16(m_a0[index]) + F32x16(m_dadx[index]) * m_x + F32x16(m_dady[index]) * m_y;
    }
    TERRAZZO_INLINE F32x16 depth() const { return m_depth.at(m_tile_x, m_tile_y); }
    // What perspective varyings are to be multiplied by.
    TERRAZZO_INLINE F32x16 w() const { return F32x16(1.0f) / plane(1); }
    // A varying's plane; they follow z and 1/w.
    TERRAZZO_INLINE F32x16 varying(int index) const { return plane(2 + index); }
    // One that is the same at every pixel.
    TERRAZZO_INLINE F32x16 constant(int index) const { return F32x16(m_a0[2 + index]); }
    // w() and varying(), rounded as the reference rounds them.
    TERRAZZO_INLINE F32x16 exact_w() const { return F32x16(1.0f) / exact_plane(1); }
    TERRAZZO_INLINE F32x16 exact_varying(int index) const { return exact_plane(2 + index); }

  private:
    TERRAZZO_INLINE F32x16 exact_plane(int index) const {
        return ExactPlane(m_a0[index], m_dadx[index], m_dady[index]).at(m_tile_x, m_tile_y);
    }

    TERRAZZO_NOINLINE F32x16 steep_plane(int index) const { return exact_plane(index); }

    bool m_steep;
    const float *m_a0, *m_dadx, *m_dady;
    ExactPlane m_depth;
    int m_tile_x = 0, m_tile_y = 0;
    F32x16 m_x, m_y;
};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
