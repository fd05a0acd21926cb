// Stage: benchmark of states, what was drawn. Input: client buffers of two libraries. Output: how many of
// their values differ. Invariant: alpha counts like a colour; a buffer with coarser steps than 1/255 is
// compared in its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "states/state.h"

namespace terrazzo::bench {

struct PictureDifference {
    double share = 0;    // of the values, by more than a step
    double largest = 0;  // in 255ths
};

// The buffer's values, each scaled to 255, row by row.
std::vector<float> values_of(const states::State& state, const std::vector<std::uint8_t>& bytes);
PictureDifference difference(const states::State& state, const std::vector<std::uint8_t>& a,
                             const std::vector<std::uint8_t>& b);
// True when all pixels are the same: nothing is seen.
bool is_uniform(const states::State& state, const std::vector<std::uint8_t>& bytes);

}  // namespace terrazzo::bench
