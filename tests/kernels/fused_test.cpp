// The fused multiply-add of the instruction sets that have none against the C library's. Compiled once for
// each, as the layer itself is.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simd/wide.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {
namespace {

struct Operands {
    alignas(64) float a[16], b[16], c[16];
};

void expect_once_rounded(const Operands& in) {
    alignas(64) float wide[16];
    store(fused_multiply_add(load(in.a), load(in.b), load(in.c)), wide);
    for (int i = 0; i < 16; ++i) {
        const float expected = std::fma(in.a[i], in.b[i], in.c[i]);
        ASSERT_EQ(wide[i], expected) << in.a[i] << " * " << in.b[i] << " + " << in.c[i];
        ASSERT_EQ(fused_multiply_add(in.a[i], in.b[i], in.c[i]), expected);
    }
}

TEST(FusedMultiplyAdd, RoundsOnce) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-2, 2);
    for (int trial = 0; trial < 100000; ++trial) {
        Operands in;
        for (int i = 0; i < 16; ++i) {
            in.a[i] = std::ldexp(number(random), static_cast<int>(random() % 40) - 20);
            in.b[i] = std::ldexp(number(random), static_cast<int>(random() % 40) - 20);
            in.c[i] = std::ldexp(number(random), static_cast<int>(random() % 40) - 20);
        }
        expect_once_rounded(in);
    }
}

// Sums that lie so close to half-way between two floats that a double cannot tell: rounding twice goes wrong.
TEST(FusedMultiplyAdd, RoundsOnceWhereRoundingTwiceErrs) {
    std::mt19937 random(6);
    int erring = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        Operands in;
        for (int i = 0; i < 16; ++i) {
            // c is 1 + k ulp; a * b is (1 + x)(1 - x) half ulps, where x * x is beyond a double's last bit.
            const float x = std::ldexp(static_cast<float>(1 + random() % 300), -23);
            const float sign = random() % 2 == 0 ? 1.0f : -1.0f;
            in.a[i] = sign * (1 + x);
            in.b[i] = std::ldexp(1 - x, -24);
            in.c[i] = sign * (1 + std::ldexp(static_cast<float>(random() % 4096), -23));
            const double sum = static_cast<double>(in.a[i]) * in.b[i] + static_cast<double>(in.c[i]);
            erring += static_cast<float>(sum) != std::fma(in.a[i], in.b[i], in.c[i]);
        }
        expect_once_rounded(in);
    }
    EXPECT_GT(erring, 100);
}

}  // namespace
}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
