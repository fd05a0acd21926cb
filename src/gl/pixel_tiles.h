// Fills the tiles that a pixel rectangle carries to the frame, row by row of its source.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "gl/pixel_grid.h"
#include "gl/pixel_rect.h"

namespace terrazzo::gl {

// One pixel of a source, and where its parts go in a tile (raster::PixelImage).
struct ByteColor {
    static constexpr std::size_t kTileBytes = 64;
    static void store(uint32_t color, std::byte* tile, int pixel) {
        reinterpret_cast<uint32_t*>(tile)[pixel] = color;
    }
    using Pixel = uint32_t;
};
struct FloatColor {
    static constexpr std::size_t kTileBytes = 256;
    struct Pixel {
        float rgba[4];
    };
    static void store(const Pixel& color, std::byte* tile, int pixel) {
        for (int c = 0; c < 4; ++c) reinterpret_cast<float*>(tile)[16 * c + pixel] = color.rgba[c];
    }
};
using Depth = ByteColor;  // 32 bits as well
struct StencilValue {
    static constexpr std::size_t kTileBytes = 16;
    using Pixel = uint8_t;
    static void store(uint8_t value, std::byte* tile, int pixel) { tile[pixel] = std::byte{value}; }
};

// On a 64-byte boundary. Throws std::bad_alloc.
std::shared_ptr<std::byte[]> allocate_tiles(std::size_t bytes);

// The rectangle of `grid` with its pixels: fetch(row, first, count, pixels) reads pixels of a source row.
// Throws std::bad_alloc.
template <typename Kind, typename Fetch>
pipeline::PixelRect make_pixel_rect(const PixelGrid& grid, Fetch fetch) {
    constexpr int kSize = raster::kTileSize;
    const PixelAxis &columns = grid.columns, &rows = grid.rows;
    pipeline::PixelRect rect;
    rect.x0 = columns.first, rect.x1 = columns.end();
    rect.y0 = rows.first, rect.y1 = rows.end();
    rect.data = raster::RectangleData::kPixels;
    rect.data_bytes = lay_out_tiles(rect) * Kind::kTileBytes;
    std::shared_ptr<std::byte[]> tiles = allocate_tiles(rect.data_bytes);
    rect.tile_data.tiles = tiles.get();

    const int lowest = columns.lowest_source(), count = columns.highest_source() - lowest + 1;
    std::vector<typename Kind::Pixel> pixels(static_cast<std::size_t>(count));
    int fetched = -1;
    for (int y = rect.y0; y < rect.y1; ++y) {
        const int source = rows.sources[static_cast<std::size_t>(y - rect.y0)];
        if (source != fetched) fetch(source, lowest, count, pixels.data());
        fetched = source;
        std::byte* tile =
            tiles.get() + rect.tile_data.index(rect.tile_data.first_column, y / kSize) * Kind::kTileBytes;
        const int* from = columns.sources.data();
        for (int x = rect.x0; x < rect.x1; tile += Kind::kTileBytes) {
            const int end = std::min(rect.x1, x - x % kSize + kSize), line = y % kSize * kSize;
            for (; x < end; ++x)
                Kind::store(pixels[static_cast<std::size_t>(*from++ - lowest)], tile, line + x % kSize);
        }
    }
    rect.owner = std::move(tiles);
    return rect;
}

}  // namespace terrazzo::gl
