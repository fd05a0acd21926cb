// Half-space traversal of one bin [Pineda 1988; Frolov 2020 §2.2, rows ]: which tiles a primitive
// touches, and which of their pixels, or of the samples of their pixels.
//
// A row of the bin's tiles is tested at once, one lane a tile: an edge function at the tile's most favourable
// corner rejects it, at its least favourable corner accepts it. What remains is tested pixel by pixel, again
// in 16 lanes. All of it is 32-bit arithmetic relative to the bin's corner: where an edge does not cross the
// bin its value is clamped, which keeps its sign.
#pragma once

#include <algorithm>
#include <bit>

#include "raster/traverse/hidden.h"

namespace terrazzo::raster {

// The tiles of one bin that a primitive covers, each with one bit a pixel for each of its samples.
template <int kSamples>
struct CoveredTiles {
    struct Entry {
        uint16_t tile;             // 0 to 255, row by row
        uint16_t masks[kSamples];  // bit 4*y + x, never all 0
    };
    int count = 0;
    Entry entries[kBinTiles];
};
struct TileList : CoveredTiles<1> {};
struct SampleList : CoveredTiles<kMaxSamples> {};

}  // namespace terrazzo::raster

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

using namespace raster;

// An edge relative to a bin.
template <int kSamples>
struct BinEdge {
    int32_t at_row[kSamples];  // value at the first pixel of the current tile row
    int32_t step_x, step_y;
    int32_t best, worst;  // what the most and the least favourable pixel of a tile add to its first pixel
};

// Beyond this an edge cannot change its sign within a bin: a step is below 2^23 and a bin has 64 pixels each
// way.
inline constexpr int64_t kEdgeLimit = int64_t{1} << 30;

TERRAZZO_INLINE int32_t edge_at(const Edge& edge, int x, int y) {
    const int64_t value = edge.c + int64_t{edge.step_x} * x + int64_t{edge.step_y} * y;
    return static_cast<int32_t>(value < -kEdgeLimit ? -kEdgeLimit : value > kEdgeLimit ? kEdgeLimit : value);
}

// The same at one of a pixel's samples; the only one is at the pixel's centre.
template <int kSamples>
TERRAZZO_INLINE int32_t edge_at_sample(const Edge& edge, bool multisample, int sample, int x, int y) {
    if (kSamples == 1 || !multisample) return edge_at(edge, x, y);
    const SamplePosition at = kSamplePositions[sample];
    const int64_t c = edge.c + int64_t{edge.step_x} * at.x + int64_t{edge.step_y} * at.y;
    return edge_at({c >> 8, edge.step_x, edge.step_y}, x, y);
}

template <int kSamples>
TERRAZZO_INLINE BinEdge<kSamples> edge_in_bin(const Edge& edge, bool multisample, int x, int y) {
    BinEdge<kSamples> e;
    for (int s = 0; s < kSamples; ++s) e.at_row[s] = edge_at_sample<kSamples>(edge, multisample, s, x, y);
    int32_t low = e.at_row[0], high = e.at_row[0];
    for (const int32_t value : e.at_row) low = std::min(low, value), high = std::max(high, value);
    e.step_x = edge.step_x;
    e.step_y = edge.step_y;
    e.best = high - e.at_row[0] + 3 * (std::max(edge.step_x, 0) + std::max(edge.step_y, 0));
    e.worst = low - e.at_row[0] + 3 * (std::min(edge.step_x, 0) + std::min(edge.step_y, 0));
    return e;
}

// Pixels of a tile column or row that lie in [low, high), the tile starting at `first`: four bits.
TERRAZZO_INLINE uint32_t span_bits(int first, int low, int high) {
    const int skip = std::max(low - first, 0), keep = std::min(high - first, 4);
    return (0xfu << skip) & ((1u << keep) - 1) & 0xfu;
}
// Four row bits to sixteen pixel bits.
TERRAZZO_INLINE uint32_t spread_rows(uint32_t rows) {
    return ((rows & 1) | (rows & 2) << 3 | (rows & 4) << 6 | (rows & 8) << 9) * 0xfu;
}

// The tiles of a bin that a primitive's rectangle touches, and the pixels of it in the outer ones.
struct TileRect {
    int first_column, last_column, first_row, last_row;
    int x0, x1, y0, y1;

    TERRAZZO_INLINE TileRect(int first_x, int end_x, int first_y, int end_y)
        : first_column(first_x >> 2),
          last_column((end_x - 1) >> 2),
          first_row(first_y >> 2),
          last_row((end_y - 1) >> 2),
          x0(first_x),
          x1(end_x),
          y0(first_y),
          y1(end_y) {}

