// Sine and cosine in double precision, rounded once to float: the method and the constants of Arm's optimized
// routines, which glibc took over (math/sincosf.h there), with the fused operations of glibc's FMA variant.
// A correctly rounded function would not do: the polynomials are good to 0.56 units in the last place, so
// their rare wrong roundings are part of the result. std::fma is exact on every machine, in hardware or not.
// The arc tangent is in single precision, by the method of fdlibm (e_atan2f, s_atanf), which glibc kept: its
// error reaches most of a unit, so the order of operations matters here too.

#include "simd/trigonometry.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace terrazzo::simd {

namespace {

constexpr double kHalfPi = 0x1.921fb54442d18p0;
constexpr double kTwoOverPiScaled = 0x1.45f306dc9c883p+23;  // 2/pi * 2^24

// 4/pi in overlapping 32-bit pieces, eight bits apart.
constexpr std::uint32_t kFourOverPi[24] = {
    0x000000a2, 0x0000a2f9, 0x00a2f983, 0xa2f9836e, 0xf9836e4e, 0x836e4e44, 0x6e4e4415, 0x4e441529,
    0x441529fc, 0x1529fc27, 0x29fc2757, 0xfc2757d1, 0x2757d1f5, 0x57d1f534, 0xd1f534dd, 0xf534ddc0,
    0x34ddc0db, 0xddc0db62, 0xc0db6295, 0xdb629599, 0x6295993c, 0x95993c43, 0x993c4390, 0x3c439041,
};

struct Reduced {
    double angle;       // within pi/4 of zero, or a little beyond
    unsigned quadrant;  // modulo 4
};

double sine_polynomial(double x) {
    const double x2 = x * x;
    const double x3 = x * x2;
    const double high = std::fma(x2, -0x1.994eb3774cf24p-13, 0x1.1107605230bc4p-7);
    const double low = std::fma(x3, -0x1.555545995a603p-3, x);
    return std::fma(x3 * x2, high, low);
}

double cosine_polynomial(double x) {
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double high = std::fma(x2, 0x1.99343027bf8c3p-16, -0x1.6c087e89a359dp-10);
    const double low = std::fma(x4, 0x1.55553e1068f19p-5, std::fma(x2, -0x1.ffffffd0c621cp-2, 1.0));
    return std::fma(x4 * x2, high, low);
}

// Multiplies the mantissa by 96 bits of 4/pi: two bits of quadrant, 62 of fraction.
Reduced reduce_large(std::uint32_t bits) {
    const std::uint32_t* pieces = kFourOverPi + ((bits >> 26) & 15);
    const std::uint32_t mantissa = ((bits & 0xffffff) | 0x800000) << ((bits >> 23) & 7);
    std::uint64_t product = std::uint64_t{mantissa * pieces[0]} << 32;
    product |= (std::uint64_t{mantissa} * pieces[8]) >> 32;
    product += std::uint64_t{mantissa} * pieces[4];
    const std::uint64_t quadrant = (product + (std::uint64_t{1} << 61)) >> 62;
    const auto fraction = static_cast<std::int64_t>(product - (quadrant << 62));
    const double angle = static_cast<double>(fraction) * 0x1.921fb54442d18p-62;
    const bool negative = bits >> 31;
    return {negative ? -angle : angle, static_cast<unsigned>(negative ? 0 - quadrant : quadrant)};
}

Reduced reduce(float radians) {
    const auto bits = std::bit_cast<std::uint32_t>(radians);
    const std::uint32_t top = (bits >> 20) & 0x7ff;  // exponent and three bits of mantissa
    if (top < 0x3f4) return {radians, 0};            // about pi/4
    if (top >= 0x42f) return reduce_large(bits);     // 120
    const int quadrant = (static_cast<int>(radians * kTwoOverPiScaled) + 0x800000) >> 24;
    return {std::fma(-quadrant, kHalfPi, radians), static_cast<unsigned>(quadrant)};
}

float quadrant_sine(const Reduced& r) {
    const double value = r.quadrant & 1 ? cosine_polynomial(r.angle) : sine_polynomial(r.angle);
    return static_cast<float>(r.quadrant & 2 ? -value : value);
}

bool tiny(float radians) {
    return std::fabs(radians) < 0x1p-12f;
}

// atan(x) for x >= 0: from the nearest of the angles atan(0), atan(1/2), atan(1), atan(3/2), atan(infinity).
float arc_tangent_of_ratio(float x) {
    constexpr float kAngle[4] = {0x1.dac670p-2f, 0x1.921fb4p-1f, 0x1.f730bcp-1f, 0x1.921fb4p0f};
    constexpr float kAngleRest[4] = {0x1.586ed2p-28f, 0x1.4442d0p-25f, 0x1.281f68p-25f, 0x1.4442d0p-24f};
    constexpr float kSeries[11] = {0x1.555556p-2f, -0x1.99999ap-3f, 0x1.24924ap-3f, -0x1.c71c70p-4f,
                                   0x1.745cdcp-4f, -0x1.3b0f2ap-4f, 0x1.10d66ap-4f, -0x1.dde2d6p-5f,
                                   0x1.97b4b2p-5f, -0x1.2b4442p-5f, 0x1.0ad3aep-6f};
    if (x >= 0x1p25f) return kAngle[3] + kAngleRest[3];
    if (x < 0x1p-29f) return x;
    int nearest = -1;
    if (x >= 2.4375f) {
        nearest = 3, x = -1.0f / x;
    } else if (x >= 1.1875f) {
        nearest = 2, x = (x - 1.5f) / (1.0f + 1.5f * x);
    } else if (x >= 0.6875f) {
        nearest = 1, x = (x - 1.0f) / (x + 1.0f);
    } else if (x >= 0.4375f) {
        nearest = 0, x = (2.0f * x - 1.0f) / (2.0f + x);
    }
    const float x2 = x * x, x4 = x2 * x2;
    float even = kSeries[10], odd = kSeries[9];
    for (int i = 8; i >= 0; i -= 2) even = kSeries[i] + x4 * even;
    for (int i = 7; i >= 1; i -= 2) odd = kSeries[i] + x4 * odd;
    const float series = x * (x2 * even + x4 * odd);
    if (nearest < 0) return x - series;
    return kAngle[nearest] - ((series - kAngleRest[nearest]) - x);
}

}  // namespace

