// Clear colours in each ColorFormat. Drawn colours come from pixel/write.h, which rounds halves otherwise in
// all but the eight-bit formats, as the reference does (doc/reference.md §4).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "raster/target/formats.h"

namespace terrazzo::raster {

// f in [0, 1] to n bits; below 0 and NaN to 0, above 1 to the maximum. Halves go to the even neighbour.
inline uint32_t float_to_unorm(float f, uint32_t maximum) {
    if (!(f > 0)) return 0;
    if (f >= 1) return maximum;
    return static_cast<uint32_t>(std::lrintf(f * static_cast<float>(maximum)));
}
// The same but for halves, which go up: how the reference clears all but eight-bit channels.
inline uint32_t clear_to_unorm(float f, uint32_t maximum) {
    if (!(f > 0)) return 0;
    if (f >= 1) return maximum;
    return static_cast<uint32_t>(f * static_cast<float>(maximum) + 0.5f);
}

// What a fragment of this colour would leave in a buffer of the format.
inline void round_as_drawn(ColorFormat format, float color[4]) {
    if (format == ColorFormat::kRgb565) {
        // By way of eight bits, then cut off (doc/reference.md §4).
        color[0] = static_cast<float>(float_to_unorm(color[0], 255) >> 3) / 31;
        color[1] = static_cast<float>(float_to_unorm(color[1], 255) >> 2) / 63;
        color[2] = static_cast<float>(float_to_unorm(color[2], 255) >> 3) / 31;
    } else if (format == ColorFormat::kRgba16) {
        for (int c = 0; c < 4; ++c) color[c] = static_cast<float>(float_to_unorm(color[c], 65535)) / 65535;
    }
}

inline void encode_color(ColorFormat format, const float color[4], std::byte* out) {
    switch (format) {
        case ColorFormat::kRgba8: {
            for (int c = 0; c < 4; ++c) out[c] = static_cast<std::byte>(float_to_unorm(color[c], 255));
            return;
        }
        case ColorFormat::kRgb565: {
            const uint16_t packed =
                static_cast<uint16_t>(clear_to_unorm(color[0], 31) << 11 | clear_to_unorm(color[1], 63) << 5 |
                                      clear_to_unorm(color[2], 31));
            std::memcpy(out, &packed, sizeof packed);
            return;
        }
        case ColorFormat::kRgba16: {
            uint16_t packed[4];
            for (int c = 0; c < 4; ++c) packed[c] = static_cast<uint16_t>(clear_to_unorm(color[c], 65535));
            std::memcpy(out, packed, sizeof packed);
            return;
        }
        case ColorFormat::kRgba32F:
            std::memcpy(out, color, 4 * sizeof(float));
            return;
    }
}

inline void decode_color(ColorFormat format, const std::byte* pixel, float (&color)[4]) {
    switch (format) {
        case ColorFormat::kRgba8:
            for (int c = 0; c < 4; ++c) color[c] = static_cast<float>(pixel[c]) * (1.0f / 255.0f);
            return;
        case ColorFormat::kRgb565: {
            uint16_t p;
            std::memcpy(&p, pixel, sizeof p);
            color[0] = static_cast<float>(p >> 11) * (1.0f / 31.0f);
            color[1] = static_cast<float>(p >> 5 & 63) * (1.0f / 63.0f);
            color[2] = static_cast<float>(p & 31) * (1.0f / 31.0f);
            color[3] = 1;
            return;
        }
        case ColorFormat::kRgba16: {
            uint16_t channels[4];
            std::memcpy(channels, pixel, sizeof channels);
            for (int c = 0; c < 4; ++c) color[c] = static_cast<float>(channels[c]) * (1.0f / 65535.0f);
            return;
        }
        case ColorFormat::kRgba32F:
            std::memcpy(color, pixel, sizeof color);
            return;
    }
}

// Fills `count` pixels, a multiple of 16 of them at a 64-byte boundary.
inline void fill_color(ColorFormat format, const float color[4], std::byte* out, size_t count) {
    std::byte pixel[16];
    encode_color(format, color, pixel);
    uint32_t words[4];
    switch (format) {
        case ColorFormat::kRgba8:
            std::memcpy(words, pixel, 4);
            break;
        case ColorFormat::kRgb565:
            std::memcpy(words, pixel, 2), std::memcpy(reinterpret_cast<std::byte*>(words) + 2, pixel, 2);
            break;
        case ColorFormat::kRgba16:
            std::memcpy(words, pixel, 8);
            break;
        case ColorFormat::kRgba32F:
            std::memcpy(words, pixel, 16);
            break;
    }
    const size_t bytes = count * (format == ColorFormat::kRgba8    ? 4
                                  : format == ColorFormat::kRgb565 ? 2
                                  : format == ColorFormat::kRgba16 ? 8
                                                                   : 16);
    const size_t period = format == ColorFormat::kRgba32F ? 4 : format == ColorFormat::kRgba16 ? 2 : 1;
    uint32_t* const to = reinterpret_cast<uint32_t*>(out);
    for (size_t i = 0; i < bytes / 4; i += period)
        for (size_t k = 0; k < period; ++k) to[i + k] = words[k];
}

}  // namespace terrazzo::raster
