// The window system's side of a context: what the render target looks like and how its picture is shown.
//
// The front end hands a Surface over when it makes the context current. Flush and Finish draw what is queued
// and then call `present`, which copies the finished picture to wherever the window system wants it. What has
// been shown already is not shown again: `present` is called only when something was drawn since the last
// time.
#pragma once

#include <cstddef>

#include "pipeline/resolve.h"
#include "raster/target.h"

namespace terrazzo::gl {

struct Context;

struct Surface {
    int width = 0;  // 0: none yet
    int height = 0;
    raster::TargetFormat format;
    void (*present)(Context&, void* front_end) = nullptr;
    void* front_end = nullptr;
    bool drawn = false;  // set by whatever draws or clears, even when nothing comes of it
};

// Gives the context a surface. The first one also sets viewport and scissor box to its size (GL 1.5 §2.11.1,
// §4.1.2). The picture, with depth and stencil, stays if size and format do. Throws std::bad_alloc and
// changes nothing then.
void attach_surface(Context& ctx, const Surface& surface);

// Draws what is queued and shows it if there is anything new.
void present(Context& ctx);

// Draws what is queued and copies the picture out; `bottom_row` is where the lowest row goes.
void copy_picture(Context& ctx, pipeline::PixelLayout layout, std::byte* bottom_row, std::ptrdiff_t stride);

}  // namespace terrazzo::gl
