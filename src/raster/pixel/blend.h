// Blending (GL 1.5 §4.1.7). Against integer colours in integers, as the reference does it: the source is
// quantised first, products of n bits are (ab + (ab >> n) + 2^(n-1)) >> n and sums saturate. Float colours
// blend as floats.
#pragma once

#include "raster/fragment_state.h"
#include "raster/pixel/color.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// The arithmetic of one channel: 16-bit integers or floats behind the same names. Of 8 bits: blend_packed.h.
struct Channel16 {
    using Value = I32x16;
    static constexpr bool kTakesFactorOut = false;
    static TERRAZZO_INLINE Value one() { return I32x16(65535); }
    static TERRAZZO_INLINE Value zero() { return I32x16(0); }
    static TERRAZZO_INLINE Value constant(float f) { return to_unorm(F32x16(f), 65535.0f); }
    static TERRAZZO_INLINE Value multiply(Value a, Value b) {
        const I32x16 ab = a * b;  // of 32 bits without a sign
        return shift_right_logical<16>(ab + shift_right_logical<16>(ab) + I32x16(32768));
    }
    static TERRAZZO_INLINE Value add(Value a, Value b) { return min(a + b, I32x16(65535)); }
    static TERRAZZO_INLINE Value subtract(Value a, Value b) { return max(a - b, I32x16(0)); }
};
struct ChannelF {
    using Value = F32x16;
    static constexpr bool kTakesFactorOut = true;
    static TERRAZZO_INLINE Value one() { return F32x16(1.0f); }
    static TERRAZZO_INLINE Value zero() { return F32x16(0.0f); }
    static TERRAZZO_INLINE Value constant(float f) { return F32x16(f); }
    static TERRAZZO_INLINE Value multiply(Value a, Value b) { return a * b; }
    static TERRAZZO_INLINE Value add(Value a, Value b) { return a + b; }
    static TERRAZZO_INLINE Value subtract(Value a, Value b) { return a - b; }
};

template <class Channel>
struct BlendInput {
    typename Channel::Value source[4], destination[4];
};

template <class Channel>
TERRAZZO_INLINE typename Channel::Value blend_factor(BlendFactor factor, const BlendInput<Channel>& in,
                                                     const float constant[4], int channel) {
    const auto invert = [](typename Channel::Value v) { return Channel::one() - v; };
    switch (factor) {
        case BlendFactor::kZero:
            break;
        case BlendFactor::kOne:
            return Channel::one();
        case BlendFactor::kSourceColor:
            return in.source[channel];
        case BlendFactor::kOneMinusSourceColor:
            return invert(in.source[channel]);
        case BlendFactor::kDestinationColor:
            return in.destination[channel];
        case BlendFactor::kOneMinusDestinationColor:
            return invert(in.destination[channel]);
        case BlendFactor::kSourceAlpha:
            return in.source[3];
        case BlendFactor::kOneMinusSourceAlpha:
            return invert(in.source[3]);
        case BlendFactor::kDestinationAlpha:
            return in.destination[3];
        case BlendFactor::kOneMinusDestinationAlpha:
            return invert(in.destination[3]);
        case BlendFactor::kConstantColor:
            return Channel::constant(constant[channel]);
        case BlendFactor::kOneMinusConstantColor:
            return invert(Channel::constant(constant[channel]));
        case BlendFactor::kConstantAlpha:
            return Channel::constant(constant[3]);
        case BlendFactor::kOneMinusConstantAlpha:
            return invert(Channel::constant(constant[3]));
        case BlendFactor::kSourceAlphaSaturate:
            return channel == 3 ? Channel::one() : min(in.source[3], invert(in.destination[3]));
    }
    return Channel::zero();
}

template <class Channel>
TERRAZZO_INLINE typename Channel::Value blend_channel(const FragmentState& state,
                                                      const BlendInput<Channel>& in, int channel) {
    const bool alpha = channel == 3;
    const BlendEquation equation = alpha ? state.blend_equation_alpha : state.blend_equation_rgb;
    const auto s = in.source[channel], d = in.destination[channel];
    if (equation == BlendEquation::kMin) return min(s, d);
    if (equation == BlendEquation::kMax) return max(s, d);
    const auto combined = [&](typename Channel::Value a, typename Channel::Value b) {
        if (equation == BlendEquation::kSubtract) return Channel::subtract(a, b);
        if (equation == BlendEquation::kReverseSubtract) return Channel::subtract(b, a);
        return Channel::add(a, b);
    };
    const auto weigh = [&](BlendFactor factor, typename Channel::Value v) {
        if (factor == BlendFactor::kOne) return v;
        if (factor == BlendFactor::kZero) return Channel::zero();
        return Channel::multiply(v, blend_factor<Channel>(factor, in, state.blend_color, channel));
    };
    const BlendFactor source = alpha ? state.blend_source_alpha : state.blend_source_rgb;
    const BlendFactor destination = alpha ? state.blend_destination_alpha : state.blend_destination_rgb;
    // The reference takes the factor out where there is one alone, which rounds floats differently.
    if (Channel::kTakesFactorOut && source == destination) return weigh(source, combined(s, d));
    return combined(weigh(source, s), weigh(destination, d));
}

template <class Channel>
TERRAZZO_NOINLINE void blend_general(const FragmentState& state, const BlendInput<Channel>& in,
                                     typename Channel::Value out[4]) {
    for (int c = 0; c < 4; ++c) out[c] = blend_channel<Channel>(state, in, c);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
