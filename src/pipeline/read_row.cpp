// Reading rows that cross bins and tiles.
#include "pipeline/read_row.h"

#include <algorithm>
#include <cstring>

namespace terrazzo::pipeline {
namespace {

using raster::Bin;
using raster::ColorFormat;
using raster::kBinSize;
using raster::kTileSize;
using raster::Target;

// Calls `copy(bin, index of the first pixel in the bin's planes, place in the row, pixels)` for each run of
// pixels that are neighbours in memory: at most a tile's width.
template <typename Copy>
void for_each_run(Target& target, int x, int row, int count, Copy copy) {
    int done = 0;
    while (done < count) {
        const int column = x + done;
        const int index = row / kBinSize * target.bins_across() + column / kBinSize;
        target.materialize(index);
        const Bin bin = target.bin(index);
        const int bin_end = std::min(count, done + kBinSize - column % kBinSize);
        while (done < bin_end) {
            const int inside = (x + done) % kBinSize;
            const int run = std::min(kTileSize - inside % kTileSize, bin_end - done);
            copy(bin, raster::pixel_index(inside, row % kBinSize), done, run);
            done += run;
        }
    }
}

struct Rgb565 {
    unsigned red, green, blue;
};

Rgb565 load_565(const std::byte* color, int index) {
    uint16_t pixel;
    std::memcpy(&pixel, color + 2 * index, sizeof pixel);
    return {pixel >> 11 & 31u, pixel >> 5 & 63u, pixel & 31u};
}

void expand_565(const std::byte* color, int index, int count, uint8_t* rgba) {
    for (int i = 0; i < count; ++i, rgba += 4) {
        const Rgb565 pixel = load_565(color, index + i);
        rgba[0] = static_cast<uint8_t>(pixel.red << 3 | pixel.red >> 2);
        rgba[1] = static_cast<uint8_t>(pixel.green << 2 | pixel.green >> 4);
        rgba[2] = static_cast<uint8_t>(pixel.blue << 3 | pixel.blue >> 2);
        rgba[3] = 255;
    }
}

void widen_565(const std::byte* color, int index, int count, float* rgba) {
    for (int i = 0; i < count; ++i, rgba += 4) {
        const Rgb565 pixel = load_565(color, index + i);
        rgba[0] = static_cast<float>(pixel.red) * (1.0f / 31.0f);
        rgba[1] = static_cast<float>(pixel.green) * (1.0f / 63.0f);
        rgba[2] = static_cast<float>(pixel.blue) * (1.0f / 31.0f);
        rgba[3] = 1.0f;
    }
}

template <typename T>
void widen(const std::byte* color, int index, int count, float scale, float* rgba) {
    for (int i = 0; i < 4 * count; ++i) {
        T component;
        std::memcpy(&component, color + sizeof(T) * static_cast<size_t>(4 * index + i), sizeof component);
        rgba[i] = static_cast<float>(component) * scale;
    }
}

template <typename T>
void set_alpha(T* rgba, int count, T one) {
    for (int i = 0; i < count; ++i) rgba[4 * i + 3] = one;
}

}  // namespace

void read_color_rgba8(Target& target, int x, int row, int count, uint8_t* rgba) {
    const bool is_565 = target.format().color == ColorFormat::kRgb565;
    for_each_run(target, x, row, count, [&](const Bin& bin, int index, int at, int run) {
        if (is_565) {
            expand_565(bin.color, index, run, rgba + 4 * at);
        } else {
            std::memcpy(rgba + 4 * at, bin.color + 4 * index, 4 * static_cast<size_t>(run));
        }
    });
    if (!target.format().has_alpha) set_alpha<uint8_t>(rgba, count, 255);
}

void read_color_float(Target& target, int x, int row, int count, float* rgba) {
    for_each_run(target, x, row, count, [&](const Bin& bin, int index, int at, int run) {
        float* out = rgba + 4 * at;
        switch (target.format().color) {
            case ColorFormat::kRgba8:
                return widen<uint8_t>(bin.color, index, run, 1.0f / 255.0f, out);
            case ColorFormat::kRgb565:
                return widen_565(bin.color, index, run, out);
            case ColorFormat::kRgba16:
                return widen<uint16_t>(bin.color, index, run, 1.0f / 65535.0f, out);
            case ColorFormat::kRgba32F:
                return widen<float>(bin.color, index, run, 1.0f, out);
        }
    });
    if (!target.format().has_alpha) set_alpha(rgba, count, 1.0f);
}

void read_depth(Target& target, int x, int row, int count, uint32_t* depths) {
    for_each_run(target, x, row, count, [&](const Bin& bin, int index, int at, int run) {
        std::copy_n(bin.depth + index, run, depths + at);
    });
}

void read_stencil(Target& target, int x, int row, int count, uint8_t* stencils) {
    for_each_run(target, x, row, count, [&](const Bin& bin, int index, int at, int run) {
        std::copy_n(bin.stencil + index, run, stencils + at);
    });
}

}  // namespace terrazzo::pipeline
