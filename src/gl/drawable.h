// The frame buffer that a window system gives to contexts: a window, pixmap, pbuffer or a client's memory
// (GL 1.5 §4.2.1).
//
// The front end derives from Drawable, owns it and says how its pictures are shown; contexts that draw to it
// or read from it keep it alive. Depth and stencil are shared by its one or two colour buffers. Not
// synchronised: contexts of two threads that draw to one drawable at a time get an undefined picture, as GL
// has it.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "gl/accumulation.h"
#include "pipeline/resolve.h"
#include "raster/target.h"

namespace terrazzo::gl {

struct Context;

enum class ColorBuffer { kFront, kBack };

enum class Buffering {
    kSingle,
    kSingleByEitherName,  // the back buffer is another name of the front buffer, as in OSMesa
    kDouble,
};

// When a drawable asks its window for its size, which means waiting for the window system.
enum class Follow {
    kPictureBegins,   // waits only while the window is young; else takes what is known by then
    kOncePerPicture,  // unless it has done so since the last picture was shown
    kNow,
};

class Drawable {
  public:
    explicit Drawable(Buffering buffering) : m_buffering(buffering) {}
    virtual ~Drawable() = default;
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    Buffering buffering() const { return m_buffering; }
    bool is_double_buffered() const { return m_buffering == Buffering::kDouble; }
    int width() const { return m_buffers.target ? m_buffers.target->width() : 0; }
    int height() const { return m_buffers.target ? m_buffers.target->height() : 0; }
    // Null before the first allocate().
    const std::shared_ptr<raster::Target>& target() const { return m_buffers.target; }

    // Makes buffers of this size and format, unless they are there already; the pictures of others are lost.
    // Contexts that draw here learn of it by follow_drawables(). Throws std::bad_alloc and changes nothing
    // then.
    void allocate(int width, int height, const raster::TargetFormat& format);

    // What allocate() makes and puts in place, in parts: for those whose next step may fail.
    struct Buffers {
        std::shared_ptr<raster::Target> target;
        ColorBuffer selected = ColorBuffer::kFront;
        bool has_front = false;
        std::unique_ptr<AccumulationPlane> accumulation;
    };
    bool has_buffers(int width, int height, const raster::TargetFormat& format) const;
    Buffers make_buffers(int width, int height, const raster::TargetFormat& format) const;
    void exchange_buffers(Buffers& buffers) noexcept { std::swap(m_buffers, buffers); }

    // Makes a colour buffer the one that target() shows. What was queued for the other has been drawn. Throws
    // std::bad_alloc.
    void select(ColorBuffer buffer);
    ColorBuffer selected() const { return m_buffers.selected; }
    // Whether the front buffer has pixels of its own. They are made when somebody first asks for them: until
    // then the front buffer is what the front end shows.
    bool has_front_pixels() const { return !is_double_buffered() || m_buffers.has_front; }
    // What SwapBuffers does to the pixels: the back buffer's become the front's. The new back buffer's are
    // undefined.
    void swap_pixels();

    // The accumulation buffer, for contexts that have one: it is made when somebody first asks for it, and
    // anew with other buffers. There is a target. Throws std::bad_alloc.
    AccumulationPlane& accumulation();

    // Takes over the size that the window has now. Called by Viewport when nothing has been drawn since the
    // last picture was shown: programs call it when their window has changed. Throws std::bad_alloc.
    virtual void follow_window(Follow) {}
    // The front buffer has been drawn to and is to be seen. Called by Flush and Finish.
    virtual void show_front(Context&) {}

  protected:
    void set_target(std::shared_ptr<raster::Target> target) { m_buffers.target = std::move(target); }
    // Fills the selected buffer with what the front end shows; called when the front buffer's pixels are
    // made.
    virtual void load_front() {}

  private:
    Buffering m_buffering;
    Buffers m_buffers;
};

// Copies a colour buffer out as it is, without what contexts have queued for it, and in; `bottom_row` and
// `top_row` are where the lowest and the highest row lie. Throws std::bad_alloc only if a front buffer's
// pixels are asked for that are not there yet.
void copy_picture(Drawable& drawable, ColorBuffer buffer, pipeline::PixelLayout layout, std::byte* bottom_row,
                  std::ptrdiff_t stride);
// Into the selected buffer; layouts kRgba8, kBgra8 and kRgb565.
void load_picture(Drawable& drawable, pipeline::PixelLayout layout, const std::byte* top_row,
                  std::ptrdiff_t stride);

}  // namespace terrazzo::gl
