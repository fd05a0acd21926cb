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

// Where a tile's pixels are: their columns, the same in every row of them, and their rows. Coordinates are
// below 2^15, in steps of an eighth.
struct PixelPlaces {
    static constexpr int kColumnParts = kNativeLanes < 4 ? 4 / kNativeLanes : 1;

    NativeF columns[kColumnParts];
    F32x16 rows;

    // Exact.
    TERRAZZO_INLINE PixelPlaces(float x, float y) : rows(load(kLaneY) + F32x16(y)) {
        for (int i = 0; i < kColumnParts; ++i)
            columns[i] = hn::Add(hn::Load(TagF(), kLaneX + i * kNativeLanes), hn::Set(TagF(), x));
    }

  private:
    alignas(64) static constexpr float kLaneX[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float kLaneY[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
};

// a0 + dadx * x + dady * y, each step of it done by `step(slope, at, sum)`: the columns' once for all rows.
template <class Step>
TERRAZZO_INLINE F32x16 sum_plane(float a0, float dadx, float dady, const PixelPlaces& at, Step step) {
    constexpr int kColumnParts = PixelPlaces::kColumnParts;
    NativeF columns[kColumnParts];
    for (int i = 0; i < kColumnParts; ++i)
        columns[i] = step(hn::Set(TagF(), dadx), at.columns[i], hn::Set(TagF(), a0));
    F32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] = step(hn::Set(TagF(), dady), at.rows.part[p], columns[p % kColumnParts]);
    return r;
}

// The same with the reference's roundings, each product and sum rounded once.
#if HWY_NATIVE_FMA
TERRAZZO_INLINE F32x16 exact_plane(float a0, float dadx, float dady, const PixelPlaces& at) {
    return sum_plane(a0, dadx, dady, at, [](NativeF slope, NativeF x, NativeF sum) TERRAZZO_INLINE_LAMBDA {
        return hn::MulAdd(slope, x, sum);
    });
}
#else
TERRAZZO_NOINLINE F32x16 exact_plane_lane_by_lane(float a0, float dadx, float dady, const PixelPlaces& at) {
    alignas(64) float columns[16], rows[16], sums[16];
    for (int i = 0; i < PixelPlaces::kColumnParts; ++i)
        hn::Store(at.columns[i], TagF(), columns + i * kNativeLanes);
    store(at.rows, rows);
    for (int i = 0; i < 16; ++i)
        sums[i] = fused_multiply_add(dady, rows[i], fused_multiply_add(dadx, columns[i % 4], a0));
    return load(sums);
}
#if HWY_TARGET == HWY_SCALAR || !HWY_HAVE_FLOAT64
TERRAZZO_INLINE F32x16 exact_plane(float a0, float dadx, float dady, const PixelPlaces& at) {
    return exact_plane_lane_by_lane(a0, dadx, dady, at);
}
#else
// In doubles, where products are exact, and a sum rounded to a float is the fused one unless it lies half-way
// between two floats without being exact.
template <bool kSumsAreExact>
TERRAZZO_INLINE F32x16 plane_in_doubles(float a0, float dadx, float dady, const PixelPlaces& at) {
    static_assert(kNativeLanes == 4, "a vector of floats is a row of a tile");
    const auto slope_x = hn::Set(TagWide(), static_cast<double>(dadx)),
               slope_y = hn::Set(TagWide(), static_cast<double>(dady)),
               origin = hn::Set(TagWide(), static_cast<double>(a0));
    const auto lower = [](NativeF v) TERRAZZO_INLINE_LAMBDA {
        return hn::PromoteTo(TagWide(), hn::LowerHalf(TagHalfF(), v));
    };
    const auto upper = [](NativeF v) TERRAZZO_INLINE_LAMBDA {
        return hn::PromoteTo(TagWide(), hn::UpperHalf(TagHalfF(), v));
    };
    Ties ties;
    const auto rounded = [&](NativeWide sum) TERRAZZO_INLINE_LAMBDA {
        if constexpr (!kSumsAreExact) ties.add(sum);
        return hn::DemoteTo(TagHalfF(), sum);
    };
    const auto left =
        hn::PromoteTo(TagWide(), rounded(hn::Add(hn::Mul(lower(at.columns[0]), slope_x), origin)));
    const auto right =
        hn::PromoteTo(TagWide(), rounded(hn::Add(hn::Mul(upper(at.columns[0]), slope_x), origin)));
    F32x16 r;
    TERRAZZO_FOR_PARTS {
        const auto row = hn::Mul(lower(at.rows.part[p]), slope_y);
        r.part[p] = hn::Combine(TagF(), rounded(hn::Add(row, right)), rounded(hn::Add(row, left)));
    }
    if constexpr (!kSumsAreExact)
        if (ties.found()) return exact_plane_lane_by_lane(a0, dadx, dady, at);
    return r;
}
TERRAZZO_NOINLINE F32x16 plane_that_may_tie(float a0, float dadx, float dady, const PixelPlaces& at) {
    return plane_in_doubles<false>(a0, dadx, dady, at);
}
// Whether doubles hold every such sum exactly: all terms are multiples of the last bit of the smallest, and
// the largest is less than 2^50 times that.
TERRAZZO_INLINE bool sums_are_exact(float a0, float dadx, float dady, const PixelPlaces& at) {
    // Biased exponents. A denormal number has none here: it is told from 0, which is a multiple of
    // everything.
    const auto exponent = [](float v) TERRAZZO_INLINE_LAMBDA {
        return static_cast<int>(__builtin_bit_cast(uint32_t, v) << 1 >> 24);
    };
    const auto of_last_bit = [&](float v, int below)
                                 TERRAZZO_INLINE_LAMBDA { return v == 0 ? 255 : exponent(v) - below; };
    const float far = hn::GetLane(at.columns[0]) + hn::GetLane(at.rows.part[0]) + 2 * kTileSize;
    const int times_place = exponent(far) - 127 + 1;
    const int largest = std::max(exponent(a0), std::max(exponent(dadx), exponent(dady)) + times_place);
    const int last_bit = std::min(of_last_bit(a0, 0), std::min(of_last_bit(dadx, 3), of_last_bit(dady, 3)));
    // A sum of three is less than eight times the largest term's power of two, and the last bit is 23 below.
    return last_bit > 3 && largest + 3 - (last_bit - 23) <= 53;
}
TERRAZZO_INLINE F32x16 exact_plane(float a0, float dadx, float dady, const PixelPlaces& at) {
    if (!sums_are_exact(a0, dadx, dady, at)) [[unlikely]]
        return plane_that_may_tie(a0, dadx, dady, at);
    return plane_in_doubles<true>(a0, dadx, dady, at);
}
#endif
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
        return sum_plane(m_a0[index], m_dadx[index], m_dady[index], m_at,
                         [](NativeF slope, NativeF x, NativeF sum)
                             TERRAZZO_INLINE_LAMBDA { return hn::Add(sum, hn::Mul(slope, x)); });
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
        return exact_plane(m_a0[index], m_dadx[index], m_dady[index], m_at);
    }

    // Takes numbers, not the object, which stays in registers that way.
    static TERRAZZO_NOINLINE F32x16 steep_plane(float a0, float dadx, float dady, float x, float y) {
        return exact_plane(a0, dadx, dady, PixelPlaces(x, y));
    }

    TERRAZZO_INLINE void set_first(float x, float y) {
        m_first_x = x, m_first_y = y;
        m_at = PixelPlaces(x, y);
    }

    bool m_steep;
    int m_column = 0, m_row = 0;  // of the tile in the target
    float m_first_x = 0, m_first_y = 0;
    const float *m_a0, *m_dadx, *m_dady;
    PixelPlaces m_at{0, 0};
};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
