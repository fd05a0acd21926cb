// Random numbers that are the same on every machine: only the generator's bits are used, none of the standard
// distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>

namespace terrazzo::coverage {

class Random {
  public:
    Random(uint32_t seed, uint32_t stream) : m_bits((uint64_t{seed} << 32) + stream) {}

    uint32_t below(uint32_t count) { return static_cast<uint32_t>((m_bits() >> 32) * count >> 32); }
    bool chance(uint32_t one_in) { return below(one_in) == 0; }
    // In [low, high), on a fine lattice.
    float number(float low, float high) {
        return low + (high - low) * (static_cast<float>(m_bits() >> 40) * 0x1p-24f);
    }
    // `v` moved to a multiple of `step`.
    static float on_lattice(float v, float step) { return std::floor(v / step) * step; }
    template <typename Value>
    Value one_of(std::initializer_list<Value> values) {
        return values.begin()[below(static_cast<uint32_t>(values.size()))];
    }

    // Nothing that a vertex should be made of.
    float stray() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        return one_of({std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 3e38f, -3e38f, 1e20f,
                       -1e20f, 1e-40f, 1e30f, 65536.0f, -1e9f});
    }

  private:
    std::mt19937_64 m_bits;
};

}  // namespace terrazzo::coverage
