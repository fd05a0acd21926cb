// Bitmap (GL 1.5 §3.7): bits become masks of the target's tiles, and the set ones fragments.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"
#include "gl/pixel_rect.h"

namespace terrazzo::gl {
namespace {

using raster::kTileSize;

// Where a coordinate of the bitmap's corner lies. The reference adds a little, so that positions a rounding
// error below a whole number count as that.
int corner(GLfloat position, GLfloat origin) {
    return static_cast<int>(std::floor(bounded(position + 0.0001f - origin)));
}

// The order of bits that tiles have: the leftmost pixel in the lowest bit.
constexpr std::array<uint8_t, 256> kReversed = [] {
    std::array<uint8_t, 256> table{};
    for (unsigned i = 0; i < 256; ++i)
        for (unsigned bit = 0; bit < 8; ++bit) table[i] |= static_cast<uint8_t>((i >> bit & 1) << (7 - bit));
    return table;
}();

// One row of a bitmap: pixels from the left in bits from the lowest.
class BitRow {
  public:
    BitRow(const uint8_t* bytes, int first_bit, int width, bool lsb_first)
        : m_bytes(bytes), m_first_bit(first_bit), m_width(width), m_lsb_first(lsb_first) {}

    // Four pixels from `x` on, which may be up to three before the row's first; those outside are 0.
    unsigned four(int x) const {
        const unsigned before = x < 0 ? static_cast<unsigned>(-x) : 0;
        const int first = std::max(x, 0), last = std::min(x + 4, m_width) - 1;
        const int bit = m_first_bit + first, end = m_first_bit + last;
        unsigned bits = byte(bit >> 3);
        if (end >> 3 != bit >> 3) bits |= byte(end >> 3) << 8;
        const unsigned count = static_cast<unsigned>(last - first + 1);
        return (bits >> (bit & 7) & ((1u << count) - 1)) << before;
    }

  private:
    unsigned byte(int index) const { return m_lsb_first ? m_bytes[index] : kReversed[m_bytes[index]]; }

    const uint8_t* m_bytes;
    int m_first_bit, m_width;
    bool m_lsb_first;
};

// The part of a bitmap that is in the window, in the bitmap's own pixels.
struct Part {
    int x0, y0, x1, y1;
};

// Where the bitmap's lower left pixel is in the window, and the part of it that can be seen.
struct Place {
    int x, y;
    Part part;
};

// The seen pixels as masks of the tiles they lie in; `masks` has room for these.
void mask_tiles(const Context& ctx, GLsizei width, const void* bitmap, const Place& at,
                const raster::TileData& data, uint16_t* masks) {
    const PixelStore& store = ctx.pixels.unpack;
    const ImageLayout layout = image_layout(store, width, GL_COLOR_INDEX, GL_BITMAP);
    const auto* const bytes = static_cast<const uint8_t*>(bitmap) + layout.offset;
    const int first = data.first_column * kTileSize - at.x;  // of the first tile, in the bitmap's pixels
    for (int row = at.part.y0; row < at.part.y1; ++row) {
        const BitRow bits(bytes + static_cast<std::size_t>(row) * layout.row_stride, layout.first_bit, width,
                          store.lsb_first);
        const int target = ctx.surface.row(at.y + row);
        uint16_t* const tiles = masks + data.index(data.first_column, target / kTileSize);
        const int shift = target % kTileSize * kTileSize;
        for (int i = 0; i < data.across; ++i)
            tiles[i] = static_cast<uint16_t>(tiles[i] | bits.four(first + i * kTileSize) << shift);
    }
}

void draw_bitmap(Context& ctx, GLsizei width, GLsizei height, int x, int y, const void* bitmap) {
    begin_drawing(ctx);
    const int64_t right = std::min<int64_t>(int64_t{x} + width, ctx.surface.width);
    const int64_t top = std::min<int64_t>(int64_t{y} + height, ctx.surface.height);
    const Part part{std::max(-x, 0), std::max(-y, 0), static_cast<int>(right - x), static_cast<int>(top - y)};
    if (part.x0 >= part.x1 || part.y0 >= part.y1) return;
    pipeline::PixelRect rect;
    rect.x0 = x + part.x0, rect.x1 = x + part.x1;
    const raster::RowRange rows = ctx.surface.rows(y + part.y0, y + part.y1);
    rect.y0 = static_cast<int>(rows.first), rect.y1 = static_cast<int>(rows.end);
    rect.data = raster::RectangleData::kMasks;
    const std::size_t tiles = lay_out_tiles(rect);
    rect.data_bytes = tiles * sizeof(uint16_t);

    // Glyphs of fonts are small, and there are many.
    std::array<uint16_t, 1024> few;
    uint16_t* masks = few.data();
    if (tiles > few.size()) {
        std::shared_ptr<uint16_t[]> many = std::make_shared<uint16_t[]>(tiles);
        masks = many.get();
        rect.owner = std::move(many);
    } else {
        std::fill_n(masks, tiles, uint16_t{0});
    }
    rect.tile_data.tiles = masks;
    mask_tiles(ctx, width, bitmap, {x, y, part}, rect.tile_data, masks);
    draw_pixel_rect(ctx, raster::PixelImage::kNone, rect);
}

}  // namespace

void bitmap(Context& ctx, GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove,
            GLfloat ymove, const GLubyte* bitmap) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    if (!check_framebuffer(ctx)) return;
    RasterPosition& position = ctx.raster_position;
    if (!position.valid) return;
    if (ctx.render_mode.mode != GL_RENDER) {
        capture_raster(ctx, GL_BITMAP_TOKEN);
    } else if (width > 0 && height > 0) {
        const PixelMemory bits =
            find_image(ctx, ctx.pixels.unpack, {width, height}, GL_COLOR_INDEX, GL_BITMAP, bitmap);
        if (!bits.is_usable()) return record_error(ctx, bits.rule.code, bits.rule.words);
        if (bits.data)
            draw_bitmap(ctx, width, height, corner(position.window[0], xorig),
                        corner(position.window[1], yorig), bits.data);
    }
    position.window[0] += xmove;
    position.window[1] += ymove;
}

}  // namespace terrazzo::gl
