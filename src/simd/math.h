// Elementary functions of 16 lanes, made of multiplications and additions so that every instruction set
// returns the same bits: the reference's polynomials with its coefficients (doc/reference.md §2.4).
//
// pow_fused does the reference's fused steps and returns its bits; vertices use it, where an exponent can
// magnify the last bit. exp2 rounds each step and is off by at most two of the last
// bits: fragments use it, where that is far below a colour step.
#pragma once

#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// x = whole + fraction, and 2^whole. Beyond [-126.99999, 128] the result of 2^x would be 0 or infinite.
struct PowerOfTwo {
    F32x16 fraction, scale;
};
TERRAZZO_INLINE PowerOfTwo split_exponent(F32x16 x) {
    x = max(min(x, F32x16(128.0f)), F32x16(-126.99999f));
    const F32x16 whole = floor(x);
    return {x - whole, as_float(shift_left<23>(truncate_to_int(whole) + I32x16(127)))};
}

inline constexpr float kExp2Odd[3] = {0.693153073200168932794f, 0.0558263180532956664775f,
                                      0.00187757667519147912699f};
inline constexpr float kExp2Even[3] = {1.0f, 0.240153617044375388211f, 0.00898934009049466391101f};

TERRAZZO_INLINE F32x16 exp2(F32x16 x) {
    const auto [f, scale] = split_exponent(x);
    const F32x16 g = f * f;
    const F32x16 odd = g * (g * F32x16(kExp2Odd[2]) + F32x16(kExp2Odd[1])) + F32x16(kExp2Odd[0]);
    const F32x16 even = g * (g * F32x16(kExp2Even[2]) + F32x16(kExp2Even[1])) + F32x16(kExp2Even[0]);
    return (odd * f + even) * scale;
}

TERRAZZO_INLINE F32x16 exp2_fused(F32x16 x) {
    const auto [f, scale] = split_exponent(x);
    const F32x16 g = f * f;
    const auto step = [&](F32x16 a, float b) { return fused_multiply_add(g, a, F32x16(b)); };
    const F32x16 odd = step(step(F32x16(kExp2Odd[2]), kExp2Odd[1]), kExp2Odd[0]);
    const F32x16 even = step(step(F32x16(kExp2Even[2]), kExp2Even[1]), kExp2Even[0]);
    return fused_multiply_add(odd, f, even) * scale;
}

// For finite normal x > 0.
TERRAZZO_INLINE F32x16 log2_fused(F32x16 x) {
    const I32x16 bits = as_int(x);
    const F32x16 exponent = to_float(shift_right<23>(bits) - I32x16(127));
    const F32x16 m = as_float((bits & I32x16(0x7fffff)) | I32x16(0x3f800000));
    const F32x16 t = (m - F32x16(1.0f)) / (m + F32x16(1.0f));
    const F32x16 u = t * t, v = u * u;
    const auto step = [&](F32x16 a, float b) { return fused_multiply_add(v, a, F32x16(b)); };
    const F32x16 even =
        step(step(F32x16(0.406718052498846252698f), 0.577440339438736392009f), 2.88539009343309178325f);
    const F32x16 odd = step(F32x16(0.403343858251329912514f), 0.961791550404184197881f);
    return fused_multiply_add(t, fused_multiply_add(odd, u, even), exponent);
}

// x^y for x >= 0. 0^y is 0, even where y is 0.
TERRAZZO_INLINE F32x16 pow_fused(F32x16 x, F32x16 y) {
    return select(x == F32x16(0.0f), F32x16(0.0f), exp2_fused(log2_fused(x) * y));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
