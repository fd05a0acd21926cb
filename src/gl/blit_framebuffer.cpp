// BlitFramebuffer (ARB_framebuffer_object): a rectangle of the buffers read from, scaled or turned into one
// of the buffers drawn to. The scissor cuts it, nothing else of the fragments' way touches it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>
#include <vector>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/framebuffer_object.h"
#include "gl/generated/commands.h"
#include "gl/read_source.h"
#include "raster/target/copy_between.h"
#include "raster/target/copy_out.h"
#include "raster/target/read_row.h"
#include "raster/target/write_row.h"

namespace terrazzo::gl {
namespace {

// One axis: destination pixels first to last - 1, and where their centres lie in the source.
struct Axis {
    int first = 0, last = 0;
    double origin = 0, scale = 0;
    int low = 0, high = 0;  // source pixels that may be read: low to high - 1

    Axis(GLint source0, GLint source1, GLint to0, GLint to1, int source_size, int clip0, int clip1) {
        const double length = static_cast<double>(to1) - to0;
        if (length == 0 || source0 == source1) return;
        scale = (static_cast<double>(source1) - source0) / length;
        origin = source0 - scale * to0;
        low = std::max(std::min(source0, source1), 0);
        high = std::min(std::max(source0, source1), source_size);
        first = std::max(std::min(to0, to1), clip0);
        last = std::min(std::max(to0, to1), clip1);
        // What would come from outside the source stays as it is.
        while (first < last && !is_inside(first)) ++first;
        while (first < last && !is_inside(last - 1)) --last;
    }
    double at(int pixel) const { return origin + scale * (pixel + 0.5); }
    bool is_inside(int pixel) const { return at(pixel) >= low && at(pixel) < high; }
    bool keeps_size() const { return scale == 1; }
    // Each pixel to one, perhaps in the other order.
    bool keeps_pixels() const { return scale == 1 || scale == -1; }
    bool keeps_places() const { return keeps_size() && origin == 0; }
    int nearest(int pixel) const {
        return std::clamp(static_cast<int>(std::floor(at(pixel))), low, high - 1);
    }
};

// The two source pixels that a destination pixel lies between, and the second's share.
struct Between {
    int first, second;
    float share;

    Between(const Axis& axis, int pixel) {
        const double at = axis.at(pixel) - 0.5, base = std::floor(at);
        first = std::clamp(static_cast<int>(base), axis.low, axis.high - 1);
        second = std::clamp(static_cast<int>(base) + 1, axis.low, axis.high - 1);
        share = static_cast<float>(at - base);
    }
};

// A target that holds what the selected colour buffer of another does, and neither depth nor stencil.
std::unique_ptr<raster::Target> copy_of_colors(raster::Target& from) {
    raster::TargetFormat format = from.format();
    format.depth_bits = format.stencil_bits = 0;
    auto out = std::make_unique<raster::Target>(from.width(), from.height(), format);
    const auto bytes = static_cast<size_t>(raster::kBinPixels) *
                       static_cast<size_t>(raster::bytes_per_pixel(format.color)) * format.samples;
    for (int i = 0; i < from.bin_count(); ++i) {
        from.materialize_to_read(i);
        out->materialize(i);
        const raster::Bin source = from.bin(i), copy = out->bin(i);
        std::memcpy(copy.color, source.color, bytes);
        if (source.color_alike) std::memcpy(copy.color_alike, source.color_alike, raster::kBinTiles);
    }
    return out;
}

class Blit {
  public:
    // Depth and stencil come from `source`, colours from `colors`, which may be the same.
    Blit(raster::Target& source, raster::Target& colors, raster::Target& to, const Axis& across,
         const Axis& up)
        : m_source(source), m_colors(colors), m_to(to), m_across(across), m_up(up) {}

    // Between pixels that lie on one another there is nothing to mix.
    void colors(GLenum filter) const {
        const bool in_place = filter == GL_NEAREST || m_colors.format().samples == 1;
        if (in_place && keeps_colors() && is_copy())
            return raster::copy_rgba8(m_colors, m_to, copy_of(m_colors));
        filter == GL_LINEAR ? linear_colors() : nearest_colors();
    }
    void depths() const {
        if (is_copy()) return raster::copy_depths(m_source, m_to, copy_of(m_source));
        std::vector<uint32_t> from, to;
        copy(
            m_source, from, to, 1,
            [&](int row) { raster::read_depth(m_source, m_across.low, row, width(), from.data()); },
            [&](int row) { raster::write_depth(m_to, m_across.first, row, count(), to.data()); });
    }
    void stencils() const {
        std::vector<uint8_t> from, to;
        copy(
            m_source, from, to, 1,
            [&](int row) { raster::read_stencil(m_source, m_across.low, row, width(), from.data()); },
            [&](int row) { raster::write_stencil(m_to, m_across.first, row, count(), to.data()); });
    }
    // All samples as they are, from one multisampled buffer to another.
    void samples(raster::ClearPlanes planes) const {
        raster::Target& from = planes.color ? m_colors : m_source;
        for (int y = m_up.first; y < m_up.last; ++y)
            for (int x = m_across.first; x < m_across.last; ++x)
                raster::copy_samples({from, m_across.nearest(x), from.row(m_up.nearest(y))},
                                     {m_to, x, m_to.row(y)}, planes);
    }

