// Accum, and the clear of the accumulation buffer, on the calling thread: what is queued is drawn before it
// is read, and GL_RETURN queues a rectangle of pixels.
#include "gl/accumulation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/generated/commands.h"
#include "gl/pixel_convert.h"
#include "gl/pixel_tiles.h"
#include "gl/read_source.h"
#include "raster/target/read_row.h"

namespace terrazzo::gl {
namespace {

constexpr float kOne = 32767.0f;

// Cut off, and at the ends of the range where the sum or product leaves it.
std::int16_t to_fraction(float value) {
    const float not_low = value > -32768.0f ? value : -32768.0f;
    return static_cast<std::int16_t>(not_low < kOne ? not_low : kOne);
}

std::int16_t sum(std::int16_t a, std::int16_t b) {
    return static_cast<std::int16_t>(std::clamp(int{a} + b, -32768, 32767));
}

pipeline::RasterState box_of(const Context& ctx) {
    pipeline::RasterState box;
    scissor_box(ctx, box);
    return box;
}

// As large as what is drawn to.
std::shared_ptr<AccumulationPlane> plane_of(Context& ctx) {
    return ctx.surface.draw->accumulation(*ctx.renderer.target());
}

// Calls visit(first component of a row's part, components) for each row of the scissor box.
template <typename Visit>
void for_each_row(Context& ctx, Visit visit) {
    const pipeline::RasterState box = box_of(ctx);
    const auto plane = plane_of(ctx);
    const std::lock_guard lock(plane->mutex());
    for (int row = box.y0; row < box.y1; ++row) visit(plane->pixel(box.x0, row), 4 * (box.x1 - box.x0));
}

void add(Context& ctx, float value) {
    const std::int16_t increment = to_fraction(value * kOne);
    for_each_row(ctx, [&](std::int16_t* values, int count) {
        for (int i = 0; i < count; ++i) values[i] = sum(values[i], increment);
    });
}

void multiply(Context& ctx, float value) {
    for_each_row(ctx, [&](std::int16_t* values, int count) {
        for (int i = 0; i < count; ++i) values[i] = to_fraction(static_cast<float>(values[i]) * value);
    });
}

// What each byte of a colour counts.
using Shares = std::array<std::int16_t, 256>;

Shares shares_of(float scale) {
    Shares shares;
    for (std::size_t i = 0; i < shares.size(); ++i)
        shares[i] = to_fraction(static_cast<float>(i) / 255.0f * scale);
    return shares;
}

// Adds colours, or puts them in place of what is there.
void accumulate(Context& ctx, float value, bool replaces) {
    const ReadSource source(ctx);
    raster::Target& target = source.target();
    pipeline::RasterState box = box_of(ctx);
    // A front buffer may have another size by now than what is drawn to.
    box.x1 = std::min(box.x1, target.width());
    box.y1 = std::min(box.y1, target.height());
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
    const auto plane = plane_of(ctx);
    const std::lock_guard lock(plane->mutex());
    const int count = 4 * (box.x1 - box.x0);
    const float scale = value * kOne;
    const auto store = [&](std::int16_t* to, auto share) {
        for (int i = 0; i < count; ++i) to[i] = replaces ? share(i) : sum(to[i], share(i));
    };
    if (source.format().color == raster::ColorFormat::kRgba8) {
        const Shares shares = shares_of(scale);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count));
        for (int row = box.y0; row < box.y1; ++row) {
            {
                const raster::TargetUse use(target, source.plane());
                raster::read_color_rgba8(target, box.x0, row, count / 4, bytes.data());
            }
            store(plane->pixel(box.x0, row),
                  [&](int i) { return shares[bytes[static_cast<std::size_t>(i)]]; });
        }
        return;
    }
    std::vector<float> colors(static_cast<std::size_t>(count));
    for (int row = box.y0; row < box.y1; ++row) {
        {
            const raster::TargetUse use(target, source.plane());
            raster::read_color_float(target, box.x0, row, count / 4, colors.data());
        }
        store(plane->pixel(box.x0, row),
              [&](int i) { return to_fraction(colors[static_cast<std::size_t>(i)] * scale); });
    }
}

// Rounds to the nearest value of the target, which drawing would cut off.
void round_colors(raster::ColorFormat format, float* rgba, int count) {
    if (format != raster::ColorFormat::kRgb565) return;
    constexpr float kMaxima[4] = {31, 63, 31, 1};
    for (int i = 0; i < count; ++i)
        rgba[i] = std::nearbyint(clamp_to_unit(rgba[i]) * kMaxima[i & 3]) / kMaxima[i & 3];
}

