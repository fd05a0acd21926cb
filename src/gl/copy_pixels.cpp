// CopyPixels (GL 1.5 §4.3.3): a rectangle of the frame buffer, read when everything before is drawn, becomes
// a pixel rectangle. What lies outside the window is not copied.
#include <algorithm>
#include <cmath>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_tiles.h"
#include "gl/pixel_transfer.h"
#include "gl/read_source.h"

namespace terrazzo::gl {
namespace {

// A rectangle of the finished frame buffer, (x, y) being its lower left pixel.
class BufferRows {
  public:
    BufferRows(Context& ctx, GLint x, GLint y) : m_ctx(ctx), m_source(ctx), m_x(x), m_y(y) {}

    bool has_bytes() const { return m_source.has_bytes(m_ctx.pixels); }

    // Leaves of the grid what shows pixels that there are.
    void cut(PixelGrid& grid, GLsizei width, GLsizei height) const {
        const ReadRect seen = m_source.clip(m_x, m_y, width, height);
        grid.columns.keep_sources(seen.skipped_columns, seen.skipped_columns + seen.width);
        grid.rows.keep_sources(seen.skipped_rows, seen.skipped_rows + seen.height);
    }

    void read(int row, int first, int count, uint32_t* colors) const {
        m_source.read(m_x + first, m_y + row, count, reinterpret_cast<uint8_t*>(colors));
    }
    void read(int row, int first, int count, FloatColor::Pixel* colors) const {
        m_source.read(m_x + first, m_y + row, count, m_ctx.pixels, colors->rgba);
    }

    void read_depths(int row, int first, int count, uint32_t* depths) const {
        m_source.read_depths(m_x + first, m_y + row, count, depths);
        const int from = m_source.format().depth_bits, to = m_ctx.surface.format.depth_bits;
        if (from == to && !changes_depths(m_ctx.pixels)) return;
        const auto maximum = [](int bits) { return static_cast<double>((uint64_t{1} << bits) - 1); };
        for (int i = 0; i < count; ++i) {
            auto z = static_cast<float>(depths[i] / maximum(from));
            if (changes_depths(m_ctx.pixels)) transfer_depths(m_ctx.pixels, &z, 1);
            depths[i] = static_cast<uint32_t>(std::lrint(z * static_cast<float>(maximum(to))));
        }
    }

    void read_stencils(int row, int first, int count, uint8_t* values) const {
        m_source.read_stencils(m_x + first, m_y + row, count, values);
        if (!changes_stencils(m_ctx.pixels)) return;
        for (int i = 0; i < count; ++i) {
            uint32_t index = values[i];
            transfer_stencils(m_ctx.pixels, &index, 1);
            values[i] = static_cast<uint8_t>(index);
        }
    }

  private:
    Context& m_ctx;
    ReadSource m_source;
    GLint m_x, m_y;
};

struct CopiedRect {
    raster::PixelImage image;
    pipeline::PixelRect rect;
};

// `type` is not GL_DEPTH_STENCIL here.
CopiedRect copy_rows(GLenum type, const PixelGrid& grid, const BufferRows& rows) {
    const auto read = [&](int row, int first, int count, auto* pixels) {
        rows.read(row, first, count, pixels);
    };
    if (type == GL_STENCIL) {
        return {raster::PixelImage::kStencil,
                make_pixel_rect<StencilValue>(grid, [&](int row, int first, int count, uint8_t* values) {
                    rows.read_stencils(row, first, count, values);
                })};
    }
    if (type == GL_DEPTH) {
        return {raster::PixelImage::kDepth,
                make_pixel_rect<Depth>(grid, [&](int row, int first, int count, uint32_t* depths) {
                    rows.read_depths(row, first, count, depths);
                })};
    }
    if (rows.has_bytes()) return {raster::PixelImage::kRgba8, make_pixel_rect<ByteColor>(grid, read)};
    return {raster::PixelImage::kRgba32F, make_pixel_rect<FloatColor>(grid, read)};
}

bool is_there(const Context& ctx, GLenum type) {
    const auto holds = [&](const raster::TargetFormat& format) {
        const bool wants_depth = type == GL_DEPTH || type == GL_DEPTH_STENCIL,
                   wants_stencil = type == GL_STENCIL || type == GL_DEPTH_STENCIL;
        return (!wants_depth || format.depth_bits != 0) && (!wants_stencil || format.stencil_bits != 0);
    };
    const auto source = read_target(ctx);
    return holds(ctx.surface.format) && (!source || holds(source->format()));
}

}  // namespace

void copy_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    const bool both = type == GL_DEPTH_STENCIL;
    if (type != GL_COLOR && type != GL_DEPTH && type != GL_STENCIL && !both)
        return record_error(ctx, GL_INVALID_ENUM, "there is no such type of buffer");
    if (!check_framebuffer(ctx) || !check_readable_framebuffer(ctx)) return;
    if (type == GL_COLOR && has_read_source(ctx) && !has_read_colors(ctx))
        return record_error(ctx, GL_INVALID_OPERATION, "there is no colour buffer");
    if (!is_there(ctx, type)) return record_error(ctx, GL_INVALID_OPERATION, "there is no such buffer");
    if (!ctx.raster_position.valid || !has_read_source(ctx)) return;
    if (ctx.render_mode.mode != GL_RENDER) return capture_raster(ctx, GL_COPY_PIXEL_TOKEN);
    begin_drawing(ctx);
    PixelGrid grid = make_pixel_grid(ctx, width, height);
    if (grid.empty()) return;
    CopiedRect copied, depths;
    {
        const BufferRows rows(ctx, x, y);
        rows.cut(grid, width, height);
        if (grid.empty()) return;
        copied = copy_rows(both ? GL_STENCIL : type, grid, rows);
        if (both) depths = copy_rows(GL_DEPTH, grid, rows);
    }
    draw_pixel_rect(ctx, copied.image, copied.rect, both);
    if (both) draw_pixel_rect(ctx, depths.image, depths.rect, true);
}

}  // namespace terrazzo::gl
