// Writing rows, a bin's share at a time.
#include "pipeline/write_row.h"

#include <algorithm>
#include <cstring>

#include "raster/color_format.h"

namespace terrazzo::pipeline {

using raster::Bin;
using raster::kBinSize;
using raster::Target;

namespace {

// Calls store(bin, index of the pixel in the bin, number of the pixel in the row) for each pixel.
template <typename Store>
void for_each_pixel(Target& target, int x, int row, int count, Store store) {
    for (int i = 0; i < count;) {
        const int index = row / kBinSize * target.bins_across() + (x + i) / kBinSize;
        target.materialize(index);
        const Bin bin = target.bin(index);
        const int end = std::min(count, i + kBinSize - (x + i) % kBinSize);
        for (; i < end; ++i)
            store(bin, static_cast<size_t>(raster::pixel_index((x + i) % kBinSize, row % kBinSize)), i);
    }
}

}  // namespace

void write_color(Target& target, int x, int row, int count, const float* rgba) {
    const raster::ColorFormat format = target.format().color;
    const auto size = static_cast<size_t>(raster::bytes_per_pixel(format));
    for_each_pixel(target, x, row, count, [&](const Bin& bin, size_t at, int i) {
        float color[4];
        std::copy_n(rgba + 4 * i, 4, color);
        raster::round_as_drawn(format, color);
        raster::encode_color(format, color, bin.color + at * size);
    });
}

void write_color_rgba8(Target& target, int x, int row, int count, const uint8_t* rgba) {
    if (target.format().color == raster::ColorFormat::kRgba8) {
        for_each_pixel(target, x, row, count, [&](const Bin& bin, size_t at, int i) {
            std::memcpy(bin.color + 4 * at, rgba + 4 * i, 4);
        });
        return;
    }
    for (int i = 0; i < count; ++i) {
        float color[4];
        for (int c = 0; c < 4; ++c) color[c] = static_cast<float>(rgba[4 * i + c]) * (1.0f / 255.0f);
        write_color(target, x + i, row, 1, color);
    }
}

void write_depth(Target& target, int x, int row, int count, const uint32_t* depths) {
    for_each_pixel(target, x, row, count,
                   [&](const Bin& bin, size_t at, int i) { bin.depth[at] = depths[i]; });
    for (int column = x / kBinSize; column <= (x + count - 1) / kBinSize; ++column)
        target.forget_farthest(row / kBinSize * target.bins_across() + column);
}

void write_stencil(Target& target, int x, int row, int count, const uint8_t* stencils) {
    for_each_pixel(target, x, row, count,
                   [&](const Bin& bin, size_t at, int i) { bin.stencil[at] = stencils[i]; });
}

}  // namespace terrazzo::pipeline
