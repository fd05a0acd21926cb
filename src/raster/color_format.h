// Colours of one pixel in each ColorFormat, for clears and read-back: the kernels have their own wide
// versions in pixel/write.h that give the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "raster/state.h"

namespace terrazzo::raster {

// f in [0, 1] to n bits, round to nearest; below 0 and NaN to 0, above 1 to the maximum.
inline uint32_t float_to_unorm(float f, uint32_t maximum) {
    if (!(f > 0)) return 0;
    if (f >= 1) return maximum;
    return static_cast<uint32_t>(std::lrintf(f * static_cast<float>(maximum)));
}

inline void encode_color(ColorFormat format, const float color[4], std::byte* out) {
    switch (format) {
        case ColorFormat::kRgba8: {
            for (int c = 0; c < 4; ++c) out[c] = static_cast<std::byte>(float_to_unorm(color[c], 255));
            return;
        }
        case ColorFormat::kRgb565: {
            const uint16_t packed =
                static_cast<uint16_t>(float_to_unorm(color[0], 31) << 11 | float_to_unorm(color[1], 63) << 5 |
                                      float_to_unorm(color[2], 31));
            std::memcpy(out, &packed, sizeof packed);
            return;
        }
        case ColorFormat::kRgba16: {
            uint16_t packed[4];
            for (int c = 0; c < 4; ++c) packed[c] = static_cast<uint16_t>(float_to_unorm(color[c], 65535));
            std::memcpy(out, packed, sizeof packed);
            return;
        }
        case ColorFormat::kRgba32F:
            std::memcpy(out, color, 4 * sizeof(float));
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
