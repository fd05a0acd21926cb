// Clears within one bin; see clear.h.
#include "raster/target/clear.h"

#include <algorithm>
#include <cstring>

#include "raster/target/color_format.h"

namespace terrazzo::raster {

namespace {

// A clear as bits of one pixel: the new ones, and which of them count.
template <class Word, size_t kWords>
struct PixelBits {
    Word value[kWords], mask[kWords];

    void store(Word* pixel) const {
        for (size_t w = 0; w < kWords; ++w) pixel[w] = (pixel[w] & static_cast<Word>(~mask[w])) | value[w];
    }
};

// A bin's pixels from (x0, y0) up to, not including, (x1, y1).
struct BinRect {
    int x0, y0, x1, y1;

    bool is_whole_bin() const { return x0 == 0 && y0 == 0 && x1 == kBinSize && y1 == kBinSize; }
};

template <class Word, size_t kWords>
void clear_plane(const PixelBits<Word, kWords>& bits, const BinRect& rect, void* plane) {
    Word* const words = static_cast<Word*>(plane);
    if (rect.is_whole_bin()) {
        for (size_t i = 0; i < kBinPixels; ++i) bits.store(words + i * kWords);
        return;
    }
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
            bits.store(words + static_cast<size_t>(pixel_index(x, y)) * kWords);
}

// The bits of a format's channels that a colour mask lets through, as bytes of a pixel.
void spread_color_mask(ColorFormat format, uint8_t color_mask, std::byte* pixel) {
    const size_t size = static_cast<size_t>(bytes_per_pixel(format));
    std::memset(pixel, 0, size);
    if (format == ColorFormat::kRgb565) {
        static constexpr uint16_t kChannel[3] = {0xf800, 0x07e0, 0x001f};
        uint16_t mask = 0;
        for (int c = 0; c < 3; ++c)
            mask = static_cast<uint16_t>(mask | (color_mask >> c & 1 ? kChannel[c] : 0));
        std::memcpy(pixel, &mask, sizeof mask);
        return;
    }
    for (size_t c = 0; c < 4; ++c)
        if (color_mask >> c & 1) std::memset(pixel + c * (size / 4), 0xff, size / 4);
}

template <class Word, size_t kWords>
void clear_color(const BinClear& clear, ColorFormat format, const BinRect& rect, void* plane) {
    std::byte value[16], mask[16];
    encode_color(format, clear.values.color, value);
    spread_color_mask(format, clear.color_mask, mask);
    PixelBits<Word, kWords> bits;
    std::memcpy(bits.value, value, sizeof bits.value);
    std::memcpy(bits.mask, mask, sizeof bits.mask);
    for (size_t w = 0; w < kWords; ++w) bits.value[w] = static_cast<Word>(bits.value[w] & bits.mask[w]);
    clear_plane(bits, rect, plane);
}

void clear_color(const BinClear& clear, ColorFormat format, const BinRect& rect, void* plane) {
    switch (format) {
        case ColorFormat::kRgb565:
            return clear_color<uint16_t, 1>(clear, format, rect, plane);
        case ColorFormat::kRgba8:
            return clear_color<uint32_t, 1>(clear, format, rect, plane);
        case ColorFormat::kRgba16:
            return clear_color<uint64_t, 1>(clear, format, rect, plane);
        case ColorFormat::kRgba32F:
            return clear_color<uint64_t, 2>(clear, format, rect, plane);
    }
}

}  // namespace

bool clears_whole_bin(const BinClear& clear, const Target& target, int bin_x, int bin_y) {
    const auto end = [&](int bin, int size) {
        return target.is_part() ? bin + kBinSize : std::min(bin + kBinSize, size);
    };
    const bool covered = clear.x0 <= bin_x && clear.y0 <= bin_y && clear.x1 >= end(bin_x, target.width()) &&
                         clear.y1 >= end(bin_y, target.height());
    return covered && (!clear.planes.color || clear.color_mask == 0xf) &&
           (!clear.planes.stencil || clear.stencil_mask == 0xff);
}

bool clears_whole_target(const BinClear& clear, const Target& target) {
    const int right = (target.bins_across() - 1) * kBinSize, low = (target.bins_up() - 1) * kBinSize;
    return clears_whole_bin(clear, target, 0, 0) && clears_whole_bin(clear, target, right, low);
}

void join(const BinClear& later, BinClear& first) {
    if (later.planes.color) {
        first.planes.color = true;
        std::copy_n(later.values.color, 4, first.values.color);
    }
    if (later.planes.depth) {
        first.planes.depth = true;
        first.values.depth = later.values.depth;
    }
    if (later.planes.stencil) {
        first.planes.stencil = true;
        first.values.stencil = later.values.stencil;
    }
}

void clear_bin(const BinClear& clear, Target& target, int index) {
    const Bin bin = target.bin(index);
    if (clears_whole_bin(clear, target, bin.x, bin.y)) {
        target.clear_bin(index, clear.planes, clear.values);
        return;
    }
    target.materialize(index, clear.planes);
    const BinRect rect{std::max(clear.x0 - bin.x, 0), std::max(clear.y0 - bin.y, 0),
                       std::min(clear.x1 - bin.x, kBinSize), std::min(clear.y1 - bin.y, kBinSize)};
    for (int sample = 0; sample < target.format().samples; ++sample) {
        const Bin planes = planes_of_sample(bin, sample, target.format().color);
        if (clear.planes.color) clear_color(clear, target.format().color, rect, planes.color);
        if (clear.planes.depth && bin.depth) {
            const PixelBits<uint32_t, 1> bits{{clear.values.depth}, {~0u}};
            clear_plane(bits, rect, planes.depth);
        }
        if (clear.planes.stencil && bin.stencil) {
            const PixelBits<uint8_t, 1> bits{
                {static_cast<uint8_t>(clear.values.stencil & clear.stencil_mask)}, {clear.stencil_mask}};
            clear_plane(bits, rect, planes.stencil);
        }
    }
    if (clear.planes.depth) target.forget_farthest(index);
}

}  // namespace terrazzo::raster
