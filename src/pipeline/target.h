// What a render target consists of, and how its pixels are laid out when they are handed out.
#pragma once

namespace terrazzo::pipeline {

enum class ColorFormat { kRgba8, kRgba16, kRgba32Float, kRgb565 };

// Planes with 0 bits do not exist: tests against them pass and writes are dropped.
struct RenderTargetDesc {
    int width = 0;
    int height = 0;
    ColorFormat color_format = ColorFormat::kRgba8;
    bool has_alpha = true;  // without, alpha reads as 1 whatever is written
    int depth_bits = 0;     // 0, 16 or 24
    int stencil_bits = 0;   // 0 or 8

    bool operator==(const RenderTargetDesc&) const = default;
};

// Pixels in a window system's memory; components are named in the order of their addresses, of the host's byte order.
enum class PixelLayout {
    kRgba8,
    kBgra8,
    kArgb8,
    kRgb8,
    kRgba16,
    kRgb16,
    kRgba32Float,
    kRgb32Float,
    kRgb565,           // one 16-bit word, red highest
    kDepth16,          // one 16-bit word
    kDepth24Stencil8,  // one 32-bit word, stencil highest
};

constexpr int bytes_per_pixel(PixelLayout layout) {
    switch (layout) {
        case PixelLayout::kRgba8:
        case PixelLayout::kBgra8:
        case PixelLayout::kArgb8:
        case PixelLayout::kDepth24Stencil8: return 4;
        case PixelLayout::kRgb8: return 3;
        case PixelLayout::kRgba16: return 8;
        case PixelLayout::kRgb16: return 6;
        case PixelLayout::kRgba32Float: return 16;
        case PixelLayout::kRgb32Float: return 12;
        case PixelLayout::kRgb565:
        case PixelLayout::kDepth16: return 2;
    }
    return 0;
}

}  // namespace terrazzo::pipeline
