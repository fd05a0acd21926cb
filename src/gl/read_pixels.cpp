// ReadPixels (GL 1.5 §4.3.2): rows of the frame buffer through pixel transfer and pack modes into client
// memory.
//
// Pixels outside the window leave the client's memory as it is.
#include <algorithm>
#include <optional>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_order.h"
#include "gl/pixel_transfer.h"
#include "gl/read_source.h"
#include "gl/texel_row.h"

namespace terrazzo::gl {
namespace {

// One run of pixels of the request: in the window at (x, y), in client memory at `destination`.
struct Run {
    int x, y, count;
    uint8_t* destination;
    int first_bit;  // for GL_BITMAP
};

class PixelReader {
  public:
    PixelReader(Context& ctx, GLenum format, GLenum type)
        : m_state(ctx.pixels), m_source(ctx), m_format(format), m_type(type) {}

    void read(GLint x, GLint y, GLsizei width, GLsizei height, void* pixels) const {
        const ReadRect rect = m_source.clip(x, y, width, height);
        const ImageLayout layout = image_layout(m_state.pack, width, m_format, m_type);
        const size_t pixel_size = bytes_per_pixel(m_format, m_type);
        const auto columns = static_cast<size_t>(rect.skipped_columns);
        auto* row = static_cast<uint8_t*>(pixels) + layout.offset +
                    static_cast<size_t>(rect.skipped_rows) * layout.row_stride + columns * pixel_size;
        if (const auto direct = direct_layout())
            return m_source.read(rect, *direct, reinterpret_cast<std::byte*>(row),
                                 static_cast<std::ptrdiff_t>(layout.row_stride));
        for (int i = 0; i < rect.height; ++i, row += layout.row_stride) {
            for (int j = 0; j < rect.width; j += kPixelChunk) {
                read_run({rect.x + j, rect.y + i, std::min(kPixelChunk, rect.width - j),
                          row + static_cast<size_t>(j) * pixel_size,
                          layout.first_bit + rect.skipped_columns + j});
            }
        }
    }

  private:
    void read_run(const Run& run) const {
        switch (m_format) {
            case GL_DEPTH_COMPONENT:
                return read_depths(run);
            case GL_STENCIL_INDEX:
                return read_stencils(run);
            case GL_DEPTH_STENCIL:
                return read_depths_and_stencils(run);
            default:
                return is_luminance() ? read_luminances(run) : read_colors(run);
        }
    }

    // What programs ask for most leaves the tiles in their form: no row is written down in between.
    std::optional<raster::PixelLayout> direct_layout() const {
        using raster::PixelLayout;
        if (m_format == GL_DEPTH_COMPONENT) {
            if (m_state.pack.swap_bytes || changes_depths(m_state)) return std::nullopt;
            return m_type == GL_FLOAT          ? std::optional(PixelLayout::kDepth32F)
                   : m_type == GL_UNSIGNED_INT ? std::optional(PixelLayout::kDepth32)
                                               : std::nullopt;
        }
        const raster::TargetFormat& format = m_source.format();
        Order order;
        if (!is_color_format(m_format) || is_luminance() || format.color != raster::ColorFormat::kRgba8 ||
            changes_colors(m_state) || !are_bytes(m_format, m_type, m_state.pack.swap_bytes, order))
            return std::nullopt;
        switch (order) {
            case Order::kRgb:
                return PixelLayout::kRgb8;
            case Order::kBgr:
                return PixelLayout::kBgr8;
            case Order::kRgba:
                return format.has_alpha ? PixelLayout::kRgba8 : PixelLayout::kRgbx8;
            case Order::kBgra:
                return format.has_alpha ? std::optional(PixelLayout::kBgra8) : std::nullopt;
            case Order::kArgb:
                return format.has_alpha ? std::optional(PixelLayout::kArgb8) : std::nullopt;
            default:
                return std::nullopt;
        }
    }

    bool is_luminance() const { return m_format == GL_LUMINANCE || m_format == GL_LUMINANCE_ALPHA; }

    void read_colors(const Run& run) const {
        if (m_source.has_bytes(m_state) && goes_through_bytes()) {
            uint8_t rgba[4 * kPixelChunk];
            m_source.read(run.x, run.y, run.count, rgba);
            pack_rgba8(m_format, m_type, m_state.pack.swap_bytes, rgba, run.count, run.destination);
            return;
        }
        float rgba[4 * kPixelChunk];
        m_source.read(run.x, run.y, run.count, m_state, rgba);
        pack_rgba_float(m_format, m_type, m_state.pack.swap_bytes, rgba, run.count, run.destination);
    }

