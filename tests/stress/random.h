// Random numbers that are the same with every C++ library: the standard's distributions are not.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace terrazzo::stress {

class Random {
  public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    // 0 <= result < count.
    int below(int count) { return static_cast<int>((m_engine() >> 33) % static_cast<std::uint64_t>(count)); }
    // Once in `times` on average.
    bool once_in(int times) { return below(times) == 0; }
    bool coin() { return once_in(2); }
    // In [low, high), in steps of 2^-24 of the range: exact products and sums on every machine.
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(m_engine() >> 40) * 0x1p-24f);
    }
    std::uint8_t byte() { return static_cast<std::uint8_t>(m_engine() >> 56); }
    template <class T, std::size_t kCount>
    T one_of(const T (&values)[kCount]) {
        return values[below(static_cast<int>(kCount))];
    }

  private:
    std::mt19937_64 m_engine;
};

}  // namespace terrazzo::stress
