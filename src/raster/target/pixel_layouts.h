// Per PixelLayout: how a tile's pixels become client pixels.
//
// `kPixelBytes`, which planes it reads, and `store`, which writes `count` consecutive pixels of a bin,
// beginning with number `first` in the order of its memory. A tile's row of four goes at once: GCC's and
// Clang's vectors are the processor's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "raster/target/target.h"

namespace terrazzo::raster {

struct ReadsColors {
    static constexpr bool kColor = true, kStencil = false;
};
struct ReadsDepths {
    static constexpr bool kColor = false, kStencil = false;
};

template <typename Word>
using TileRow [[gnu::vector_size(kTileSize * sizeof(Word))]] = Word;

template <typename Word>
TileRow<Word> load_tile_row(const void* from) {
    TileRow<Word> row;
    std::memcpy(&row, from, sizeof row);
    return row;
}

// Of one pixel, or a vector of them.
constexpr auto as_it_is = [](auto p) { return p; };
constexpr auto rgba_to_bgra = [](auto p) {
    return (p & 0xff00ff00u) | (p & 0xffu) << 16 | (p >> 16 & 0xffu);
};
constexpr auto rgba_to_argb = [](auto p) { return p << 8 | p >> 24; };
constexpr auto make_opaque = [](auto p) { return p | 0xff000000u; };

template <typename Word, auto kConvert>
struct Words : ReadsColors {
    static constexpr int kPixelBytes = sizeof(Word);

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        const std::byte* in = bin.color + first * std::ptrdiff_t{sizeof(Word)};
        if (count == kTileSize) {
            const TileRow<Word> row = kConvert(load_tile_row<Word>(in));
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

// The first three bytes of what a conversion makes of a pixel's four.
template <auto kConvert>
struct ThreeBytes : ReadsColors {
    static constexpr int kPixelBytes = 3;

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        const std::byte* in = bin.color + first * 4;
        if (count == kTileSize) {
            // Two pixels' six bytes come to lie side by side, then four pixels' twelve.
            using Pairs [[gnu::vector_size(16)]] = uint64_t;
            Pairs pairs = reinterpret_cast<Pairs>(kConvert(load_tile_row<uint32_t>(in)));
            pairs = (pairs & 0xffffffu) | (pairs >> 8 & 0xffffff000000u);
            const uint64_t low = pairs[0] | pairs[1] << 48;
            const auto high = static_cast<uint32_t>(pairs[1] >> 16);
            std::memcpy(out, &low, sizeof low);
            std::memcpy(out + sizeof low, &high, sizeof high);
            return;
        }
        for (int i = 0; i < count; ++i) {
            uint32_t word;
            std::memcpy(&word, in + static_cast<std::size_t>(i) * sizeof word, sizeof word);
            word = kConvert(word);
            std::memcpy(out + static_cast<std::size_t>(i) * 3, &word, 3);
        }
    }
};

// Whole pixels, or their first bytes: red, green and blue without alpha.
template <int kBytesIn, int kBytesOut>
struct Bytes : ReadsColors {
    static constexpr int kPixelBytes = kBytesOut;

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        const std::byte* in = bin.color + first * kBytesIn;
        if constexpr (kBytesIn == kBytesOut) {
            std::memcpy(out, in, static_cast<std::size_t>(count) * kBytesOut);
        } else {
            for (int i = 0; i < count; ++i) std::memcpy(out + i * kBytesOut, in + i * kBytesIn, kBytesOut);
        }
    }
};

struct Depth16 : ReadsDepths {
    static constexpr int kPixelBytes = 2;

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        for (int i = 0; i < count; ++i) {
            const auto depth = static_cast<uint16_t>(bin.depth[first + i]);
            std::memcpy(out + i * 2, &depth, sizeof depth);
        }
    }
};

struct Depth24Stencil8 {
    static constexpr bool kColor = false, kStencil = true;
    static constexpr int kPixelBytes = 4;

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        for (int i = 0; i < count; ++i) {
            const uint32_t stencil = bin.stencil ? bin.stencil[first + i] : 0u;
            const uint32_t word = bin.depth[first + i] | stencil << 24;
            std::memcpy(out + i * 4, &word, sizeof word);
        }
    }
};

// Of depths of so many bits. Products are rounded once, from doubles: the reference's way.
template <int kBits>
struct DepthFloats : ReadsDepths {
    static constexpr int kPixelBytes = 4;
    static constexpr double kScale = 1.0 / ((1 << kBits) - 1);

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        if (count == kTileSize) {
            const auto depths = load_tile_row<int32_t>(bin.depth + first);
            const auto row = __builtin_convertvector(
                __builtin_convertvector(depths, TileRow<double>) * kScale, TileRow<float>);
            std::memcpy(out, &row, sizeof row);
            return;
        }
        for (int i = 0; i < count; ++i) {
            const auto depth = static_cast<float>(static_cast<int32_t>(bin.depth[first + i]) * kScale);
            std::memcpy(out + i * 4, &depth, sizeof depth);
        }
    }
};

// Widened by repeating their bits: the reference's way without floats.
template <int kBits>
struct DepthIntegers : ReadsDepths {
    static constexpr int kPixelBytes = 4;
    static constexpr auto widened = [](auto d) { return d << (32 - kBits) | d >> (2 * kBits - 32); };

    static void store(const Bin& bin, std::ptrdiff_t first, int count, std::byte* out) {
        if (count == kTileSize) {
            const TileRow<uint32_t> row = widened(load_tile_row<uint32_t>(bin.depth + first));
            std::memcpy(out, &row, sizeof row);
            return;
        }
        for (int i = 0; i < count; ++i) {
            const uint32_t depth = widened(bin.depth[first + i]);
            std::memcpy(out + i * 4, &depth, sizeof depth);
        }
    }
};

}  // namespace terrazzo::raster