float sine(float radians) {
    if (!std::isfinite(radians)) return std::numeric_limits<float>::quiet_NaN();
    return tiny(radians) ? radians : quadrant_sine(reduce(radians));
}

float cosine(float radians) {
    if (!std::isfinite(radians)) return std::numeric_limits<float>::quiet_NaN();
    if (tiny(radians)) return 1.0f;
    Reduced r = reduce(radians);
    ++r.quadrant;
    return quadrant_sine(r);
}

float arc_tangent(float y, float x) {
    constexpr float kPi = 0x1.921fb6p1f, kPiRest = -0x1.777a5cp-24f;  // their sum is pi to 48 bits
    constexpr float kHalfPi = 0x1.921fb6p0f;
    const bool below = std::signbit(y), left = std::signbit(x);
    if (y == 0) return left ? (below ? -kPi : kPi) : y;
    if (x == 0) return below ? -kHalfPi : kHalfPi;
    const int scale = std::ilogb(y) - std::ilogb(x);
    float angle;
    if (scale > 60) {
        angle = kHalfPi + 0.5f * kPiRest;
    } else if (left && scale < -60) {
        angle = 0;
    } else {
        angle = arc_tangent_of_ratio(std::fabs(y / x));
    }
    if (left) return below ? (angle - kPiRest) - kPi : kPi - (angle - kPiRest);
    return below ? -angle : angle;
}

}  // namespace terrazzo::simd
