// The way out: a render target's pixels as rows in somebody else's memory.
//
// What is queued must have been drawn. Rows go from the target's row 0 up; a negative stride turns the
// picture over.
#pragma once

#include <cstddef>

#include "raster/target/target.h"

namespace terrazzo::raster {

// Components are named in the order of their addresses and are in the host's byte order. Colour layouts go
// with the target's colour format; depth layouts with any target that has depth.
enum class PixelLayout {
    kRgba8,
    kRgbx8,  // alpha is 1, whatever is stored
    kBgra8,
    kArgb8,
    kRgb8,
    kBgr8,
    kRgba16,
    kRgb16,
    kRgba32F,
    kRgb32F,
    kRgb565,           // one 16-bit word, red highest
    kDepth16,          // one 16-bit word
    kDepth24Stencil8,  // one 32-bit word, stencil highest; 0 for stencil where there is none
    kDepth32F,         // a float from 0 to 1
    kDepth32,          // one 32-bit word, the highest bits repeated below
};

constexpr int bytes_per_pixel(PixelLayout layout) {
    switch (layout) {
        case PixelLayout::kRgba8:
        case PixelLayout::kRgbx8:
        case PixelLayout::kBgra8:
        case PixelLayout::kArgb8:
        case PixelLayout::kDepth24Stencil8:
        case PixelLayout::kDepth32F:
        case PixelLayout::kDepth32:
            return 4;
        case PixelLayout::kRgb8:
        case PixelLayout::kBgr8:
            return 3;
        case PixelLayout::kRgba16:
            return 8;
        case PixelLayout::kRgb16:
            return 6;
        case PixelLayout::kRgba32F:
            return 16;
        case PixelLayout::kRgb32F:
            return 12;
        case PixelLayout::kRgb565:
        case PixelLayout::kDepth16:
            return 2;
    }
    return 0;
}

// A rectangle of the target; the pixel (x, row) goes to `out`, the row after it `stride` bytes further.
void resolve_rect(Target& target, const RowRect& rect, PixelLayout layout, std::byte* out,
                  std::ptrdiff_t stride);

// The part of the picture that lies in some bins side by side, from number `first` on. `row0` is where the
// target's row 0 goes, the others follow `stride` bytes apart. Different bins may be resolved by different
// threads.
void resolve_bins(Target& target, int first, int count, PixelLayout layout, std::byte* row0,
                  std::ptrdiff_t stride);

// Whether a column of rows so far apart meets in so few sets of a cache of 32 or 48 KB that they drive each
// other out. A whole row of bins is better resolved at once then, which writes four rows of the picture from
// end to end: a picture of 1024x1024 takes a quarter of the time.
bool rows_share_cache_lines(std::ptrdiff_t stride);

}  // namespace terrazzo::raster
