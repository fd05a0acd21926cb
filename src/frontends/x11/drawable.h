// Windows, pixmaps and pbuffers of an X server as something to draw to.
//
// Pictures are drawn in our memory; a swap, or a flush of the front buffer, copies them to the server. The
// size of a window is asked for with every picture that is shown and is there when the next one is: following
// it costs no wait.
#pragma once

#include <optional>

#include "frontends/x11/connection.h"
#include "gl/drawable.h"

namespace terrazzo::x11 {

// What the program's configuration says about a drawable's buffers.
struct BufferFormat {
    Visual visual;
    raster::TargetFormat target;
    bool double_buffered = false;
};

// Base of what lives in the server. Threads: used by the one that has it current.
class ServerDrawable : public gl::Drawable {
  public:
    // `geometry` is what the server says at the moment. Throws std::bad_alloc.
    ServerDrawable(const Connection& connection, xcb_drawable_t id, const BufferFormat& format,
                   const Geometry& geometry);
    ~ServerDrawable() override;

    xcb_drawable_t id() const { return m_id; }
    const BufferFormat& format() const { return m_format; }

    // Shows the back buffer; does nothing without one. `ctx` is the context whose drawing is to be finished
    // first, or null. Follows the drawable's size; contexts that draw here must then call
    // gl::follow_drawables. Throws std::bad_alloc.
    void swap(gl::Context* ctx);
    // Shows a part of the back buffer, in GL's window coordinates (GLX_MESA_copy_sub_buffer). Throws
    // std::bad_alloc.
    void copy_part(gl::Context* ctx, int x, int y, int width, int height);
    // Takes over the size that the drawable has now. Waits for the server. Throws
    // std::bad_alloc.
    void follow_window(gl::Follow when) override;
    // How many swaps ago the back buffer's pixels were drawn; 0: they are undefined (EGL_EXT_buffer_age).
    int buffer_age() const { return m_age; }
    // Swaps so far.
    long long swap_count() const { return m_swaps; }

    void show_front(gl::Context& ctx) override;

    // The server's pixels, top row first, in an image of the drawable's size; null if it cannot be read.
    // Throws std::bad_alloc.
    Image* read_server();

    // Nothing is shown any more and the connection is not touched again: it is about to close.
    void abandon();

  protected:
    void load_front() override;

  private:
    Image& image();
    void copy_to_image(gl::Context* ctx, gl::ColorBuffer buffer);
    void put(int x, int y, int width, int height);
    void show(int x, int y, int width, int height);
    std::optional<Geometry> take_answer();
    void follow_answer();
    void resize(int width, int height);

    Connection m_connection;  // its xcb is null once the drawable is abandoned
    xcb_drawable_t m_id;
    BufferFormat m_format;
    xcb_gcontext_t m_gc;
    std::optional<Image> m_image;
    std::optional<xcb_get_geometry_cookie_t> m_asked;
    bool m_followed = true;  // since the last picture was shown
    int m_age = 0;
    long long m_swaps = 0;
};

}  // namespace terrazzo::x11
