// Access to the finished render target.
#include "gl/read_source.h"

#include <algorithm>

#include "gl/context.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_transfer.h"
#include "pipeline/read_row.h"

namespace terrazzo::gl {
namespace {

Drawable& finished_drawable(Context& ctx) {
    finish_drawing(ctx);
    return *ctx.surface.read;
}

}  // namespace

bool has_read_source(const Context& ctx) {
    return ctx.surface.read && ctx.surface.read->target();
}

ReadSource::ReadSource(Context& ctx)
    : m_drawable(finished_drawable(ctx)), m_selected(m_drawable.selected()), m_target(*m_drawable.target()) {
    m_drawable.select(read_color_buffer(ctx));
}

ReadSource::~ReadSource() {
    m_drawable.select(m_selected);
}

ReadRect ReadSource::clip(GLint x, GLint y, GLsizei width, GLsizei height) const {
    const int64_t x0 = std::max(x, 0), x1 = std::min(int64_t{x} + width, int64_t{m_target.width()});
    const int64_t y0 = std::max(y, 0), y1 = std::min(int64_t{y} + height, int64_t{m_target.height()});
    if (x0 >= x1 || y0 >= y1) return {};
    return {static_cast<GLint>(x0),        static_cast<GLint>(y0),       static_cast<GLsizei>(x1 - x0),
            static_cast<GLsizei>(y1 - y0), static_cast<GLsizei>(x0 - x), static_cast<GLsizei>(y0 - y)};
}

bool ReadSource::has_bytes(const PixelState& pixels) const {
    return pipeline::fits_rgba8(m_target.format().color) && !changes_colors(pixels);
}

void ReadSource::read(int x, int y, int count, uint8_t* rgba) const {
    pipeline::read_color_rgba8(m_target, x, m_target.row(y), count, rgba);
}

void ReadSource::read(int x, int y, int count, const PixelState& pixels, float* rgba) const {
    pipeline::read_color_float(m_target, x, m_target.row(y), count, rgba);
    if (!changes_colors(pixels)) return;
    transfer_colors(pixels, rgba, count);
    if (m_target.format().color == raster::ColorFormat::kRgba32F) return;
    std::transform(rgba, rgba + 4 * count, rgba, clamp_to_unit);
}

}  // namespace terrazzo::gl
