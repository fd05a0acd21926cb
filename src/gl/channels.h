// The order of components in a pixel: between client pixels or texels and R, G, B, A.
//
// Orders are template arguments, so that each loop is a fixed shuffle that the compiler turns into vector
// code.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace terrazzo::gl {

// Where each of R, G, B, A comes from: a component of the source or a constant.
using Channels = std::array<uint8_t, 4>;
inline constexpr uint8_t kZero = 4, kOne = 5;

// Bits that byte c of a pixel is shifted by in a word.
constexpr unsigned shift_of_byte(size_t c) {
    return static_cast<unsigned>(std::endian::native == std::endian::little ? 8 * c : 24 - 8 * c);
}

// One byte a pixel, as words: compilers see no vectors in single bytes of it.
template <Channels kChannels>
void spread_bytes(const uint8_t* __restrict source, uint8_t one, int count, uint8_t* __restrict rgba) {
    for (int i = 0; i < count; ++i) {
        uint32_t word = 0;
        for (size_t c = 0; c < 4; ++c) {
            if (kChannels[c] == kZero) continue;
            word |= uint32_t{kChannels[c] == kOne ? one : source[i]} << shift_of_byte(c);
        }
        std::memcpy(rgba + 4 * i, &word, sizeof word);
    }
}

// Four bytes a pixel, as words for the same reason.
template <Channels kChannels>
void spread_words(const uint8_t* __restrict source, uint8_t one, int count, uint8_t* __restrict rgba) {
    for (int i = 0; i < count; ++i) {
        uint32_t from, word = 0;
        std::memcpy(&from, source + 4 * i, sizeof from);
        for (size_t c = 0; c < 4; ++c) {
            if (kChannels[c] == kZero) continue;
            const uint32_t byte = kChannels[c] == kOne ? one : from >> shift_of_byte(kChannels[c]) & 0xff;
            word |= byte << shift_of_byte(c);
        }
        std::memcpy(rgba + 4 * i, &word, sizeof word);
    }
}

template <int kComponents, Channels kChannels, typename T>
void spread(const T* __restrict source, T one, int count, T* __restrict rgba) {
    if constexpr (kComponents == 1 && sizeof(T) == 1)
        return spread_bytes<kChannels>(source, one, count, rgba);
    if constexpr (kComponents == 4 && sizeof(T) == 1)
        return spread_words<kChannels>(source, one, count, rgba);
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