    // Components below 8 bits are read as bytes by types that have no more.
    bool goes_through_bytes() const {
        return m_source.format().color == raster::ColorFormat::kRgba8 || has_8_bit_components(m_type);
    }

    // L is R + G + B.
    void read_luminances(const Run& run) const {
        float rgba[4 * kPixelChunk];
        m_source.read(run.x, run.y, run.count, m_state, rgba);
        const bool clamps = m_source.format().color != raster::ColorFormat::kRgba32F;
        for (int i = 0; i < run.count; ++i) {
            const float sum = rgba[4 * i] + rgba[4 * i + 1] + rgba[4 * i + 2];
            rgba[4 * i] = clamps ? std::min(sum, 1.0f) : sum;
        }
        pack_rgba_float(m_format, m_type, m_state.pack.swap_bytes, rgba, run.count, run.destination);
    }

    void read_depths(const Run& run) const {
        uint32_t integers[kPixelChunk];
        m_source.read_depths(run.x, run.y, run.count, integers);
        const int bits = m_source.format().depth_bits;
        const bool swap_bytes = m_state.pack.swap_bytes;
        const double scale = 1.0 / static_cast<double>((uint64_t{1} << bits) - 1);
        float depths[kPixelChunk];
        for (int i = 0; i < run.count; ++i) depths[i] = static_cast<float>(integers[i] * scale);
        if (changes_depths(m_state)) transfer_depths(m_state, depths, run.count);
        pack_depths(m_type, swap_bytes, depths, run.count, run.destination);
    }

    void read_indices(const Run& run, uint32_t* indices) const {
        uint8_t bytes[kPixelChunk];
        m_source.read_stencils(run.x, run.y, run.count, bytes);
        std::copy_n(bytes, run.count, indices);
        if (changes_stencils(m_state)) transfer_stencils(m_state, indices, run.count);
    }

    void read_depths_and_stencils(const Run& run) const {
        uint32_t depths[kPixelChunk], indices[kPixelChunk];
        m_source.read_depths(run.x, run.y, run.count, depths);
        const auto bits = static_cast<unsigned>(m_source.format().depth_bits);
        if (bits != 24)
            for (int i = 0; i < run.count; ++i) depths[i] = resize_depth(depths[i], bits, 24);
        transfer_packed_depths(m_state, depths, run.count, 24);
        read_indices(run, indices);
        pack_depths_and_stencils(m_state.pack.swap_bytes, depths, indices, run.count, run.destination);
    }

    void read_stencils(const Run& run) const {
        uint32_t indices[kPixelChunk];
        read_indices(run, indices);
        pack_indices(m_type, m_state.pack.swap_bytes, m_state.pack.lsb_first, indices, run.count,
                     run.destination, run.first_bit);
    }

    const PixelState& m_state;
    ReadSource m_source;
    GLenum m_format, m_type;
};

Rule check_buffers(const Context& ctx, GLenum format) {
    const auto target = read_target(ctx);
    if (!target) return {GL_INVALID_FRAMEBUFFER_OPERATION, "there is no buffer to read from"};
    const raster::TargetFormat& source = target->format();
    if (format == GL_COLOR_INDEX) return {GL_INVALID_OPERATION, "the frame buffer holds no colour indices"};
    if (is_color_format(format) && !has_read_colors(ctx)) {
        return {GL_INVALID_OPERATION, "there is no colour buffer"};
    }
    const bool both = format == GL_DEPTH_STENCIL;
    if ((format == GL_DEPTH_COMPONENT || both) && source.depth_bits == 0) {
        return {GL_INVALID_OPERATION, "there is no depth buffer"};
    }
    if ((format == GL_STENCIL_INDEX || both) && source.stencil_bits == 0) {
        return {GL_INVALID_OPERATION, "there is no stencil buffer"};
    }
    return {};
}

}  // namespace

void read_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 void* pixels) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    if (!check_readable_framebuffer(ctx)) return;
    Rule rule = check_client_pixel(format, type);
    if (rule.code == GL_NO_ERROR) rule = check_buffers(ctx, format);
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    const PixelMemory memory = find_image(ctx, ctx.pixels.pack, {width, height}, format, type, pixels);
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    if (memory.data) PixelReader(ctx, format, type).read(x, y, width, height, memory.data);
}

}  // namespace terrazzo::gl