  private:
    // Whether columns stay where they are and rows are neither mixed nor left out.
    bool is_copy() const {
        return m_across.keeps_places() && m_up.keeps_pixels() && m_to.format().samples == 1;
    }
    raster::Copy copy_of(const raster::Target& source) const {
        const int lowest = source.row(m_up.nearest(m_up.first)),
                  highest = source.row(m_up.nearest(m_up.last - 1));
        const bool up = lowest <= highest;
        const int first = m_to.row(up ? m_up.first : m_up.last - 1),
                  last = m_to.row(up ? m_up.last - 1 : m_up.first);
        return {{m_across.first, std::min(lowest, highest), count(), m_up.last - m_up.first},
                first,
                last < first};
    }
    // Bytes for bytes.
    bool keeps_colors() const {
        const raster::TargetFormat &from = m_colors.format(), &to = m_to.format();
        return from.color == raster::ColorFormat::kRgba8 && to.color == raster::ColorFormat::kRgba8 &&
               from.has_alpha;
    }
    // The same, neither scaled nor turned.
    bool copies_bytes() const { return keeps_colors() && m_across.keeps_size() && m_up.keeps_size(); }
    void copy_bytes() const {
        const auto width = static_cast<size_t>(count());
        std::vector<uint8_t> rows(4 * width * raster::kBinSize);
        const auto stride = static_cast<std::ptrdiff_t>(4 * width);
        // As many rows at a time as lie in one row of the source's bins.
        const int first = m_colors.row(m_up.nearest(m_up.first)),
                  last = m_colors.row(m_up.nearest(m_up.last - 1));
        for (int low = std::min(first, last), end = std::max(first, last) + 1, next; low < end; low = next) {
            next = std::min(end, (low / raster::kBinSize + 1) * raster::kBinSize);
            raster::resolve_rect(m_colors, {m_across.nearest(m_across.first), low, count(), next - low},
                                 raster::PixelLayout::kRgba8, reinterpret_cast<std::byte*>(rows.data()),
                                 stride);
            for (int row = low; row < next; ++row) {
                const int above = std::abs(row - first);
                raster::write_color_rgba8(m_to, m_across.first, m_to.row(m_up.first + above), count(),
                                          rows.data() + static_cast<size_t>(row - low) * 4 * width);
            }
        }
    }
    void nearest_colors() const {
        if (copies_bytes()) return copy_bytes();
        std::vector<float> from, to;
        copy(
            m_colors, from, to, 4,
            [&](int row) { raster::read_color_float(m_colors, m_across.low, row, width(), from.data()); },
            [&](int row) { raster::write_color(m_to, m_across.first, row, count(), to.data()); });
    }
    void linear_colors() const {
        std::vector<float> low(4 * static_cast<size_t>(width())), high(low),
            to(4 * static_cast<size_t>(count()));
        for (int y = m_up.first; y < m_up.last; ++y) {
            const Between rows(m_up, y);
            raster::read_color_float(m_colors, m_across.low, m_colors.row(rows.first), width(), low.data());
            raster::read_color_float(m_colors, m_across.low, m_colors.row(rows.second), width(), high.data());
            for (int x = 0; x < count(); ++x) {
                const Between columns(m_across, m_across.first + x);
                const auto a = 4 * static_cast<size_t>(columns.first - m_across.low),
                           b = 4 * static_cast<size_t>(columns.second - m_across.low);
                for (size_t c = 0; c < 4; ++c) {
                    const float below = low[a + c] + columns.share * (low[b + c] - low[a + c]);
                    const float above = high[a + c] + columns.share * (high[b + c] - high[a + c]);
                    to[4 * static_cast<size_t>(x) + c] = below + rows.share * (above - below);
                }
            }
            raster::write_color(m_to, m_across.first, m_to.row(y), count(), to.data());
        }
    }

    int width() const { return m_across.high - m_across.low; }
    int count() const { return m_across.last - m_across.first; }

    template <typename T, typename Read, typename Write>
    void copy(const raster::Target& source, std::vector<T>& from, std::vector<T>& to, size_t components,
              Read read, Write write) const {
        from.resize(components * static_cast<size_t>(width()));
        to.resize(components * static_cast<size_t>(count()));
        for (int y = m_up.first; y < m_up.last; ++y) {
            read(source.row(m_up.nearest(y)));
            for (int x = 0; x < count(); ++x) {
                const auto column = static_cast<size_t>(m_across.nearest(m_across.first + x) - m_across.low);
                std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(components * column), components,
                            to.begin() + static_cast<std::ptrdiff_t>(components * static_cast<size_t>(x)));
            }
            write(m_to.row(y));
        }
    }

