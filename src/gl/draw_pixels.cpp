// DrawPixels (GL 1.5 §3.6.4): client pixels through pixel transfer become the colours, depths or stencil
// values of a rectangle of tiles.
#include <algorithm>
#include <cmath>

#include "gl/client_pixel.h"
#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/pixel_buffers.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_tiles.h"
#include "gl/pixel_transfer.h"

namespace terrazzo::gl {
namespace {

// Client memory as rows of pixels.
class ClientRows {
  public:
    ClientRows(const Context& ctx, GLsizei width, GLenum format, GLenum type, const void* pixels)
        : m_state(ctx.pixels),
          m_format(format),
          m_type(type),
          m_layout(image_layout(m_state.unpack, width, format, type)),
          m_pixels(static_cast<const uint8_t*>(pixels) + m_layout.offset),
          m_clamps(ctx.surface.format.color != raster::ColorFormat::kRgba32F),
          m_depth_bits(ctx.surface.format.depth_bits) {}

    // Whether colours are bytes and stay so.
    bool has_bytes() const {
        return m_format != GL_COLOR_INDEX && has_8_bit_components(m_type) && !changes_colors(m_state);
    }

    void read(int row, int first, int count, uint32_t* colors) const {
        in_chunks(row, first, count, [&](const uint8_t* from, int, int done, int size) {
            unpack_rgba8(m_format, m_type, m_state.unpack.swap_bytes, from, size,
                         reinterpret_cast<uint8_t*>(colors + done));
        });
    }

    void read(int row, int first, int count, FloatColor::Pixel* colors) const {
        in_chunks(row, first, count, [&](const uint8_t* from, int first_bit, int done, int size) {
            float* const rgba = colors[done].rgba;
            if (m_format == GL_COLOR_INDEX) {
                uint32_t indices[kPixelChunk];
                read_indices(from, first_bit, size, indices);
                return transfer_indices_to_colors(m_state, indices, size, rgba);
            }
            unpack_rgba_float(m_format, m_type, m_state.unpack.swap_bytes, from, size, rgba);
            if (changes_colors(m_state)) transfer_colors(m_state, rgba, size);
            if (m_clamps) std::transform(rgba, rgba + 4 * size, rgba, clamp_to_unit);
        });
    }

    void read_depths(int row, int first, int count, uint32_t* depths) const {
        const float maximum = m_depth_bits == 16 ? 65535.0f : 16777215.0f;
        in_chunks(row, first, count, [&](const uint8_t* from, int, int done, int size) {
            if (m_format == GL_DEPTH_STENCIL) {
                uint32_t indices[kPixelChunk];
                unpack_depths_and_stencils(m_state.unpack.swap_bytes, from, size, depths + done, indices);
                return transfer_packed_depths(m_state, depths + done, size, m_depth_bits);
            }
            float z[kPixelChunk];
            unpack_depths(m_type, m_state.unpack.swap_bytes, from, size, z);
            if (changes_depths(m_state)) transfer_depths(m_state, z, size);
            // These the reference cuts to 16 bits again where it has scaled them.
            if (m_type == GL_UNSIGNED_SHORT && changes_depths(m_state))
                for (int i = 0; i < size; ++i)
                    z[i] = static_cast<float>(static_cast<int>(clamp_to_unit(z[i]) * 65535.0f)) *
                           (1.0f / 65535.0f);
            for (int i = 0; i < size; ++i)
                depths[done + i] = static_cast<uint32_t>(std::lrint(clamp_to_unit(z[i]) * maximum));
        });
    }

    void read_stencils(int row, int first, int count, uint8_t* values) const {
        in_chunks(row, first, count, [&](const uint8_t* from, int first_bit, int done, int size) {
            uint32_t indices[kPixelChunk], depths[kPixelChunk];
            if (m_format == GL_DEPTH_STENCIL)
                unpack_depths_and_stencils(m_state.unpack.swap_bytes, from, size, depths, indices);
            else
                read_indices(from, first_bit, size, indices);
            if (changes_stencils(m_state)) transfer_stencils(m_state, indices, size);
            for (int i = 0; i < size; ++i) values[done + i] = static_cast<uint8_t>(indices[i]);
        });
    }

