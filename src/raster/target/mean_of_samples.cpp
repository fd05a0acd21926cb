// Means of samples: bytes by the kernels, other formats one pixel at a time through floats as the reference's
// blit has it.
#include "raster/target/mean_of_samples.h"

#include <cstdint>

#include "raster/target/color_format.h"
#include "raster/target/plane_kernels.h"

namespace terrazzo::raster {

void mean_of_samples(const Bin& bin, ColorFormat format, int pixel, float (&rgba)[4]) {
    const int size = bytes_per_pixel(format);
    const std::byte* const first = bin.color + pixel * size;
    decode_color(format, first, rgba);
    if (bin.color_alike[pixel / kTilePixels]) return;
    for (int s = 1; s < kMaxSamples; ++s) {
        float color[4] = {};
        decode_color(format, first + s * kBinPixels * size, color);
        for (int c = 0; c < 4; ++c) rgba[c] += color[c];
    }
    for (float& c : rgba) c *= 1.0f / kMaxSamples;
}

void resolve_samples(const Bin& bin, ColorFormat format, int first_tile, int tile_count, ResolvedPixels& to) {
    const auto first_pixel = static_cast<std::size_t>(first_tile) * kTilePixels;
    if (format == ColorFormat::kRgba8) {
        plane_kernels().resolve_rgba8(reinterpret_cast<const uint32_t*>(bin.color) + first_pixel,
                                      bin.color_alike + first_tile, tile_count,
                                      reinterpret_cast<uint32_t*>(to.bytes) + first_pixel);
        return;
    }
    const int size = bytes_per_pixel(format);
    for (int pixel = first_tile * kTilePixels; pixel < (first_tile + tile_count) * kTilePixels; ++pixel) {
        float mean[4];
        mean_of_samples(bin, format, pixel, mean);
        round_as_drawn(format, mean);
        encode_color(format, mean, to.bytes + pixel * size);
    }
}

}  // namespace terrazzo::raster
