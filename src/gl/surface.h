// Where a context draws and reads, and how its pictures leave it.
//
// The front end makes drawables current with `attach_drawables`. Flush and Finish draw what is queued and
// then show it if it went to a front buffer. What has been shown already is not shown again.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "gl/drawable.h"
#include "raster/target/copy_out.h"
#include "raster/target/target.h"

namespace terrazzo::gl {

struct Context;

// What commands need to know of the buffers that are drawn to.
struct Surface {
    std::shared_ptr<Drawable> draw, read;  // null: none
    int width = 0;                         // 0: there is no buffer to draw to
    int height = 0;
    raster::TargetFormat format;
    // Rows of the target from those of the window, which count upwards, and the other way round.
    raster::RowRange rows(int64_t low, int64_t high) const {
        return turn_rows(format.rows, height, low, high);
    }
    int row(int y) const { return static_cast<int>(rows(y, int64_t{y} + 1).first); }
    bool drawn = false;  // set by whatever draws or clears, even when nothing comes of it
};

// Makes the drawables, or none, the context's; draws first what is queued for others. The first time that
// there is one to draw to also sets viewport and scissor box to its size (GL 1.5 §2.11.1, §4.1.2). Throws
// std::bad_alloc and changes nothing then.
void attach_drawables(Context& ctx, std::shared_ptr<Drawable> draw, std::shared_ptr<Drawable> read);

// Makes a drawable, or none, the one that is drawn to while a frame buffer object is bound or has been left.
// `buffer`, an argument of glDrawBuffer, is what is drawn to of it. Throws std::bad_alloc and changes nothing
// then.
void use_draw_drawable(Context& ctx, std::shared_ptr<Drawable> drawable, GLenum buffer);

// To be called when a drawable of the context may have other buffers than before. Throws std::bad_alloc and
// changes nothing then: it is to be called again before anything is drawn.
void follow_drawables(Context& ctx);

// To be called before anything is drawn, before the buffers' size is looked at: where it is the first since a
// picture was shown, the window may have another size by now. Throws std::bad_alloc and is to be called again
// then.
void begin_drawing(Context& ctx);

// Draws what is queued and shows it if there is anything new to be seen. Throws std::bad_alloc, and what is
// queued waits.
void present(Context& ctx);

// Draws what the context has queued for the drawable, whatever is bound by now, and copies a colour buffer
// (or the depth) out; `bottom_row` is where the lowest row goes. Throws std::bad_alloc only if a front
// buffer's pixels are asked for that are not there yet.
void copy_picture(Context& ctx, Drawable& drawable, ColorBuffer buffer, raster::PixelLayout layout,
                  std::byte* bottom_row, std::ptrdiff_t stride);

// The same for the calls of window systems, which mean the window whatever is bound: while a frame buffer
// object is, present() leaves the window's picture for later, as the reference does.
void present_window(Context& ctx);

// The window's picture has been shown: nothing new is to be seen until something is drawn.
void picture_was_shown(Context& ctx, const Drawable& window);

}  // namespace terrazzo::gl
