// Interpolation: a primitive's planes at the 16 pixels of a tile.
//
// Depth is what the reference computes, fma(dz/dy, y, fma(dz/dx, x, a0)). Other varyings use plain
// multiplications and additions, whose error set-up has found too small to be seen; where it has not
// (slivers, Primitive::steep) they are as exact as depth. The reason for not fusing them all are the
// processors that cannot.
#pragma once

#include "raster/primitive.h"
#include "raster/target/target.h"
#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

#if HWY_NATIVE_FMA || HWY_TARGET == HWY_SCALAR || !HWY_HAVE_FLOAT64
// a0 + dadx * x + dady * y with the reference's roundings, for x and y below 2^15 in steps of an eighth.
TERRAZZO_INLINE F32x16 exact_plane(float a0, float dadx, float dady, F32x16 x, F32x16 y) {
    return fused_multiply_add(F32x16(dady), y, fused_multiply_add(F32x16(dadx), x, F32x16(a0)));
}
#else
// The same in doubles: a tile's pixels share four columns, each of which is rounded once.
TERRAZZO_INLINE F32x16 exact_plane(float a0, float dadx, float dady, F32x16 x, F32x16 y) {
    const auto slope_x = hn::Set(TagWide(), static_cast<double>(dadx)),
               slope_y = hn::Set(TagWide(), static_cast<double>(dady)),
               origin = hn::Set(TagWide(), static_cast<double>(a0));
    constexpr int kDoubles = kNativeLanes / 2;
    constexpr int kColumnVectors = kDoubles < 4 ? 4 / kDoubles : 1;
    const auto lower = [](NativeF v) { return hn::PromoteTo(TagWide(), hn::LowerHalf(TagHalfF(), v)); };
    const auto upper = [](NativeF v) { return hn::PromoteTo(TagWide(), hn::UpperHalf(TagHalfF(), v)); };
    Ties ties;
    const auto sum = [&](NativeWide at, NativeWide slope, NativeWide base) {
        const auto s = hn::Add(hn::Mul(at, slope), base);
        ties.add(s);
        return hn::DemoteTo(TagHalfF(), s);
    };
    NativeWide columns[kColumnVectors];
    for (int i = 0; i < kColumnVectors; ++i)
        columns[i] = hn::PromoteTo(
            TagWide(), sum(i % 2 == 0 ? lower(x.part[i / 2]) : upper(x.part[i / 2]), slope_x, origin));
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] =
        hn::Combine(TagF(), sum(upper(y.part[p]), slope_y, columns[(2 * p + 1) % kColumnVectors]),
                    sum(lower(y.part[p]), slope_y, columns[2 * p % kColumnVectors]));
    if (!ties.found()) return r;
    return fused_lane_by_lane(F32x16(dady), y, fused_lane_by_lane(F32x16(dadx), x, F32x16(a0)));
}
#endif

// The varyings of one primitive, evaluated a tile at a time.
class Interpolator {
  public:
    TERRAZZO_INLINE Interpolator(const Primitive& primitive, bool steep)
        : m_steep(steep), m_a0(primitive.a0()), m_dadx(primitive.dadx()), m_dady(primitive.dady()) {}

    TERRAZZO_INLINE void move_to(int x, int y) {
        m_column = x / kTileSize;
        m_row = y / kTileSize;
        set_first(static_cast<float>(x), static_cast<float>(y));
    }
    // From a tile's corners to other places within its pixels.
    TERRAZZO_INLINE Interpolator at_offset(float x, float y) const {
        Interpolator moved = *this;
        moved.set_first(m_first_x + x, m_first_y + y);
        return moved;
    }
    TERRAZZO_INLINE F32x16 plane(int index) const {
        if (m_steep) return steep_plane(m_a0[index], m_dadx[index], m_dady[index], m_first_x, m_first_y);
        return F32x16(m_a0[index]) + F32x16(m_dadx[index]) * m_x + F32x16(m_dady[index]) * m_y;
    }
    TERRAZZO_INLINE F32x16 depth() const { return exact(0); }
    // What perspective varyings are to be multiplied by.
    TERRAZZO_INLINE F32x16 w() const { return F32x16(1.0f) / plane(1); }
    // A varying's plane; they follow z and 1/w.
    TERRAZZO_INLINE F32x16 varying(int index) const { return plane(2 + index); }
    // One that is the same at every pixel.
    TERRAZZO_INLINE F32x16 constant(int index) const { return F32x16(m_a0[2 + index]); }
    // The tile's part of a rectangle's data, `kElements` elements a tile.
    template <class Element, int kElements>
    TERRAZZO_INLINE const Element* image_tile(const Primitive& primitive) const {
        const TileData& data = primitive.tile_data;
        return static_cast<const Element*>(data.tiles) + kElements * data.index(m_column, m_row);
    }
    // w() and varying(), rounded as the reference rounds them.
    TERRAZZO_INLINE F32x16 exact_w() const { return F32x16(1.0f) / exact(1); }
    TERRAZZO_INLINE F32x16 exact_varying(int index) const { return exact(2 + index); }

  private:
    TERRAZZO_INLINE F32x16 exact(int index) const {
        return exact_plane(m_a0[index], m_dadx[index], m_dady[index], m_x, m_y);
    }

    // Takes numbers, not the object, which stays in registers that way.
    static TERRAZZO_NOINLINE F32x16 steep_plane(float a0, float dadx, float dady, float x, float y) {
        return exact_plane(a0, dadx, dady, load(kLaneX) + F32x16(x), load(kLaneY) + F32x16(y));
    }

    // Exact: coordinates are below 2^15, in steps of an eighth.
    TERRAZZO_INLINE void set_first(float x, float y) {
        m_first_x = x, m_first_y = y;
        m_x = load(kLaneX) + F32x16(x);
        m_y = load(kLaneY) + F32x16(y);
    }

    alignas(64) static constexpr float kLaneX[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float kLaneY[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

    bool m_steep;
    int m_column = 0, m_row = 0;  // of the tile in the target
    float m_first_x = 0, m_first_y = 0;
    const float *m_a0, *m_dadx, *m_dady;
    F32x16 m_x, m_y;
};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
