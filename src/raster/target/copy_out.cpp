// Copies tiles to rows; see resolve.h. A bin is read tile by tile, in the order of its memory, and each
// tile's four rows go to four rows of the picture. A bin that was only cleared is not filled for this: its
// colour is written out.
#include "raster/target/copy_out.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "raster/target/color_format.h"
#include "raster/target/mean_of_samples.h"

namespace terrazzo::raster {
namespace {

// Per layout: `kPixelBytes`, and `store`, which writes `count` consecutive pixels of a bin, beginning with
// number `first` in the order of its memory.

template <typename Word, auto kConvert>
struct Words {
    static constexpr int kPixelBytes = sizeof(Word);

    static void store(const Bin& bin, int first, int count, std::byte* out) {
        const std::byte* in = bin.color + static_cast<std::size_t>(first) * sizeof(Word);
        if (count == kTileSize) {
            // All of a tile's row at once; GCC's and Clang's vectors are the processor's.
            using Row [[gnu::vector_size(kTileSize * sizeof(Word))]] = Word;
            Row row;
            std::memcpy(&row, in, sizeof row);
            row = kConvert(row);
            std::memcpy(out, &row, sizeof row);
            return;
        }
        for (int i = 0; i < count; ++i) {
            Word word;
            std::memcpy(&word, in + static_cast<std::size_t>(i) * sizeof word, sizeof word);
            word = kConvert(word);
            std::memcpy(out + static_cast<std::size_t>(i) * sizeof word, &word, sizeof word);
        }
    }
};

// Of one pixel, or a vector of them.
constexpr auto rgba_to_bgra = [](auto p) {
    return (p & 0xff00ff00u) | (p & 0xffu) << 16 | (p >> 16 & 0xffu);
};
constexpr auto rgba_to_argb = [](auto p) { return p << 8 | p >> 24; };

// Whole pixels, or their first bytes: red, green and blue without alpha.
template <int kBytesIn, int kBytesOut>
struct Bytes {
    static constexpr int kPixelBytes = kBytesOut;

    static void store(const Bin& bin, int first, int count, std::byte* out) {
        const std::byte* in = bin.color + static_cast<std::size_t>(first) * kBytesIn;
        if constexpr (kBytesIn == kBytesOut) {
            std::memcpy(out, in, static_cast<std::size_t>(count) * kBytesOut);
        } else {
            for (int i = 0; i < count; ++i) std::memcpy(out + i * kBytesOut, in + i * kBytesIn, kBytesOut);
        }
    }
};

struct Depth16 {
    static constexpr int kPixelBytes = 2;

    static void store(const Bin& bin, int first, int count, std::byte* out) {
        for (int i = 0; i < count; ++i) {
            const auto depth = static_cast<uint16_t>(bin.depth[first + i]);
            std::memcpy(out + i * 2, &depth, sizeof depth);
        }
    }
};

struct Depth24Stencil8 {
    static constexpr int kPixelBytes = 4;

