// The order of components in a pixel: between client pixels or texels and R, G, B, A.
//
// Orders are template arguments, so that each loop is a fixed shuffle that the compiler turns into vector
// code.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terrazzo::gl {

// Where each of R, G, B, A comes from: a component of the source or a constant.
using Channels = std::array<uint8_t, 4>;
inline constexpr uint8_t kZero = 4, kOne = 5;

template <int kComponents, Channels kChannels, typename T>
void spread(const T* __restrict source, T one, int count, T* __restrict rgba) {
    for (int i = 0; i < count; ++i) {
        for (size_t c = 0; c < 4; ++c) {
            const uint8_t from = kChannels[c];
            rgba[4 * i + static_cast<int>(c)] = from == kZero  ? T{0}
                                                : from == kOne ? one
                                                               : source[kComponents * i + from];
        }
    }
}

// The other way: component j of the destination is channel kSources[j].
template <int kComponents, Channels kSources, typename T>
void gather(const T* __restrict rgba, int count, T* __restrict components) {
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < kComponents; ++j) {
            components[kComponents * i + j] = rgba[4 * i + kSources[static_cast<size_t>(j)]];
        }
    }
}

}  // namespace terrazzo::gl
