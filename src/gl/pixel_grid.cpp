// Without zoom a rectangle's pixels are the window's. Otherwise it is a textured quad, as in the reference:
// its edges are snapped to 1/256 of a pixel, and a coordinate that is interpolated says which pixel is shown.
// In frame buffer objects that quad of the reference's lies up to half a pixel off; there the rule is GL's
// own.
#include "gl/pixel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/pixel_rect.h"

namespace terrazzo::gl {
namespace {

int corner(GLfloat position) {
    return static_cast<int>(std::lround(bounded(position)));
}

PixelAxis unit_axis(int corner, GLsizei size, int low, int high) {
    const int64_t first = std::max<int64_t>(corner, low),
                  end = std::min<int64_t>(int64_t{corner} + size, high);
    PixelAxis axis;
    axis.first = static_cast<int>(first);
    for (int64_t target = first; target < end; ++target)
        axis.sources.push_back(static_cast<int>(target - corner));
    return axis;
}

// Both ends of the quad along one axis in the target's coordinates, as its vertices come out of the viewport.
struct Ends {
    float start, end;  // of the rectangle's first and last pixel

    Ends(int corner, GLsizei size, float zoom, int target_size, bool turned) {
        const float whole = static_cast<float>(target_size), half = 0.5f * whole;
        const auto window = [&](float position) {
            const float clip = bounded(position) / whole * 2.0f - 1.0f;
            return std::fma(clip, turned ? -half : half, half);
        };
        start = window(static_cast<float>(corner));
        end = window(static_cast<float>(corner) + static_cast<float>(size) * zoom);
    }
    float length() const { return end - start; }
};

int64_t snap(float window) {
    return std::llrint((window - 0.5f) * 256.0f);
}

// `slope` is what the texture coordinate gains from pixel to pixel; `origin` is where it would be at pixel 0.
// Of edges that run through pixel centres the left one belongs to the quad, and the one that is lower in the
// window.
PixelAxis zoomed_axis(const Ends& ends, float slope, float origin, GLsizei size, int low, int high,
                      bool upper_end_counts) {
    const int64_t a = std::min(snap(ends.start), snap(ends.end)),
                  b = std::max(snap(ends.start), snap(ends.end));
    // Pixel p is inside where a <= 256 p < b, or a < 256 p <= b.
    const int64_t first = upper_end_counts ? (a >> 8) + 1 : (a + 255) >> 8;
    const int64_t end = upper_end_counts ? (b >> 8) + 1 : (b + 255) >> 8;
    PixelAxis axis;
    axis.first = static_cast<int>(std::clamp<int64_t>(first, low, high));
    const int last = static_cast<int>(std::clamp<int64_t>(end, low, high));
    for (int target = axis.first; target < last; ++target) {
        const float position = std::fma(slope, static_cast<float>(target), origin) * static_cast<float>(size);
        const float not_before = position > 0 ? position : 0.0f;
        axis.sources.push_back(static_cast<int>(std::min(not_before, static_cast<float>(size - 1))));
    }
    return axis;
}

// GL 1.5 §3.6.4: a pixel whose centre lies on the border of what two source pixels become shows the one whose
// lower or left border that is. Products of a float and an integer are exact.
PixelAxis exact_axis(int corner, GLsizei size, float zoom, int low, int high) {
    const double far = corner + double{zoom} * size;
    PixelAxis axis;
    if (zoom == 0 || std::isnan(far)) return axis;
    const auto first_centre = [&](double from) {
        return static_cast<int>(std::clamp(std::ceil(from - 0.5), double(low), double(high)));
    };
    axis.first = first_centre(std::min<double>(corner, far));
    const int end = first_centre(std::max<double>(corner, far));
    for (int target = axis.first; target < end; ++target) {
        const double distance = target + 0.5 - corner, quotient = distance / zoom;
        const double border = std::round(quotient);
        const bool on_border = border * zoom == distance;
        const double source = on_border ? border - (zoom < 0) : std::floor(quotient);
        axis.sources.push_back(std::clamp(static_cast<int>(source), 0, size - 1));
    }
    return axis;
}

}  // namespace

void PixelAxis::keep_sources(int low, int high) {
    const auto outside = [&](int source) { return source < low || source >= high; };
    while (!sources.empty() && outside(sources.back())) sources.pop_back();
    const auto kept = std::find_if_not(sources.begin(), sources.end(), outside);
    first += static_cast<int>(kept - sources.begin());
    sources.erase(sources.begin(), kept);
}

int PixelAxis::lowest_source() const {
    return std::min(sources.front(), sources.back());
}

int PixelAxis::highest_source() const {
    return std::max(sources.front(), sources.back());
}

PixelGrid make_pixel_grid(const Context& ctx, GLsizei width, GLsizei height) {
    PixelGrid grid;
    if (width == 0 || height == 0) return grid;
    pipeline::RasterState box;
    scissor_box(ctx, box);
    const int x = corner(ctx.raster_position.window[0]), y = corner(ctx.raster_position.window[1]);
    const PixelMode& mode = ctx.pixels.mode;
    const bool top_first = ctx.surface.format.rows == raster::RowOrder::kTopFirst;
    if (mode.zoom_x == 1 && mode.zoom_y == 1) {
        grid.columns = unit_axis(x, width, box.x0, box.x1);
        const raster::RowRange seen = ctx.surface.rows(box.y0, box.y1);
        grid.rows = unit_axis(y, height, static_cast<int>(seen.first), static_cast<int>(seen.end));
        if (top_first) {
            grid.rows.first = static_cast<int>(ctx.surface.rows(grid.rows.first, grid.rows.end()).first);
            std::reverse(grid.rows.sources.begin(), grid.rows.sources.end());
        }
        return grid;
    }
    if (!top_first) {
        grid.columns = exact_axis(x, width, mode.zoom_x, box.x0, box.x1);
        grid.rows = exact_axis(y, height, mode.zoom_y, box.y0, box.y1);
        return grid;
    }
    const Ends across(x, width, mode.zoom_x, ctx.surface.width, false);
    const Ends up(y, height, mode.zoom_y, ctx.surface.height, true);
    if (!(across.length() != 0) || !(up.length() != 0)) return grid;
    // As set-up computes planes: divided by the area first (doc/reference.md §3.2).
    const float inverse_area = 1.0f / (across.length() * up.length());
    const float slope_x = up.length() * inverse_area, slope_y = across.length() * inverse_area;
    // From the first vertex of the triangle that the quad's upper half is, which a mirrored quad turns round.
    const bool mirrored = (across.length() > 0) == (up.length() > 0);
    const float origin_x =
        mirrored ? 0.0f - slope_x * (across.start - 0.5f) : 1.0f - slope_x * (across.end - 0.5f);
    const float origin_y = 1.0f - slope_y * (up.end - 0.5f);
    grid.columns = zoomed_axis(across, slope_x, origin_x, width, box.x0, box.x1, false);
    grid.rows = zoomed_axis(up, slope_y, origin_y, height, box.y0, box.y1, true);
    return grid;
}

}  // namespace terrazzo::gl