    static void store(const Bin& bin, int first, int count, std::byte* out) {
        for (int i = 0; i < count; ++i) {
            const uint32_t stencil = bin.stencil ? bin.stencil[first + i] : 0u;
            const uint32_t word = bin.depth[first + i] | stencil << 24;
            std::memcpy(out + i * 4, &word, sizeof word);
        }
    }
};

struct Rows {
    std::byte* first;  // pixel (0, 0) of the bin
    std::ptrdiff_t stride;
    int width;           // of the part of the bin that is in the target
    int first_row, end;  // which of the bin's rows
};

// Row after row, so that each line of the picture's memory is written at once.
template <class Layout>
void copy_tiles(const Bin& bin, const Rows& rows) {
    const int whole_width = rows.width & ~(kTileSize - 1);
    for (int y = rows.first_row; y < rows.end; ++y) {
        std::byte* const out = rows.first + y * rows.stride;
        for (int x = 0; x < whole_width; x += kTileSize)
            Layout::store(bin, pixel_index(x, y), kTileSize, out + std::ptrdiff_t{x} * Layout::kPixelBytes);
        if (whole_width < rows.width) {
            Layout::store(bin, pixel_index(whole_width, y), rows.width - whole_width,
                          out + std::ptrdiff_t{whole_width} * Layout::kPixelBytes);
        }
    }
}

// A bin of which only the clear colour is known: one tile of that colour, again and again.
template <class Layout>
void copy_clear_color(const Target& target, const Bin& bin, const Rows& rows) {
    alignas(16) std::array<std::byte, kTileSize * 16> tile_row;
    fill_color(target.format().color, bin.state->clear.color, tile_row.data(), kTileSize);
    Bin one_tile_row = bin;
    one_tile_row.color = tile_row.data();
    std::byte* const first = rows.first + rows.first_row * rows.stride;
    for (int x = 0; x < rows.width; x += kTileSize) {
        Layout::store(one_tile_row, 0, std::min(kTileSize, rows.width - x),
                      first + std::ptrdiff_t{x} * Layout::kPixelBytes);
    }
    const std::size_t row_bytes = static_cast<std::size_t>(rows.width) * Layout::kPixelBytes;
    // A client may have asked for rows that overlap.
    for (int y = rows.first_row + 1; y < rows.end; ++y)
        std::memmove(rows.first + y * rows.stride, first, row_bytes);
}

template <class Layout>
[[gnu::noinline]] void copy_resolved_tiles(const Target& target, Bin bin, const Rows& rows) {
    ResolvedPixels pixels;
    resolve_samples(bin, target.format().color, 0, kBinTiles, pixels);
    bin.color = pixels.bytes;
    copy_tiles<Layout>(bin, rows);
}

template <class Layout>
constexpr bool kIsColor = !std::is_same_v<Layout, Depth16> && !std::is_same_v<Layout, Depth24Stencil8>;

// The rows `first_row` to `end` - 1 of a bin, as far as they are in the target.
template <class Layout>
void copy_rows(Target& target, int index, std::byte* row0, std::ptrdiff_t stride, int first_row, int end) {
    const Bin bin = target.bin(index);
    const Rows rows{row0 + bin.y * stride + std::ptrdiff_t{bin.x} * Layout::kPixelBytes, stride,
                    std::min(kBinSize, target.width() - bin.x), first_row,
                    std::min(end, target.height() - bin.y)};
    if (rows.first_row >= rows.end) return;
    if (kIsColor<Layout> && bin.state->pending.color) {
        copy_clear_color<Layout>(target, bin, rows);
    } else if (kIsColor<Layout> && target.format().samples > 1) {
        copy_resolved_tiles<Layout>(target, bin, rows);
    } else {
        copy_tiles<Layout>(bin, rows);
    }
}

template <class Layout>
void copy_bins(Target& target, int first, int count, std::byte* row0, std::ptrdiff_t stride) {
    if (!kIsColor<Layout>)
        for (int i = first; i < first + count; ++i) target.materialize_to_read(i);
    // The mean of samples is worked out a bin at a time.
    const int step = target.format().samples > 1 ? kBinSize : kTileSize;
    if (count == 1 || step == kBinSize) {
        for (int i = first; i < first + count; ++i) copy_rows<Layout>(target, i, row0, stride, 0, kBinSize);
        return;
    }
    for (int y = 0; y < kBinSize; y += step)
        for (int i = first; i < first + count; ++i) copy_rows<Layout>(target, i, row0, stride, y, y + step);
}

}  // namespace

bool rows_share_cache_lines(std::ptrdiff_t stride) {
    return stride % 1024 == 0;
}

void resolve_bins(Target& target, int first, int count, PixelLayout layout, std::byte* row0,
                  std::ptrdiff_t stride) {
    switch (layout) {
        case PixelLayout::kRgba8:
            return copy_bins<Bytes<4, 4>>(target, first, count, row0, stride);
        case PixelLayout::kBgra8:
            return copy_bins<Words<uint32_t, rgba_to_bgra>>(target, first, count, row0, stride);
        case PixelLayout::kArgb8:
            return copy_bins<Words<uint32_t, rgba_to_argb>>(target, first, count, row0, stride);
        case PixelLayout::kRgb8:
            return copy_bins<Bytes<4, 3>>(target, first, count, row0, stride);
        case PixelLayout::kRgba16:
            return copy_bins<Bytes<8, 8>>(target, first, count, row0, stride);
        case PixelLayout::kRgb16:
            return copy_bins<Bytes<8, 6>>(target, first, count, row0, stride);
        case PixelLayout::kRgba32F:
            return copy_bins<Bytes<16, 16>>(target, first, count, row0, stride);
        case PixelLayout::kRgb32F:
            return copy_bins<Bytes<16, 12>>(target, first, count, row0, stride);
        case PixelLayout::kRgb565:
            return copy_bins<Bytes<2, 2>>(target, first, count, row0, stride);
        case PixelLayout::kDepth16:
            return copy_bins<Depth16>(target, first, count, row0, stride);
        case PixelLayout::kDepth24Stencil8:
            return copy_bins<Depth24Stencil8>(target, first, count, row0, stride);
    }
}

}  // namespace terrazzo::raster
