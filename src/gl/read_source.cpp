// Access to the finished render target.
#include "gl/read_source.h"

#include <algorithm>

#include "gl/context.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "raster/target/read_row.h"

namespace terrazzo::gl {
namespace {

std::shared_ptr<raster::Target> finished_target(Context& ctx, ColorBuffer buffer) {
    finish_drawing(ctx);
    Drawable& drawable = *ctx.surface.read;
    return drawable.plane_of(buffer) == raster::ColorPlane::kSecond ? drawable.target_with_front()
                                                                    : read_target(ctx);
}

}  // namespace

std::shared_ptr<raster::Target> read_target(const Context& ctx) {
    const Drawable* const drawable = ctx.surface.read.get();
    if (!drawable) return nullptr;
    const auto& drawn = ctx.renderer.target();
    return drawable == ctx.surface.draw.get() && drawn ? drawn : drawable->target();
}

bool has_read_colors(const Context& ctx) {
    return !ctx.framebuffers.read || read_target(ctx)->has_color();
}

ReadSource::ReadSource(Context& ctx)
    : m_target(finished_target(ctx, read_color_buffer(ctx))),
      m_plane(ctx.surface.read->plane_of(read_color_buffer(ctx))) {}

ReadRect ReadSource::clip(GLint x, GLint y, GLsizei width, GLsizei height) const {
    const int64_t x0 = std::max(x, 0), x1 = std::min(int64_t{x} + width, int64_t{m_target->width()});
    const int64_t y0 = std::max(y, 0), y1 = std::min(int64_t{y} + height, int64_t{m_target->height()});
    if (x0 >= x1 || y0 >= y1) return {};
    return {static_cast<GLint>(x0),        static_cast<GLint>(y0),       static_cast<GLsizei>(x1 - x0),
            static_cast<GLsizei>(y1 - y0), static_cast<GLsizei>(x0 - x), static_cast<GLsizei>(y0 - y)};
}

bool ReadSource::has_bytes(const PixelState& pixels) const {
    return raster::fits_rgba8(m_target->format().color) && !changes_colors(pixels);
}

void ReadSource::read(int x, int y, int count, uint8_t* rgba) const {
    const raster::TargetUse use(*m_target, m_plane);
    raster::read_color_rgba8(*m_target, x, m_target->row(y), count, rgba);
}

void ReadSource::read(int x, int y, int count, const PixelState& pixels, float* rgba) const {
    {
        const raster::TargetUse use(*m_target, m_plane);
        raster::read_color_float(*m_target, x, m_target->row(y), count, rgba);
    }
    if (!changes_colors(pixels)) return;
    transfer_colors(pixels, rgba, count);
    if (m_target->format().color == raster::ColorFormat::kRgba32F) return;
    std::transform(rgba, rgba + 4 * count, rgba, clamp_to_unit);
}

void ReadSource::read(const ReadRect& rect, raster::PixelLayout layout, std::byte* out,
                      std::ptrdiff_t stride) const {
    if (rect.width == 0) return;
    const raster::TargetUse use(*m_target, m_plane);
    if (format().rows == raster::RowOrder::kBottomFirst)
        return raster::resolve_rect(*m_target, {rect.x, rect.y, rect.width, rect.height}, layout, out,
                                    stride);
    const int top = m_target->row(rect.y + rect.height - 1);
    raster::resolve_rect(*m_target, {rect.x, top, rect.width, rect.height}, layout,
                         out + (rect.height - 1) * stride, -stride);
}

void ReadSource::read_depths(int x, int y, int count, uint32_t* depths) const {
    const raster::TargetUse use(*m_target, m_plane);
    raster::read_depth(*m_target, x, m_target->row(y), count, depths);
}

void ReadSource::read_stencils(int x, int y, int count, uint8_t* stencils) const {
    const raster::TargetUse use(*m_target, m_plane);
    raster::read_stencil(*m_target, x, m_target->row(y), count, stencils);
}

}  // namespace terrazzo::gl