    // One bit a column of tiles.
    TERRAZZO_INLINE uint32_t columns() const { return (2u << last_column) - (1u << first_column); }
    // Pixels of a tile in the first and the last column.
    TERRAZZO_INLINE uint32_t left() const { return span_bits(first_column * 4, x0, x1) * 0x1111u; }
    TERRAZZO_INLINE uint32_t right() const { return span_bits(last_column * 4, x0, x1) * 0x1111u; }
    TERRAZZO_INLINE uint32_t pixels_of_row(int row) const {
        return row == first_row || row == last_row ? spread_rows(span_bits(row * 4, y0, y1)) : 0xffffu;
    }
    // Across and down, beyond the first.
    int extent() const { return last_column - first_column + last_row - first_row; }
};

// What each pixel of a tile adds to an edge's value at the tile's first pixel.
TERRAZZO_INLINE I32x16 pixel_steps(const Edge& edge) {
    return lane_x() * I32x16(edge.step_x) + lane_y() * I32x16(edge.step_y);
}

// Boxes of up to four by four tiles are tested at once, one lane a tile.
inline constexpr int kBoxTiles = 4;
// What a few more are spared by bounds is less than the bounds cost.
inline constexpr int kTilesWithoutBounds = 8;

// The pixels of a box's tiles that its rectangle leaves in, a word a tile.
TERRAZZO_NOINLINE void limit_tiles(const TileRect& rect, uint32_t (&inside)[kTilePixels]) {
    const auto outside_where = [](Mask16 tiles, uint32_t pixels) {
        return select(tiles, I32x16(static_cast<int32_t>(~pixels)), I32x16(0));
    };
    const I32x16 x = lane_x(), y = lane_y();
    const I32x16 columns = outside_where(x == I32x16(0), rect.left()) |
                           outside_where(x == I32x16(rect.last_column - rect.first_column), rect.right());
    const I32x16 rows =
        outside_where(y == I32x16(0), rect.pixels_of_row(rect.first_row)) |
        outside_where(y == I32x16(rect.last_row - rect.first_row), rect.pixels_of_row(rect.last_row));
    store((columns | rows) ^ I32x16(-1), inside);
}

template <int kEdges, int kSamples>
TERRAZZO_INLINE void cover_box(const Primitive& primitive, const Bin& bin, const TileRect& rect,
                               CoveredTiles<kSamples>& list) {
    const int x = bin.x + rect.first_column * kTileSize, y = bin.y + rect.first_row * kTileSize;
    [[maybe_unused]] const bool multisample = kSamples > 1 && primitive.state->multisample;
    alignas(64)
        int32_t at_tile[kEdges][kTilePixels];  // values of the tiles' first pixels, at the first sample
    int32_t to_sample[kEdges][kSamples];
    I32x16 in_tile[kEdges];
    I32x16 rejects(0);
    for (int e = 0; e < kEdges; ++e) {
        const BinEdge<kSamples> edge = edge_in_bin<kSamples>(primitive.edges[e], multisample, x, y);
        for (int s = 0; s < kSamples; ++s) to_sample[e][s] = edge.at_row[s] - edge.at_row[0];
        in_tile[e] = pixel_steps(primitive.edges[e]);
        const I32x16 value = shift_left<2>(in_tile[e]) + I32x16(edge.at_row[0]);
        store(value, at_tile[e]);
        rejects = rejects | (value + I32x16(edge.best));
    }
    alignas(64) uint32_t limits[kTilePixels];
    if (primitive.is_cut) limit_tiles(rect, limits);
    const uint32_t row = (2u << (rect.last_column - rect.first_column)) - 1,
                   rows = (2u << 4 * (rect.last_row - rect.first_row)) - 1;
    uint32_t touched = row * (0x1111u & rows) & ~sign_bits(rejects);
    const int first = rect.first_row * kTilesAcross + rect.first_column;
    while (touched != 0) {
        const int tile = std::countr_zero(touched);
        touched &= touched - 1;
        auto& entry = list.entries[list.count];
        entry.tile = static_cast<uint16_t>(first + tile / kBoxTiles * kTilesAcross + tile % kBoxTiles);
        const uint32_t limit = primitive.is_cut ? limits[tile] : 0xffff;
        uint32_t any = 0;
        for (int s = 0; s < kSamples; ++s) {
            I32x16 outside(0);
            for (int e = 0; e < kEdges; ++e)
                outside = outside | (in_tile[e] + I32x16(at_tile[e][tile] + to_sample[e][s]));
            const uint32_t mask = limit & ~sign_bits(outside);
            entry.masks[s] = static_cast<uint16_t>(mask);
            any |= mask;
        }
        list.count += any != 0;
    }
}

// In place of BlockDepths where nothing is gained.
struct NoBlockDepths {
    static TERRAZZO_INLINE uint32_t hidden_tiles(int, uint32_t) { return 0; }
};

