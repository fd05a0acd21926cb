// Fills in what a rectangle of pixels gets from the current raster position.
#include "gl/pixel_rect.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/pixel_tiles.h"
#include "gl/validate.h"

namespace terrazzo::gl {
namespace {

// Whether the coordinates' q, which decides about the layout of varyings, is what it was.
bool fits(const Context& ctx, const raster::Varyings& varyings) {
    for (std::size_t u = 0; u < kMaxTextureUnits; ++u) {
        if (varyings.texture[u] < 0) continue;
        const bool projects = ctx.raster_position.texture_coordinates[u][3] != 1;
        if (projects != ((varyings.projective >> u & 1) != 0)) return false;
    }
    return true;
}

void validate_raster(Context& ctx, raster::PixelImage image, bool past_tests) {
    Drawing& drawing = ctx.drawing;
    const RasterPosition& position = ctx.raster_position;
    if (!drawing.raster_is_stale && drawing.raster_image == image &&
        drawing.raster_past_tests == past_tests && drawing.raster_color == position.color &&
        fits(ctx, drawing.raster_fragment->point.varyings))
        return;
    drawing.raster_fragment = make_raster_fragment(ctx, image, past_tests);
    drawing.raster_image = image;
    drawing.raster_past_tests = past_tests;
    drawing.raster_color = position.color;
    scissor_box(ctx, drawing.raster_box);
    drawing.raster_is_stale = false;
}

void fill_varyings(const RasterPosition& position, const raster::Varyings& varyings, float* out) {
    if (varyings.secondary >= 0) std::copy_n(position.secondary_color.data(), 3, out + varyings.secondary);
    if (varyings.fog >= 0) out[varyings.fog] = std::fabs(position.distance);
    for (std::size_t u = 0; u < kMaxTextureUnits; ++u) {
        if (varyings.texture[u] < 0) continue;
        std::copy_n(position.texture_coordinates[u].data(), varyings.texture_planes(u),
                    out + varyings.texture[u]);
    }
}

}  // namespace

void draw_pixel_rect(Context& ctx, raster::PixelImage image, pipeline::PixelRect& rect, bool past_tests) {
    if (!check_framebuffer(ctx)) return;
    flush_vertices(ctx);
    validate_raster(ctx, image, past_tests);
    // The reference's quad goes through a viewport of its own: these are its roundings.
    rect.z = (ctx.raster_position.window[2] * 2.0f - 1.0f) * 0.5f + 0.5f;
    fill_varyings(ctx.raster_position, ctx.drawing.raster_fragment->point.varyings, rect.varyings.data());
    ctx.renderer.draw(ctx.drawing.raster_box, ctx.drawing.raster_fragment, rect);
}

std::size_t lay_out_tiles(pipeline::PixelRect& rect) {
    using raster::kTileSize;
    raster::TileData& data = rect.tile_data;
    data.first_column = rect.x0 / kTileSize;
    data.first_row = rect.y0 / kTileSize;
    data.across = (rect.x1 - 1) / kTileSize - data.first_column + 1;
    const int down = (rect.y1 - 1) / kTileSize - data.first_row + 1;
    return static_cast<std::size_t>(data.across) * static_cast<std::size_t>(down);
}

std::shared_ptr<std::byte[]> allocate_tiles(std::size_t bytes) {
    constexpr std::size_t kAlignment = 64;
    void* const memory = std::aligned_alloc(kAlignment, (bytes + kAlignment - 1) / kAlignment * kAlignment);
    if (memory == nullptr) throw std::bad_alloc();
    return {static_cast<std::byte*>(memory), std::free};
}

}  // namespace terrazzo::gl
