// What a render target consists of, in the pipeline's terms.
//
// Row 0 is the bottom row. Planes with 0 bits do not exist: tests against them pass and writes are dropped.
#pragma once

namespace terrazzo::pipeline {

enum class ColorFormat { kRgba8, kRgba16, kRgba32Float, kRgb565 };

struct RenderTargetDesc {
    int width = 0;
    int height = 0;
    ColorFormat color_format = ColorFormat::kRgba8;
    int depth_bits = 0;    // 0, 16 or 24
    int stencil_bits = 0;  // 0 or 8

    bool operator==(const RenderTargetDesc&) const = default;
};

}  // namespace terrazzo::pipeline
