// Reading rows that cross bins and tiles: raw pixels are brought together first and converted then.
#include "pipeline/read_row.h"

#include <algorithm>
#include <cstring>

namespace terrazzo::pipeline {
namespace {

using raster::Bin;
using raster::ColorFormat;
using raster::kBinSize;
using raster::kTilePixels;
using raster::kTileSize;
using raster::Target;

struct Rgba16 {
    uint16_t components[4];
};
struct Rgba32F {
    float components[4];
};

// Pixels of one row of a bin, from column `x` of the bin on.
template <typename Pixel>
void copy_bin_row(const Pixel* plane, int x, int row, int count, Pixel* out) {
    const Pixel* tile_row = plane + raster::pixel_index(0, row);
    const int head = std::min(count, (kTileSize - x % kTileSize) % kTileSize);
    std::copy_n(plane + raster::pixel_index(x, row), head, out);
    int i = head;
    for (; i + kTileSize <= count; i += kTileSize) {
        std::copy_n(tile_row + (x + i) / kTileSize * kTilePixels, kTileSize, out + i);
    }
    std::copy_n(tile_row + (x + i) / kTileSize * kTilePixels, count - i, out + i);
}

// `plane(bin)` points to the bin's pixels.
template <typename Pixel, typename Plane>
void copy_row(Target& target, Plane plane, int x, int row, int count, Pixel* out) {
    for (int done = 0; done < count;) {
        const int column = x + done;
        const int index = row / kBinSize * target.bins_across() + column / kBinSize;
        const int run = std::min(count - done, kBinSize - column % kBinSize);
        target.materialize(index);
        copy_bin_row<Pixel>(plane(target.bin(index)), column % kBinSize, row % kBinSize, run, out + done);
        done += run;
    }
}

template <typename Pixel>
void copy_color(Target& target, int x, int row, int count, Pixel* out) {
    const auto plane = [](const Bin& bin) { return reinterpret_cast<const Pixel*>(bin.color); };
    copy_row(target, plane, x, row, count, out);
}

// Wide pixels need room: rows are read in pieces of this many.
constexpr int kPiece = 64;

void expand_565(const uint16_t* pixels, int count, uint8_t* rgba) {
    for (int i = 0; i < count; ++i, rgba += 4) {
        const unsigned red = pixels[i] >> 11 & 31u, green = pixels[i] >> 5 & 63u, blue = pixels[i] & 31u;
        rgba[0] = static_cast<uint8_t>(red << 3 | red >> 2);
        rgba[1] = static_cast<uint8_t>(green << 2 | green >> 4);
        rgba[2] = static_cast<uint8_t>(blue << 3 | blue >> 2);
        rgba[3] = 255;
    }
}

void widen(const uint16_t* pixels, int count, float* rgba) {
    for (int i = 0; i < count; ++i, rgba += 4) {
        rgba[0] = static_cast<float>(pixels[i] >> 11 & 31) * (1.0f / 31.0f);
        rgba[1] = static_cast<float>(pixels[i] >> 5 & 63) * (1.0f / 63.0f);
        rgba[2] = static_cast<float>(pixels[i] & 31) * (1.0f / 31.0f);
        rgba[3] = 1.0f;
    }
}

void widen(const uint32_t* pixels, int count, float* rgba) {
    const auto* bytes = reinterpret_cast<const uint8_t*>(pixels);
    for (int i = 0; i < 4 * count; ++i) rgba[i] = static_cast<float>(bytes[i]) * (1.0f / 255.0f);
}

void widen(const Rgba16* pixels, int count, float* rgba) {
    const uint16_t* components = pixels->components;
    for (int i = 0; i < 4 * count; ++i) rgba[i] = static_cast<float>(components[i]) * (1.0f / 65535.0f);
}

void widen(const Rgba32F* pixels, int count, float* rgba) {
    std::copy_n(pixels->components, 4 * count, rgba);
}

template <typename Pixel>
void read_widened(Target& target, int x, int row, int count, float* rgba) {
    Pixel pixels[kPiece];
    for (int i = 0; i < count; i += kPiece) {
        const int piece = std::min(kPiece, count - i);
        copy_color(target, x + i, row, piece, pixels);
        widen(pixels, piece, rgba + 4 * i);
    }
}

template <typename T>
void set_alpha(T* rgba, int count, T one) {
    for (int i = 0; i < count; ++i) rgba[4 * i + 3] = one;
}

}  // namespace

void read_color_rgba8(Target& target, int x, int row, int count, uint8_t* rgba) {
    if (target.format().color == ColorFormat::kRgb565) {
        uint16_t pixels[kPiece];
        for (int i = 0; i < count; i += kPiece) {
            const int piece = std::min(kPiece, count - i);
            copy_color(target, x + i, row, piece, pixels);
            expand_565(pixels, piece, rgba + 4 * i);
        }
        return;
    }
    struct Rgba8 {
        uint8_t components[4];
    };
    copy_color(target, x, row, count, reinterpret_cast<Rgba8*>(rgba));
    if (!target.format().has_alpha) set_alpha<uint8_t>(rgba, count, 255);
}

void read_color_float(Target& target, int x, int row, int count, float* rgba) {
    switch (target.format().color) {
        case ColorFormat::kRgba8:
            read_widened<uint32_t>(target, x, row, count, rgba);
            break;
        case ColorFormat::kRgb565:
            read_widened<uint16_t>(target, x, row, count, rgba);
            break;
        case ColorFormat::kRgba16:
            read_widened<Rgba16>(target, x, row, count, rgba);
            break;
        case ColorFormat::kRgba32F:
            read_widened<Rgba32F>(target, x, row, count, rgba);
            break;
    }
    if (!target.format().has_alpha) set_alpha(rgba, count, 1.0f);
}

void read_depth(Target& target, int x, int row, int count, uint32_t* depths) {
    copy_row(
        target, [](const Bin& bin) { return bin.depth; }, x, row, count, depths);
}

void read_stencil(Target& target, int x, int row, int count, uint8_t* stencils) {
    copy_row(
        target, [](const Bin& bin) { return bin.stencil; }, x, row, count, stencils);
}

}  // namespace terrazzo::pipeline
