// Copies tiles to rows; see copy_out.h. Row after row of a bin is read from its tiles, so that each line of
// the picture's memory is written at once. Of a bin that has one value everywhere, and may not even have been
// filled with it, the value is written out.
#include "raster/target/copy_out.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "raster/target/color_format.h"
#include "raster/target/mean_of_samples.h"
#include "raster/target/pixel_layouts.h"

namespace terrazzo::raster {
namespace {

// Where the pixels of a rectangle go.
struct Destination {
    int x, row;  // the pixel that goes to `first`
    std::byte* first;
    std::ptrdiff_t stride;

    template <class Layout>
    std::byte* at(int to_x, int to_row) const {
        return first + std::ptrdiff_t{to_row - row} * stride + std::ptrdiff_t{to_x - x} * Layout::kPixelBytes;
    }
};

// Less than a tile's row; apart from the others, which are to be a loop of few instructions.
template <class Layout>
[[gnu::noinline]] void copy_some(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
    Layout::store(bin, first, count, out);
}

// `part` lies in the bin, of which the function has a copy: the compiler knows then that its pointers stay.
template <class Layout>
void copy_tiles(Bin bin, const RowRect& part, const Destination& to) {
    const int first = part.x - bin.x, end = first + part.width;
    const int head = std::min(end, (first + kTileSize - 1) & ~(kTileSize - 1)) - first;
    const int whole = (part.width - head) / kTileSize, tail = part.width - head - whole * kTileSize;
    for (int row = part.row; row < part.row + part.height; ++row) {
        std::byte* out = to.at<Layout>(part.x, row);
        if (head > 0) {
            copy_some<Layout>(bin, pixel_index(first, row - bin.y), head, out);
            out += std::ptrdiff_t{head} * Layout::kPixelBytes;
        }
        // Tiles of a row follow one another.
        std::ptrdiff_t index = pixel_index(first + head, row - bin.y);
        for (int i = 0; i < whole; ++i, index += kTilePixels, out += kTileSize * Layout::kPixelBytes)
            Layout::store(bin, index, kTileSize, out);
        if (tail > 0) copy_some<Layout>(bin, index, tail, out);
    }
}

// A bin that has one value everywhere: a tile's row of it, again and again.
template <class Layout>
void copy_value(const Target& target, Bin bin, const ClearValues& value, const RowRect& part,
                const Destination& to) {
    alignas(16) std::byte colors[kTileSize * 16];
    uint32_t depths[kTileSize];
    uint8_t stencils[kTileSize];
    if (Layout::kColor) fill_color(target.format().color, value.color, colors, kTileSize);
    std::fill_n(depths, kTileSize, value.depth);
    std::fill_n(stencils, kTileSize, value.stencil);
    bin.color = colors;
    bin.depth = depths;
    if (bin.stencil) bin.stencil = stencils;
    for (int x = 0; x < part.width; x += kTileSize)
        Layout::store(bin, 0, std::min(kTileSize, part.width - x), to.at<Layout>(part.x + x, part.row));
    const std::size_t row_bytes = static_cast<std::size_t>(part.width) * Layout::kPixelBytes;
    const std::byte* const first = to.at<Layout>(part.x, part.row);
    // A client may have asked for rows that overlap.
    for (int row = part.row + 1; row < part.row + part.height; ++row)
        std::memmove(to.at<Layout>(part.x, row), first, row_bytes);
}

template <class Layout>
[[gnu::noinline]] void copy_resolved_tiles(const Target& target, Bin bin, const RowRect& part,
                                           const Destination& to) {
    ResolvedPixels pixels;
    const int first = (part.row - bin.y) / kTileSize, last = (part.row - bin.y + part.height - 1) / kTileSize;
    resolve_samples(bin, target.format().color, first * kTilesAcross, (last - first + 1) * kTilesAcross,
                    pixels);
    bin.color = pixels.bytes;
    copy_tiles<Layout>(bin, part, to);
}

template <class Layout>
void copy_part(Target& target, int index, const RowRect& part, const Destination& to) {
    const Bin bin = target.bin(index);
    if (const auto value = target.uniform_values(index, {Layout::kColor, !Layout::kColor, Layout::kStencil}))
        return copy_value<Layout>(target, bin, *value, part, to);
    if (!Layout::kColor) target.materialize(index, {false, true, Layout::kStencil}, {});
    if (Layout::kColor && target.format().samples > 1)
        return copy_resolved_tiles<Layout>(target, bin, part, to);
    copy_tiles<Layout>(bin, part, to);
}

// Bin by bin; where rows drive each other out of the cache, and a bin's are not worked out first, four rows
// of pixels at a time.
template <class Layout>
void copy_rect(Target& target, const RowRect& rect, std::byte* out, std::ptrdiff_t stride) {
    const Destination to{rect.x, rect.row, out, stride};
    const bool by_tiles = rows_share_cache_lines(stride) && !(Layout::kColor && target.format().samples > 1);
    const int step = by_tiles ? kTileSize : kBinSize;
    const int end_x = rect.x + rect.width, end_row = rect.row + rect.height;
    for (int row = rect.row, next_row; row < end_row; row = next_row) {
        next_row = std::min(end_row, row - row % step + step);
        for (int x = rect.x, next_x; x < end_x; x = next_x) {
            next_x = std::min(end_x, x - x % kBinSize + kBinSize);
            const int index = row / kBinSize * target.bins_across() + x / kBinSize;
            copy_part<Layout>(target, index, {x, row, next_x - x, next_row - row}, to);
        }
    }
}

}  // namespace

bool rows_share_cache_lines(std::ptrdiff_t stride) {
    return stride % 1024 == 0;
}

void resolve_rect(Target& target, const RowRect& rect, PixelLayout layout, std::byte* out,
                  std::ptrdiff_t stride) {
    const bool has_16_bits = target.format().depth_bits == 16;
    switch (layout) {
        case PixelLayout::kRgba8:
            return copy_rect<Words<uint32_t, as_it_is>>(target, rect, out, stride);
        case PixelLayout::kRgbx8:
            return copy_rect<Words<uint32_t, make_opaque>>(target, rect, out, stride);
        case PixelLayout::kBgra8:
            return copy_rect<Words<uint32_t, rgba_to_bgra>>(target, rect, out, stride);
        case PixelLayout::kArgb8:
            return copy_rect<Words<uint32_t, rgba_to_argb>>(target, rect, out, stride);
        case PixelLayout::kRgb8:
            return copy_rect<ThreeBytes<as_it_is>>(target, rect, out, stride);
        case PixelLayout::kBgr8:
            return copy_rect<ThreeBytes<rgba_to_bgra>>(target, rect, out, stride);
        case PixelLayout::kRgba16:
            return copy_rect<Bytes<8, 8>>(target, rect, out, stride);
        case PixelLayout::kRgb16:
            return copy_rect<Bytes<8, 6>>(target, rect, out, stride);
        case PixelLayout::kRgba32F:
            return copy_rect<Bytes<16, 16>>(target, rect, out, stride);
        case PixelLayout::kRgb32F:
            return copy_rect<Bytes<16, 12>>(target, rect, out, stride);
        case PixelLayout::kRgb565:
            return copy_rect<Bytes<2, 2>>(target, rect, out, stride);
        case PixelLayout::kDepth16:
            return copy_rect<Depth16>(target, rect, out, stride);
        case PixelLayout::kDepth24Stencil8:
            return copy_rect<Depth24Stencil8>(target, rect, out, stride);
        case PixelLayout::kDepth32F:
            return has_16_bits ? copy_rect<DepthFloats<16>>(target, rect, out, stride)
                               : copy_rect<DepthFloats<24>>(target, rect, out, stride);
        case PixelLayout::kDepth32:
            return has_16_bits ? copy_rect<DepthIntegers<16>>(target, rect, out, stride)
                               : copy_rect<DepthIntegers<24>>(target, rect, out, stride);
    }
}

void resolve_bins(Target& target, int first, int count, PixelLayout layout, std::byte* row0,
                  std::ptrdiff_t stride) {
    const int x = first % target.bins_across() * kBinSize, row = first / target.bins_across() * kBinSize;
    const RowRect rect{x, row, std::min(count * kBinSize, target.width() - x),
                       std::min(kBinSize, target.height() - row)};
    resolve_rect(target, rect, layout, row0 + row * stride + std::ptrdiff_t{x} * bytes_per_pixel(layout),
                 stride);
}

}  // namespace terrazzo::raster
