// Reading rows that cross bins and tiles: raw pixels are brought together first and converted then.
#include "raster/target/read_row.h"

#include <algorithm>
#include <cstring>

#include "raster/target/mean_of_samples.h"

namespace terrazzo::raster {
namespace {

struct Rgba8 {
    uint8_t components[4];
};
struct Rgba16 {
    uint16_t components[4];
};
struct Rgba32F {
    float components[4];
};

// Pixels of one row of a bin, from column `x` of the bin on.
template <typename Pixel>
void copy_bin_row(const Pixel* plane, int x, int row, int count, Pixel* out) {
    const Pixel* tile_row = plane + pixel_index(0, row);
    const int head = std::min(count, (kTileSize - x % kTileSize) % kTileSize);
    std::copy_n(plane + pixel_index(x, row), head, out);
    int i = head;
    for (; i + kTileSize <= count; i += kTileSize) {
        std::copy_n(tile_row + (x + i) / kTileSize * kTilePixels, kTileSize, out + i);
    }
    std::copy_n(tile_row + (x + i) / kTileSize * kTilePixels, count - i, out + i);
}

// A row bin by bin. `plane(bin, row)` points to the bin's pixels, of which those of one row are looked at.
template <typename Pixel, typename Plane>
void copy_row(Target& target, Plane plane, int x, int row, int count, Pixel* out) {
    for (const int end = x + count; x < end;) {
        const int columns = std::min(end - x, kBinSize - x % kBinSize);
        const int index = row / kBinSize * target.bins_across() + x / kBinSize;
        target.materialize_to_read(index);
        copy_bin_row(static_cast<const Pixel*>(plane(target.bin(index), row % kBinSize)), x % kBinSize,
                     row % kBinSize, columns, out);
        x += columns;
        out += columns;
    }
}

template <typename Pixel>
[[gnu::noinline]] void copy_resolved(Target& target, int x, int row, int count, Pixel* out) {
    ResolvedPixels pixels;
    const auto plane = [&](const Bin& bin, int bin_row) {
        resolve_samples(bin, target.format().color, bin_row / kTileSize * kTilesAcross, kTilesAcross, pixels);
        return reinterpret_cast<const Pixel*>(pixels.bytes);
    };
    copy_row(target, plane, x, row, count, out);
}

template <typename Pixel>
void copy_color(Target& target, int x, int row, int count, Pixel* out) {
    if (target.format().samples > 1) return copy_resolved(target, x, row, count, out);
    const auto plane = [](const Bin& bin, int) { return reinterpret_cast<const Pixel*>(bin.color); };
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

// Means of samples, which have their fractions.
void read_means(Target& target, int x, int row, int count, float* rgba) {
    for (const int end = x + count; x < end;) {
        const int index = row / kBinSize * target.bins_across() + x / kBinSize;
        target.materialize_to_read(index);
        const Bin bin = target.bin(index);
        for (const int last = std::min(end, bin.x + kBinSize); x < last; ++x, rgba += 4) {
            float mean[4];
            mean_of_samples(bin, target.format().color, pixel_index(x - bin.x, row % kBinSize), mean);
            std::copy_n(mean, 4, rgba);
        }
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
    copy_color(target, x, row, count, reinterpret_cast<Rgba8*>(rgba));
    if (!target.format().has_alpha) set_alpha<uint8_t>(rgba, count, 255);
}

void read_color_float(Target& target, int x, int row, int count, float* rgba) {
    if (target.format().samples > 1) {
        read_means(target, x, row, count, rgba);
        if (!target.format().has_alpha) set_alpha(rgba, count, 1.0f);
        return;
    }
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
        target, [](const Bin& bin, int) { return bin.depth; }, x, row, count, depths);
}

void read_stencil(Target& target, int x, int row, int count, uint8_t* stencils) {
    copy_row(
        target, [](const Bin& bin, int) { return bin.stencil; }, x, row, count, stencils);
}

}  // namespace terrazzo::raster
