// Which pixels of the target a pixel rectangle covers under the pixel zoom, and which of its pixels each of
// them shows (GL 1.5 §3.6.4).
#pragma once

#include <GL/gl.h>

#include <vector>

namespace terrazzo::gl {

struct Context;

// Columns or rows of the target, `first` and the following ones, each with a column or row of the rectangle.
struct PixelAxis {
    int first = 0;
    std::vector<int> sources;

    int end() const { return first + static_cast<int>(sources.size()); }
    bool empty() const { return sources.empty(); }
    // Leaves out what shows nothing of [low, high).
    void keep_sources(int low, int high);
    int lowest_source() const;
    int highest_source() const;
};

struct PixelGrid {
    PixelAxis columns, rows;  // the target's; sources count from the rectangle's lowest row

    bool empty() const { return columns.empty() || rows.empty(); }
};

// The part of a rectangle at the current raster position that is in the window and the scissor box. Throws
// std::bad_alloc.
PixelGrid make_pixel_grid(const Context& ctx, GLsizei width, GLsizei height);

}  // namespace terrazzo::gl
