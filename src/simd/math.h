// Elementary functions of 16 lanes from multiplications and additions alone, so that every instruction set
// returns the same bits. Errors are relative and were measured over the ranges fixed-function GL uses.
#pragma once

#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

// 2^x, relative error below 2e-7; x is clamped to [-126, 127.9].
TERRAZZO_INLINE F32x16 exp2(F32x16 x) {
    x = clamp(x, F32x16(-126.0f), F32x16(127.9f));
    const I32x16 whole = round_to_int(x);
    const F32x16 f = x - to_float(whole);
    // Taylor series of 2^f on [-1/2, 1/2]: (ln 2)^n / n!
    F32x16 p(1.5403530e-4f);
    p = p * f + F32x16(1.3333558e-3f);
    p = p * f + F32x16(9.6181291e-3f);
    p = p * f + F32x16(5.5504109e-2f);
    p = p * f + F32x16(2.4022651e-1f);
    p = p * f + F32x16(6.9314718e-1f);
    p = p * f + F32x16(1.0f);
    return p * as_float(shift_left<23>(whole + I32x16(127)));
}

// log2 x for finite x > 0, absolute error below 2e-7 * max(1, |log2 x|); denormal numbers count as the
// smallest normal.
TERRAZZO_INLINE F32x16 log2(F32x16 x) {
    const I32x16 bits = as_int(max(x, F32x16(1.17549435e-38f)));
    // Mantissa in [sqrt(1/2), sqrt(2)).
    const I32x16 exponent = shift_right<23>(bits - I32x16(0x3f3504f3));
    const F32x16 m = as_float(bits - shift_left<23>(exponent));
    const F32x16 t = (m - F32x16(1.0f)) / (m + F32x16(1.0f));
    const F32x16 t2 = t * t;
    // 2 / ln 2 * (t + t^3/3 + t^5/5 + ...)
    F32x16 p(0.32059889f);
    p = p * t2 + F32x16(0.41219858f);
    p = p * t2 + F32x16(0.57707802f);
    p = p * t2 + F32x16(0.96179669f);
    p = p * t2 + F32x16(2.8853901f);
    return p * t + to_float(exponent);
}

// x^y for x >= 0; 0^0 is 1.
TERRAZZO_INLINE F32x16 pow(F32x16 x, F32x16 y) {
    const F32x16 power = exp2(log2(x) * y);
    const Mask16 zero = x == F32x16(0.0f);
    return select(zero, select(y == F32x16(0.0f), F32x16(1.0f), F32x16(0.0f)), power);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
