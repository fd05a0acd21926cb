// The formats of what is stored: colours of render targets, texels of images.
#pragma once

#include <cstdint>

namespace terrazzo::raster {

// How colour lies in a tile: see Target.
enum class ColorFormat : uint8_t { kRgba8, kRgb565, kRgba16, kRgba32F };

[[gnu::always_inline]] constexpr int bytes_per_pixel(ColorFormat format) {
    switch (format) {
        case ColorFormat::kRgba8:
            return 4;
        case ColorFormat::kRgb565:
            return 2;
        case ColorFormat::kRgba16:
            return 8;
        case ColorFormat::kRgba32F:
            return 16;
    }
    return 0;
}

// How texels lie in memory: four bytes R, G, B, A for every internal format of at most 8 bits a component, or
// four floats; depths are unsigned integers of 16, 24 or 32 bits, four bytes each.
enum class TexelStorage : uint8_t { kRgba8, kRgba32F, kDepth };

// Which channels a texture's base internal format has (GL 1.5 table 3.15).
enum class BaseFormat : uint8_t { kAlpha, kLuminance, kLuminanceAlpha, kIntensity, kRgb, kRgba, kDepth };

}  // namespace terrazzo::raster
