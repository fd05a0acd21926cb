// Clears within one bin; see clear.h.
#include "raster/clear.h"

#include <algorithm>
#include <cstring>

#include "raster/color_format.h"

namespace terrazzo::raster {

namespace {

void clear_color(const BinClear& clear, ColorFormat format, std::byte* pixel) {
    const size_t size = static_cast<size_t>(bytes_per_pixel(format));
    std::byte value[16];
    encode_color(format, clear.values.color, value);
    if (format == ColorFormat::kRgb565) {
        static constexpr uint16_t kChannel[4] = {0xf800, 0x07e0, 0x001f, 0};
        uint16_t mask = 0, old, wanted;
        for (int c = 0; c < 4; ++c) mask |= clear.color_mask >> c & 1 ? kChannel[c] : 0;
        std::memcpy(&old, pixel, 2), std::memcpy(&wanted, value, 2);
        old = static_cast<uint16_t>((old & ~mask) | (wanted & mask));
        std::memcpy(pixel, &old, 2);
        return;
    }
    const size_t channel = size / 4;
    for (size_t c = 0; c < 4; ++c)
        if (clear.color_mask >> c & 1) std::memcpy(pixel + c * channel, value + c * channel, channel);
}

}  // namespace

bool clears_whole_bin(const BinClear& clear, const Target& target, int bin_x, int bin_y) {
    const bool covered = clear.x0 <= bin_x && clear.y0 <= bin_y &&
                         clear.x1 >= std::min(bin_x + kBinSize, target.width()) &&
                         clear.y1 >= std::min(bin_y + kBinSize, target.height());
    return covered && (!clear.planes.color || clear.color_mask == 0xf) &&
           (!clear.planes.stencil || clear.stencil_mask == 0xff);
}

void clear_bin(const BinClear& clear, Target& target, int index) {
    const Bin bin = target.bin(index);
    if (clears_whole_bin(clear, target, bin.x, bin.y)) {
        target.clear_bin(index, clear.planes, clear.values);
        return;
    }
    target.materialize(index);
    const ColorFormat format = target.format().color;
    for (int y = std::max<int>(clear.y0 - bin.y, 0); y < std::min<int>(clear.y1 - bin.y, kBinSize); ++y) {
        for (int x = std::max<int>(clear.x0 - bin.x, 0); x < std::min<int>(clear.x1 - bin.x, kBinSize); ++x) {
            const size_t i = static_cast<size_t>(pixel_index(x, y));
            if (clear.planes.color)
                clear_color(clear, format, bin.color + i * static_cast<size_t>(bytes_per_pixel(format)));
            if (clear.planes.depth && bin.depth) bin.depth[i] = clear.values.depth;
            if (clear.planes.stencil && bin.stencil)
                bin.stencil[i] = static_cast<uint8_t>((bin.stencil[i] & ~clear.stencil_mask) |
                                                      (clear.values.stencil & clear.stencil_mask));
        }
    }
    if (clear.planes.depth) target.forget_farthest(index);
}

}  // namespace terrazzo::raster