// Whether any tile was left out because it is hidden.
template <int kEdges, int kSamples, class Depths>
TERRAZZO_INLINE bool cover_rows(const Primitive& primitive, const Bin& bin, const TileRect& rect,
                                Depths& depths, CoveredTiles<kSamples>& list) {
    constexpr int kArray = kEdges == 0 ? 1 : kEdges;
    [[maybe_unused]] const bool multisample = kSamples > 1 && primitive.state->multisample;
    BinEdge<kSamples> edges[kArray];
    I32x16 in_tile[kArray];    // what each pixel adds to its tile's first
    I32x16 along_row[kArray];  // what each tile adds to the row's first
    for (int e = 0; e < kEdges; ++e) {
        edges[e] =
            edge_in_bin<kSamples>(primitive.edges[e], multisample, bin.x, bin.y + rect.first_row * kTileSize);
        along_row[e] = lane_numbers() * I32x16(edges[e].step_x * kTileSize);
        in_tile[e] = pixel_steps(primitive.edges[e]);
    }

    const uint32_t columns = rect.columns(), left = rect.left(), right = rect.right();
    uint32_t whole_columns = columns;
    if (left != 0xffff) whole_columns &= ~(1u << rect.first_column);
    if (right != 0xffff) whole_columns &= ~(1u << rect.last_column);

    uint32_t any_hidden = 0;
    for (int row = rect.first_row; row <= rect.last_row; ++row) {
        uint32_t touched = columns, partial = 0;
        if constexpr (kEdges != 0) {
            I32x16 rejects(0), accepts(0);
            for (int e = 0; e < kEdges; ++e) {
                const I32x16 value = along_row[e] + I32x16(edges[e].at_row[0]);
                rejects = rejects | (value + I32x16(edges[e].best));
                accepts = accepts | (value + I32x16(edges[e].worst));
            }
            touched &= ~sign_bits(rejects);
            partial = sign_bits(accepts);
        }
        const uint32_t rows = rect.pixels_of_row(row);
        const uint32_t hidden =
            touched & depths.hidden_tiles(row, rows == 0xffff ? touched & ~partial & whole_columns : 0);
        any_hidden |= hidden;
        touched ^= hidden;
        while (touched != 0) {
            const int column = std::countr_zero(touched);
            touched &= touched - 1;
            uint32_t mask = rows;
            if (column == rect.first_column) mask &= left;
            if (column == rect.last_column) mask &= right;
            auto& entry = list.entries[list.count];
            entry.tile = static_cast<uint16_t>(row * kTilesAcross + column);
            uint32_t any = 0;
            for (int s = 0; s < kSamples; ++s) {
                uint32_t inside = mask;
                if (partial >> column & 1) {
                    I32x16 outside(0);
                    for (int e = 0; e < kEdges; ++e)
                        outside =
                            outside |
                            (in_tile[e] + I32x16(edges[e].at_row[s] + column * kTileSize * edges[e].step_x));
                    inside &= ~sign_bits(outside);
                }
                entry.masks[s] = static_cast<uint16_t>(inside);
                any |= inside;
            }
            list.count += any != 0;
        }
        for (int e = 0; e < kEdges; ++e)
            for (int32_t& value : edges[e].at_row) value += kTileSize * edges[e].step_y;
    }
    return any_hidden != 0;
}

// How far a tile's fragments lie apart, its only or all samples'.
template <int kSamples>
inline constexpr float kTileExtent = kSamples == 1 ? kTileSize - 1 : kTileSize;

template <int kEdges, int kSamples>
TERRAZZO_INLINE void cover_bin(const Primitive& primitive, Bin& bin, CoveredTiles<kSamples>& list) {
    const int x0 = std::max<int>(primitive.x0 - bin.x, 0), x1 = std::min<int>(primitive.x1 - bin.x, kBinSize);
    const int y0 = std::max<int>(primitive.y0 - bin.y, 0), y1 = std::min<int>(primitive.y1 - bin.y, kBinSize);
    list.count = 0;
    if (x0 >= x1 || y0 >= y1) return;
    const TileRect rect(x0, x1, y0, y1);
    const FragmentKey& key = primitive.state->key;
    if (raises_depth(key)) forget_bounds(bin, rect.first_row, rect.last_row);
    if constexpr (kEdges != 0) {
        if (rect.last_column - rect.first_column < kBoxTiles && rect.last_row - rect.first_row < kBoxTiles)
            return cover_box<kEdges>(primitive, bin, rect, list);
    }
    if (rect.extent() <= kTilesWithoutBounds || !discards_hidden(key)) {
        NoBlockDepths none;
        cover_rows<kEdges>(primitive, bin, rect, none, list);
        return;
    }
    BlockDepths depths(primitive, bin, kTileExtent<kSamples>);
    if (depths.behind(bin.state->farthest, rect.first_column, rect.last_column, rect.first_row,
                      rect.last_row))
        return;
    const bool some_hidden = cover_rows<kEdges>(primitive, bin, rect, depths, list);
    constexpr uint32_t kHiddenPerUpdate = 16;
    if (some_hidden && list.count == 0 && ++bin.state->hidden % kHiddenPerUpdate == 0) lower_bin_bound(bin);
}

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
