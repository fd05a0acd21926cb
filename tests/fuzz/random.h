// The fuzzer's choices. Input: a seed, a thread and the index of a call. Output: numbers that depend on these
// three alone, so that a call makes the same choices when others are left out.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <iterator>

namespace terrazzo::fuzz {

class Random {
  public:
    Random(std::uint64_t seed, unsigned thread, std::uint64_t index)
        : m_state(mixed(mixed(mixed(seed) + thread) + index)) {}

    std::uint64_t bits() { return mixed(m_state += kStep); }
    // 0 to count - 1.
    unsigned below(unsigned count) { return static_cast<unsigned>((bits() >> 32) * count >> 32); }
    bool one_in(unsigned count) { return below(count) == 0; }
    int between(int low, int high) {
        return low + static_cast<int>(below(static_cast<unsigned>(high - low) + 1));
    }

    template <typename T>
    T of(std::initializer_list<T> values) {
        return std::data(values)[below(static_cast<unsigned>(values.size()))];
    }
    template <typename List>
    auto& one_of(List& list) {
        return *(std::begin(list) + below(static_cast<unsigned>(std::size(list))));
    }

  private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;

    // Every bit of the result depends on every bit of the argument.
    static std::uint64_t mixed(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    std::uint64_t m_state;
};

}  // namespace terrazzo::fuzz