// Nothing but the colour mask is between the buffers.
std::shared_ptr<const pipeline::FragmentBlock> return_fragment(const Context& ctx, raster::PixelImage image) {
    auto block = std::make_shared<pipeline::FragmentBlock>();
    raster::FragmentKey& key = block->fill.key;
    key.color_format = ctx.surface.format.color;
    key.color_mask = 0;
    for (std::size_t c = 0; c < 4; ++c)
        key.color_mask |= static_cast<std::uint8_t>(ctx.fragment_ops.color.write_mask[c] << c);
    key.perspective = key.interpolated_color = false;
    key.image =
        image == raster::PixelImage::kRgba8 && key.color_mask == 0xf ? raster::PixelImage::kVerbatim : image;
    block->fill.has_destination_alpha = ctx.surface.format.has_alpha;
    block->complete(false, false);
    return block;
}

// Every pixel of the scissor box shows itself.
PixelGrid box_grid(const pipeline::RasterState& box) {
    PixelGrid grid;
    grid.columns.first = box.x0;
    for (int x = box.x0; x < box.x1; ++x) grid.columns.sources.push_back(x);
    grid.rows.first = box.y0;
    for (int y = box.y0; y < box.y1; ++y) grid.rows.sources.push_back(y);
    return grid;
}

void return_colors(Context& ctx, float value) {
    begin_drawing(ctx);
    const pipeline::RasterState box = box_of(ctx);
    const PixelGrid grid = box_grid(box);
    if (grid.empty() || ctx.framebuffer.draw_buffer == GL_NONE) return;
    flush_vertices(ctx);
    const auto plane = plane_of(ctx);
    const float scale = value / kOne;
    const raster::ColorFormat format = ctx.surface.format.color;
    const bool bytes_do = format == raster::ColorFormat::kRgba8;
    const auto read_bytes = [&](int row, int first, int count, uint32_t* colors) {
        const std::int16_t* const values = plane->pixel(first, row);
        auto* const bytes = reinterpret_cast<std::uint8_t*>(colors);
        for (int i = 0; i < 4 * count; ++i)
            bytes[i] = static_cast<std::uint8_t>(
                round_to_int(clamp_to_unit(static_cast<float>(values[i]) * scale) * 255.0f));
    };
    const auto read_floats = [&](int row, int first, int count, FloatColor::Pixel* colors) {
        const std::int16_t* const values = plane->pixel(first, row);
        float* const rgba = colors->rgba;
        for (int i = 0; i < 4 * count; ++i) rgba[i] = static_cast<float>(values[i]) * scale;
        round_colors(format, rgba, 4 * count);
    };
    pipeline::PixelRect rect;
    {
        const std::lock_guard lock(plane->mutex());
        rect = bytes_do ? make_pixel_rect<ByteColor>(grid, read_bytes)
                        : make_pixel_rect<FloatColor>(grid, read_floats);
    }
    const auto image = bytes_do ? raster::PixelImage::kRgba8 : raster::PixelImage::kRgba32F;
    ctx.renderer.draw(box, return_fragment(ctx, image), rect);
}

// GL 1.5 table 2.9, the other way round. What is no number counts as the least, as in to_fraction.
std::int16_t clear_value(float component) {
    const float known = component > -1.0f ? component : -1.0f;
    return static_cast<std::int16_t>((static_cast<int>(65535.0f * known) - 1) / 2);
}

bool has_accumulation(const Context& ctx) {
    return ctx.config.accum_bits != 0 && !ctx.framebuffers.draw && ctx.surface.draw && ctx.surface.width != 0;
}

}  // namespace

AccumulationPlane::AccumulationPlane(int width, int height)
    : m_width(width),
      m_values(std::make_unique<std::int16_t[]>(static_cast<std::size_t>(width) *
                                                static_cast<std::size_t>(height) * 4)) {}

void allocate_accumulation(Context& ctx) {
    if (has_accumulation(ctx)) plane_of(ctx);
}

void clear_accumulation(Context& ctx) {
    if (!has_accumulation(ctx)) return;
    std::int16_t pixel[4];
    std::transform(ctx.framebuffer.clear.accum.begin(), ctx.framebuffer.clear.accum.end(), pixel,
                   clear_value);
    for_each_row(ctx, [&](std::int16_t* values, int count) {
        for (int i = 0; i < count; ++i) values[i] = pixel[i & 3];
    });
}

void accum(Context& ctx, GLenum op, GLfloat value) {
    if (op < GL_ACCUM || op > GL_ADD) return record_error(ctx, GL_INVALID_ENUM, "no such operation");
    if (!has_accumulation(ctx))
        return record_error(ctx, GL_INVALID_OPERATION, "there is no accumulation buffer");
    if (ctx.surface.draw != ctx.surface.read)
        return record_error(ctx, GL_INVALID_OPERATION, "other buffers are read than drawn to");
    if (ctx.render_mode.mode != GL_RENDER) return;
    switch (op) {
        case GL_ACCUM:
            return accumulate(ctx, value, false);
        case GL_LOAD:
            return accumulate(ctx, value, true);
        case GL_RETURN:
            return return_colors(ctx, value);
        case GL_MULT:
            return multiply(ctx, value);
        case GL_ADD:
            return add(ctx, value);
    }
}

}  // namespace terrazzo::gl
