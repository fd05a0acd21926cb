// Trials of colours: one function draws random state over a GL function table, once with our library and once
// with the reference, and the two colour buffers are compared.
//
// Input: a current context cleared to kClear. Output: the colour buffer. Invariant: what a trial draws
// depends on its seed alone, and it leaves no GL error.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "kit/offscreen.h"

namespace terrazzo::test {

using kit::Gl;

inline constexpr float kClear = 0.3125f;
inline constexpr int kTrialSize = 64;  // pixels each way

// Random numbers with names for what they are used for.
class Dice {
  public:
    explicit Dice(unsigned seed) : m_random(seed) {}

    float number(float low, float high) {
        return low + (high - low) * (static_cast<float>(m_random() >> 8) * (1.0f / 16777216.0f));
    }
    int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    bool chance() { return pick(2) == 0; }
    template <typename Value>
    Value one_of(std::initializer_list<Value> values) {
        return values.begin()[pick(static_cast<int>(values.size()))];
    }
    template <std::size_t count>
    std::array<float, count> numbers(float low, float high) {
        std::array<float, count> values;
        std::generate(values.begin(), values.end(), [&] { return number(low, high); });
        return values;
    }

  private:
    std::mt19937 m_random;
};

// How far the two may be apart. `steps` are 1/255; pixels further apart than `steps` count as different.
struct Bound {
    double steps = 0;
    double differing_share = 0;  // of the pixels drawn
    double largest = 0;          // steps that no pixel may exceed
};

struct Trial {
    const char* name;
    void (*draw)(const Gl&, Dice&);
    int seeds;
    Bound bound;
    GLenum type = GL_FLOAT;  // of the colour buffer
    GLenum format = OSMESA_RGBA;
};

// All trials, by the file that defines them.
std::vector<Trial> lighting_trials();
std::vector<Trial> fragment_trials();
std::vector<Trial> combine_trials();

}  // namespace terrazzo::test
