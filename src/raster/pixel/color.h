// A colour of 16 pixels, and its way to and from unsigned normalised integers.
#pragma once

#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

struct Color {
    F32x16 r, g, b, a;
};

TERRAZZO_INLINE Color uniform_color(const float c[4]) {
    return {c[0], c[1], c[2], c[3]};
}

// round(f * 255) into [0, 255]; NaN gives 0.
TERRAZZO_INLINE I32x16 to_unorm8(F32x16 f) {
    return round_to_int(clamp(f, F32x16(0.0f), F32x16(1.0f)) * F32x16(255.0f));
}
TERRAZZO_INLINE I32x16 to_unorm(F32x16 f, float maximum) {
    return round_to_int(clamp(f, F32x16(0.0f), F32x16(1.0f)) * F32x16(maximum));
}
TERRAZZO_INLINE F32x16 from_unorm8(I32x16 v) {
    return to_float(v) * F32x16(1.0f / 255.0f);
}

struct Color8 {
    I32x16 r, g, b, a;  // each in [0, 255]
};
TERRAZZO_INLINE Color8 unpack_rgba8(I32x16 packed) {
    const I32x16 byte(255);
    return {packed & byte, shift_right<8>(packed) & byte, shift_right<16>(packed) & byte,
            shift_right_logical<24>(packed)};
}
TERRAZZO_INLINE Color from_color8(const Color8& c) {
    return {from_unorm8(c.r), from_unorm8(c.g), from_unorm8(c.b), from_unorm8(c.a)};
}
TERRAZZO_INLINE I32x16 pack_rgba8(Color8 c) {
    return c.r | shift_left<8>(c.g) | shift_left<16>(c.b) | shift_left<24>(c.a);
}

// round(c * 255) of each channel, packed; below 0 and NaN become 0, above 1 becomes 255.
TERRAZZO_INLINE I32x16 quantize_rgba8(const Color& c) {
#if defined(TERRAZZO_X86)
    // The conversion makes INT32_MIN of NaN and of what is far below 0; packing saturates the rest.
    const F32x16 one(1.0f), scale(255.0f);
    const auto integer = [&](F32x16 f) { return round_to_int(min(one, f) * scale); };
    const I32x16 r = integer(c.r), g = integer(c.g), b = integer(c.b), a = integer(c.a);
    alignas(16) static constexpr uint8_t kOrder[16] = {0, 8, 4, 12, 1, 9, 5, 13, 2, 10, 6, 14, 3, 11, 7, 15};
    const auto order = hn::LoadDup128(hn::Repartition<uint8_t, TagI>(), kOrder);
    I32x16 packed;
    TERRAZZO_FOR_PARTS {
        const auto rb = TERRAZZO_X86(packs_epi32)(r.part[p].raw, b.part[p].raw);
        const auto ga = TERRAZZO_X86(packs_epi32)(g.part[p].raw, a.part[p].raw);
        packed.part[p].raw = TERRAZZO_X86(shuffle_epi8)(TERRAZZO_X86(packus_epi16)(rb, ga), order.raw);
    }
    return packed;
#else
    return pack_rgba8({to_unorm8(c.r), to_unorm8(c.g), to_unorm8(c.b), to_unorm8(c.a)});
#endif
}

// A packed texel as floats in [0, 1].
TERRAZZO_INLINE Color color_of_packed(I32x16 packed) {
    return from_color8(unpack_rgba8(packed));
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
