// Writing rows, a bin's share at a time.
#include "raster/target/write_row.h"

#include <algorithm>
#include <cstring>

#include "raster/target/color_format.h"

namespace terrazzo::raster {

namespace {

// Calls store(bin, index of the pixel in the bin, number of the pixel in the row) for each sample of each
// pixel.
template <typename Store>
void for_each_pixel(Target& target, int x, int row, int count, Store store) {
    for (int i = 0; i < count;) {
        const int index = row / kBinSize * target.bins_across() + (x + i) / kBinSize;
        target.materialize(index);
        const Bin bin = target.bin(index);
        const int end = std::min(count, i + kBinSize - (x + i) % kBinSize);
        for (int sample = 0; sample < target.format().samples; ++sample) {
            const Bin planes = planes_of_sample(bin, sample, target.format().color);
            for (int k = i; k < end; ++k)
                store(planes, static_cast<size_t>(pixel_index((x + k) % kBinSize, row % kBinSize)), k);
        }
        i = end;
    }
}

// A pixel in its bin.
struct PlacedPixel {
    explicit PlacedPixel(const PixelPlace& place)
        : index(place.row / kBinSize * place.target.bins_across() + place.x / kBinSize),
          bin(materialized(place.target, index)),
          format(place.target.format().color),
          pixel(pixel_index(place.x % kBinSize, place.row % kBinSize)) {}

    static Bin materialized(Target& target, int index) {
        target.materialize(index);
        return target.bin(index);
    }
    int tile() const { return pixel / kTilePixels; }
    std::byte* color(int sample) const {
        return planes_of_sample(bin, sample, format).color + pixel * bytes_per_pixel(format);
    }

    int index;
    Bin bin;
    ColorFormat format;
    int pixel;
};

// From plane to plane; a tile that is to have samples of its own gets them first.
template <typename Value>
void copy_plane(const PlacedPixel& a, const Value* from, const uint8_t* from_alike, const PlacedPixel& b,
                Value* to, uint8_t* to_alike) {
    const bool alike = from_alike[a.tile()] != 0;
    if (!alike) spread_tile(to, b.tile(), sizeof(Value), to_alike);
    for (int s = 0; s < kMaxSamples; ++s)
        to[s * kBinPixels + b.pixel] = from[(alike ? 0 : s) * kBinPixels + a.pixel];
}

}  // namespace

void write_color(Target& target, int x, int row, int count, const float* rgba) {
    const ColorFormat format = target.format().color;
    const auto size = static_cast<size_t>(bytes_per_pixel(format));
    for_each_pixel(target, x, row, count, [&](const Bin& bin, size_t at, int i) {
        float color[4];
        std::copy_n(rgba + 4 * i, 4, color);
        round_as_drawn(format, color);
        encode_color(format, color, bin.color + at * size);
    });
}

void write_color_rgba8(Target& target, int x, int row, int count, const uint8_t* rgba) {
    if (target.format().color == ColorFormat::kRgba8) {
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

void copy_samples(const PixelPlace& from, const PixelPlace& to, ClearPlanes planes) {
    const PlacedPixel a(from), b(to);
    if (planes.color) {
        const bool alike = a.bin.color_alike[a.tile()] != 0;
        if (!alike)
            spread_tile(b.bin.color, b.tile(), static_cast<size_t>(bytes_per_pixel(b.format)),
                        b.bin.color_alike);
        for (int s = 0; s < kMaxSamples; ++s) {
            float color[4];
            decode_color(a.format, a.color(alike ? 0 : s), color);
            if (a.format != b.format) round_as_drawn(b.format, color);
            encode_color(b.format, color, b.color(s));
        }
    }
    if (planes.depth) {
        copy_plane(a, a.bin.depth, a.bin.depth_alike, b, b.bin.depth, b.bin.depth_alike);
        to.target.forget_farthest(b.index);
    }
    if (planes.stencil)
        copy_plane(a, a.bin.stencil, a.bin.stencil_alike, b, b.bin.stencil, b.bin.stencil_alike);
}

}  // namespace terrazzo::raster
