// The frame buffer that a window system gives to contexts: a window, pixmap, pbuffer or a client's memory
// (GL 1.5 §4.2.1).
//
// The front end derives from Drawable, owns it and says how its pictures are shown; contexts that draw to it
// or read from it keep it alive. Depth and stencil are shared by its one or two colour buffers.
//
// Threads: contexts of several may have one drawable. Its mutex guards which buffers it has; their pixels are
// guarded by the target's (raster/target/target.h), which is taken after this one. A context goes on drawing
// to the target it knows until it follows the drawable, and owns it meanwhile; so it must not ask the
// drawable for the size of what it draws to. In which order two threads' drawing comes is undefined, as GL
// has it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

#include "gl/accumulation.h"
#include "raster/target/copy_out.h"
#include "raster/target/target.h"

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
    // Null before the first allocate().
    std::shared_ptr<raster::Target> target() const;
    // The same; the front buffer has pixels of its own from now on, in the first or second colour plane as
    // plane_of() says. They are made when somebody first asks for them: until then the front buffer is what
    // the front end shows. Throws std::bad_alloc.
    std::shared_ptr<raster::Target> target_with_front();
    raster::ColorPlane plane_of(ColorBuffer buffer) const {
        return is_double_buffered() && buffer == ColorBuffer::kFront ? raster::ColorPlane::kSecond
                                                                     : raster::ColorPlane::kFirst;
    }
    // Those of target(), 0 before the first allocate().
    int width() const;
    int height() const;

    // Makes buffers of this size and format, unless they are there already; the pictures of others are lost.
    // Contexts that draw here learn of it by follow_drawables(). Throws std::bad_alloc and changes nothing
    // then.
    void allocate(int width, int height, const raster::TargetFormat& format);

    // What allocate() makes and puts in place, in parts: for those whose next step may fail.
    struct Buffers {
        std::shared_ptr<raster::Target> target;
        bool has_front = false;
        std::shared_ptr<AccumulationPlane> accumulation;
    };
    bool has_buffers(int width, int height, const raster::TargetFormat& format) const;
    static Buffers make_buffers(int width, int height, const raster::TargetFormat& format);
    void exchange_buffers(Buffers& buffers) noexcept;

    bool has_front_pixels() const;
    // What SwapBuffers does to the pixels: the back buffer's become the front's. The new back buffer's are
    // undefined.
    void swap_pixels();

    // The accumulation buffer that goes with a target, for contexts that have one: it is made when somebody
    // first asks for it. A target that the drawable no longer has gets one that nobody else sees. Throws
    // std::bad_alloc.
    std::shared_ptr<AccumulationPlane> accumulation(const raster::Target& target);

    // Takes over the size that the window has now. Called by Viewport when nothing has been drawn since the
    // last picture was shown: programs call it when their window has changed. Throws std::bad_alloc.
    virtual void follow_window(Follow) {}
    // The front buffer has been drawn to and is to be seen. Called by Flush and Finish.
    virtual void show_front(Context&) {}

  protected:
    void set_target(std::shared_ptr<raster::Target> target);
    // Fills the front buffer with what the front end shows; called under the mutex when its pixels are made.
    virtual void load_front() {}

    using Lock = std::lock_guard<std::recursive_mutex>;
    // Recursive: a picture that is shown may have to be loaded first.
    std::recursive_mutex& mutex() const { return m_mutex; }

  private:
    const Buffering m_buffering;
    mutable std::recursive_mutex m_mutex;
    Buffers m_buffers;
};

// Copies a colour buffer out as it is, without what contexts have queued for it, and in; `bottom_row` and
// `top_row` are where the lowest and the highest row lie. Throws std::bad_alloc only if a front buffer's
// pixels are asked for that are not there yet.
void copy_picture(Drawable& drawable, ColorBuffer buffer, raster::PixelLayout layout, std::byte* bottom_row,
                  std::ptrdiff_t stride);
// Layouts kRgba8, kBgra8 and kRgb565.
void load_picture(raster::Target& target, raster::ColorPlane plane, raster::PixelLayout layout,
                  const std::byte* top_row, std::ptrdiff_t stride);

}  // namespace terrazzo::gl