  private:
    // Calls convert(bytes, first bit of a bitmap, pixels done, pixels to do) for pieces that fit scratch
    // rows.
    template <typename Convert>
    void in_chunks(int row, int first, int count, Convert convert) const {
        const uint8_t* const bytes = m_pixels + static_cast<std::size_t>(row) * m_layout.row_stride;
        const std::size_t pixel = m_type == GL_BITMAP ? 0 : bytes_per_pixel(m_format, m_type);
        for (int done = 0; done < count; done += kPixelChunk) {
            const int at = first + done;
            convert(bytes + static_cast<std::size_t>(at) * pixel, m_layout.first_bit + at, done,
                    std::min(kPixelChunk, count - done));
        }
    }

    void read_indices(const uint8_t* from, int first_bit, int count, uint32_t* indices) const {
        unpack_indices(m_type, m_state.unpack.swap_bytes, m_state.unpack.lsb_first, from, first_bit, count,
                       indices);
    }

    const PixelState& m_state;
    GLenum m_format, m_type;
    ImageLayout m_layout;
    const uint8_t* m_pixels;
    bool m_clamps;
    int m_depth_bits;
};

void draw_rows(Context& ctx, GLenum format, const PixelGrid& grid, const ClientRows& rows) {
    const auto draw = [&](raster::PixelImage image, pipeline::PixelRect rect) {
        draw_pixel_rect(ctx, image, rect, format == GL_DEPTH_STENCIL);
    };
    const auto read = [&](int row, int first, int count, auto* pixels) {
        rows.read(row, first, count, pixels);
    };
    const bool both = format == GL_DEPTH_STENCIL;
    if (format == GL_STENCIL_INDEX || both) {
        draw(raster::PixelImage::kStencil,
             make_pixel_rect<StencilValue>(grid, [&](int row, int first, int count, uint8_t* values) {
                 rows.read_stencils(row, first, count, values);
             }));
        if (!both) return;
    }
    if (format == GL_DEPTH_COMPONENT || both) {
        return draw(raster::PixelImage::kDepth,
                    make_pixel_rect<Depth>(grid, [&](int row, int first, int count, uint32_t* depths) {
                        rows.read_depths(row, first, count, depths);
                    }));
    }
    if (rows.has_bytes()) return draw(raster::PixelImage::kRgba8, make_pixel_rect<ByteColor>(grid, read));
    draw(raster::PixelImage::kRgba32F, make_pixel_rect<FloatColor>(grid, read));
}

Rule check_buffer(const raster::TargetFormat& target, GLenum format) {
    const bool both = format == GL_DEPTH_STENCIL;
    if ((format == GL_DEPTH_COMPONENT || both) && target.depth_bits == 0)
        return {GL_INVALID_OPERATION, "there is no depth buffer"};
    if ((format == GL_STENCIL_INDEX || both) && target.stencil_bits == 0)
        return {GL_INVALID_OPERATION, "there is no stencil buffer"};
    return {};
}

}  // namespace

void draw_pixels(Context& ctx, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const void* pixels) {
    if (width < 0 || height < 0) return record_error(ctx, GL_INVALID_VALUE, "width or height is negative");
    if (!check_framebuffer(ctx)) return;
    Rule rule = check_client_pixel(format, type);
    if (rule.code == GL_NO_ERROR) rule = check_buffer(ctx.surface.format, format);
    if (rule.code != GL_NO_ERROR) return record_error(ctx, rule.code, rule.words);
    if (!ctx.raster_position.valid || !(pixels || ctx.pixels.unpack.buffer)) return;
    if (ctx.render_mode.mode != GL_RENDER) return capture_raster(ctx, GL_DRAW_PIXEL_TOKEN);
    const PixelMemory memory = find_image(ctx, ctx.pixels.unpack, {width, height}, format, type, pixels);
    if (!memory.is_usable()) return record_error(ctx, memory.rule.code, memory.rule.words);
    begin_drawing(ctx);
    const PixelGrid grid = make_pixel_grid(ctx, width, height);
    if (!grid.empty()) draw_rows(ctx, format, grid, ClientRows(ctx, width, format, type, memory.data));
}

}  // namespace terrazzo::gl