    raster::Target &m_source, &m_colors, &m_to;
    const Axis &m_across, &m_up;
};

// The planes of two targets, or of one, for the calling thread alone; whoever else wants both may name them
// in the other order.
class PairUse {
  public:
    PairUse(const raster::Target& from, const raster::Target& to)
        : m_from(from.mutex(), std::defer_lock), m_to(to.mutex(), std::defer_lock) {
        &from == &to ? m_to.lock() : std::lock(m_from, m_to);
    }

  private:
    std::unique_lock<std::mutex> m_from, m_to;
};

// Does something for each colour buffer that is drawn to, while it is in its place.
template <typename Do>
void for_each_drawn_color(raster::Target& target, pipeline::DrawnColors colors, Do draw) {
    target.select_color(pipeline::shown_color(colors));
    draw();
    if (colors != pipeline::DrawnColors::kBoth) return;
    target.select_color(raster::ColorPlane::kSecond);
    draw();
}

}  // namespace

void blit_framebuffer(Context& ctx, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0,
                      GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter) {
    constexpr GLbitfield kBuffers = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    if (mask & ~kBuffers) return record_error(ctx, GL_INVALID_VALUE, "mask has bits that name no buffer");
    if (filter != GL_NEAREST && filter != GL_LINEAR)
        return record_error(ctx, GL_INVALID_ENUM, "the filter is neither nearest nor linear");
    if (filter == GL_LINEAR && (mask & ~static_cast<GLbitfield>(GL_COLOR_BUFFER_BIT)))
        return record_error(ctx, GL_INVALID_OPERATION, "depth and stencil are not filtered");
    if (!check_framebuffer(ctx) || !check_read_framebuffer(ctx)) return;
    if (!ctx.renderer.target() || !has_read_source(ctx))
        return record_error(ctx, GL_INVALID_FRAMEBUFFER_OPERATION, "there is no buffer");
    flush_vertices(ctx);
    begin_drawing(ctx);
    const std::shared_ptr<raster::Target> target = ctx.renderer.target(), known = read_target(ctx);
    const raster::TargetFormat &from = known->format(), &to = target->format();
    const bool depth = (mask & GL_DEPTH_BUFFER_BIT) && from.depth_bits != 0 && to.depth_bits != 0;
    const bool stencil = (mask & GL_STENCIL_BUFFER_BIT) && from.stencil_bits != 0 && to.stencil_bits != 0;
    const bool color = (mask & GL_COLOR_BUFFER_BIT) && draws_colors(ctx) &&
                       ctx.framebuffer.read_buffer != GL_NONE && has_read_colors(ctx);
    if (depth && from.depth_bits != to.depth_bits)
        return record_error(ctx, GL_INVALID_OPERATION, "the depth buffers are of different formats");
    const bool same_size = std::abs(int64_t{srcX1} - srcX0) == std::abs(int64_t{dstX1} - dstX0) &&
                           std::abs(int64_t{srcY1} - srcY0) == std::abs(int64_t{dstY1} - dstY0);
    if ((from.samples > 1 || to.samples > 1) && !same_size)
        return record_error(ctx, GL_INVALID_OPERATION, "samples are not scaled");
    const ReadSource source(ctx);
    raster::Target& read = source.target();
    pipeline::RasterState box;
    scissor_box(ctx, box);
    const Axis across(srcX0, srcX1, dstX0, dstX1, read.width(), box.x0, box.x1);
    const raster::RowRange rows = ctx.surface.rows(box.y0, box.y1);
    const Axis up(srcY0, srcY1, dstY0, dstY1, read.height(), static_cast<int>(rows.first),
                  static_cast<int>(rows.end));
    if (across.first >= across.last || up.first >= up.last) return;
    const pipeline::DrawnColors colors = ctx.renderer.colors();
    const PairUse use(read, *target);
    read.select_color(source.plane());
    // Only one of a target's two colour buffers can be had at a time.
    std::unique_ptr<raster::Target> aside;
    if (color && &read == target.get() &&
        (colors == pipeline::DrawnColors::kBoth || source.plane() != pipeline::shown_color(colors)))
        aside = copy_of_colors(read);
    const Blit blit(read, aside ? *aside : read, *target, across, up);
    const bool keeps_samples = from.samples > 1 && to.samples > 1;
    if (color) {
        for_each_drawn_color(*target, colors, [&] {
            keeps_samples ? blit.samples({true, false, false}) : blit.colors(filter);
        });
    }
    if (!depth && !stencil) return;
    if (keeps_samples) return blit.samples({false, depth, stencil});
    if (depth) blit.depths();
    if (stencil) blit.stencils();
}

}  // namespace terrazzo::gl
