// Arithmetic on packed RGBA8 pixels, four bytes a lane: what blending does to 8-bit colours (GL 1.5 §4.1.7),
// in the reference's roundings.
#pragma once

#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
template <class Operation>
TERRAZZO_INLINE I32x16 each_byte(I32x16 a, I32x16 b, Operation operation) {
    I32x16 r;
    TERRAZZO_FOR_PARTS {
        const uint32_t x = static_cast<uint32_t>(hn::GetLane(a.part[p])),
                       y = static_cast<uint32_t>(hn::GetLane(b.part[p]));
        uint32_t out = 0;
        for (int byte = 0; byte < 32; byte += 8)
            out |= (static_cast<uint32_t>(
                        operation(static_cast<int>(x >> byte & 255), static_cast<int>(y >> byte & 255))) &
                    255)
                   << byte;
        r.part[p] = hn::Set(TagI(), static_cast<int32_t>(out));
    }
    return r;
}
TERRAZZO_INLINE I32x16 add_bytes(I32x16 a, I32x16 b) {
    return each_byte(a, b, [](int x, int y) { return x + y > 255 ? 255 : x + y; });
}
TERRAZZO_INLINE I32x16 subtract_bytes(I32x16 a, I32x16 b) {
    return each_byte(a, b, [](int x, int y) { return x < y ? 0 : x - y; });
}
TERRAZZO_INLINE I32x16 min_bytes(I32x16 a, I32x16 b) {
    return each_byte(a, b, [](int x, int y) { return x < y ? x : y; });
}
TERRAZZO_INLINE I32x16 max_bytes(I32x16 a, I32x16 b) {
    return each_byte(a, b, [](int x, int y) { return x < y ? y : x; });
}
// (ab + (ab >> 8) + 128) >> 8 of each byte.
TERRAZZO_INLINE I32x16 multiply_bytes(I32x16 a, I32x16 b) {
    return each_byte(a, b, [](int x, int y) { return (x * y + (x * y >> 8) + 128) >> 8; });
}
// source * alpha + destination * (1 - alpha) with the source's alpha.
TERRAZZO_INLINE I32x16 mix_by_alpha(I32x16 source, I32x16 destination) {
    const I32x16 a = shift_right_logical<24>(source), two = a | shift_left<8>(a),
                 alpha = two | shift_left<16>(two);
    return add_bytes(multiply_bytes(source, alpha), multiply_bytes(destination, alpha ^ I32x16(-1)));
}
#else
#define TERRAZZO_BYTES(name, operation)                                                                     \
    TERRAZZO_INLINE I32x16 name(I32x16 a, I32x16 b) {                                                       \
        using TagBytes = hn::Repartition<uint8_t, TagI>;                                                    \
        I32x16 r;                                                                                           \
        TERRAZZO_FOR_PARTS r.part[p] = hn::BitCast(                                                         \
            TagI(), hn::operation(hn::BitCast(TagBytes(), a.part[p]), hn::BitCast(TagBytes(), b.part[p]))); \
        return r;                                                                                           \
    }
// Sums and differences stop at 255 and 0.
TERRAZZO_BYTES(add_bytes, SaturatedAdd)
TERRAZZO_BYTES(subtract_bytes, SaturatedSub)
TERRAZZO_BYTES(min_bytes, Min)
TERRAZZO_BYTES(max_bytes, Max)
#undef TERRAZZO_BYTES

using TagHalves = hn::Repartition<uint16_t, TagI>;
using NativeHalves = hn::Vec<TagHalves>;
// (ab + (ab >> 8) + 128) >> 8 of each byte, at most 65407 on the way: bytes 0 and 2 of a lane times the
// halves of `even`, bytes 1 and 3 times those of `odd`.
TERRAZZO_INLINE NativeI multiply_bytes_native(NativeI bytes, NativeHalves even, NativeHalves odd) {
    const auto low = hn::Set(TagHalves(), 255), half = hn::Set(TagHalves(), 128);
    const auto product = [&](NativeHalves x, NativeHalves y) {
        const auto xy = hn::Mul(x, y);
        return hn::Add(hn::Add(xy, hn::ShiftRight<8>(xy)), half);
    };
    const auto x = hn::BitCast(TagHalves(), bytes);
    const auto first = product(hn::And(x, low), even), second = product(hn::ShiftRight<8>(x), odd);
    return hn::BitCast(TagI(), hn::Or(hn::ShiftRight<8>(first), hn::AndNot(low, second)));
}
TERRAZZO_INLINE I32x16 multiply_bytes(I32x16 a, I32x16 b) {
    const auto low = hn::Set(TagHalves(), 255);
    I32x16 r;
    TERRAZZO_FOR_PARTS {
        const auto y = hn::BitCast(TagHalves(), b.part[p]);
        r.part[p] = multiply_bytes_native(a.part[p], hn::And(y, low), hn::ShiftRight<8>(y));
    }
    return r;
}
// source * alpha + destination * (1 - alpha) with the source's alpha.
TERRAZZO_INLINE I32x16 mix_by_alpha(I32x16 source, I32x16 destination) {
    using TagBytes = hn::Repartition<uint8_t, TagI>;
    alignas(16) static constexpr uint8_t kAlpha[16] = {3,  128, 3,  128, 7,  128, 7,  128,
                                                       11, 128, 11, 128, 15, 128, 15, 128};
    const auto order = hn::LoadDup128(TagBytes(), kAlpha);
    const auto low = hn::Set(TagHalves(), 255);
    I32x16 r;
    TERRAZZO_FOR_PARTS {
        const auto bytes = hn::BitCast(TagBytes(), source.part[p]);
        const auto alpha = hn::BitCast(TagHalves(), hn::TableLookupBytesOr0(bytes, order));
        const auto rest = hn::Xor(alpha, low);
        const auto s = multiply_bytes_native(source.part[p], alpha, alpha);
        const auto d = multiply_bytes_native(destination.part[p], rest, rest);
        r.part[p] =
            hn::BitCast(TagI(), hn::SaturatedAdd(hn::BitCast(TagBytes(), s), hn::BitCast(TagBytes(), d)));
    }
    return r;
}
#endif

TERRAZZO_INLINE I32x16 invert_bytes(I32x16 v) {
    return v ^ I32x16(-1);  // 255 - byte
}

// A pixel's alpha in all four bytes.
TERRAZZO_INLINE I32x16 spread_alpha(I32x16 pixel) {
#if HWY_TARGET == HWY_SCALAR
    const I32x16 a = shift_right_logical<24>(pixel);
    const I32x16 two = a | shift_left<8>(a);
    return two | shift_left<16>(two);
#else
    alignas(16) static constexpr uint8_t kAlpha[16] = {3,  3,  3,  3,  7,  7,  7,  7,
                                                       11, 11, 11, 11, 15, 15, 15, 15};
    using TagBytes = hn::Repartition<uint8_t, TagI>;
    const auto order = hn::LoadDup128(TagBytes(), kAlpha);
    I32x16 r;
    TERRAZZO_FOR_PARTS r.part[p] =
        hn::BitCast(TagI(), hn::TableLookupBytes(hn::BitCast(TagBytes(), pixel.part[p]), order));
    return r;
#endif
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
