// Windows, pixmaps and pbuffers of an X server as something to draw to.
//
// Pictures are drawn in our memory; a swap, or a flush of the front buffer, copies them to the server. The
// size of a window is asked for with every picture that is shown and is there when the next one is: following
// it costs no wait.
//
// Where the server or the drawable has gone, pictures are drawn for nobody. The owner of the connection is
// told (Xlib ends the program, as a rule); a program that goes on is held to the beat of a display.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "frontends/x11/connection.h"
#include "gl/drawable.h"

namespace terrazzo::x11 {

// What the program's configuration says about a drawable's buffers.
struct BufferFormat {
    Visual visual;
    raster::TargetFormat target;
    bool double_buffered = false;
};

// A picture out of the server: rows of whole pixels, the bottom one first, none between them.
struct Picture {
    int width, height;
    std::vector<std::byte> rows;
};

// Base of what lives in the server. Threads: any; what is said to the server and heard from it is under the
// drawable's mutex.
class ServerDrawable : public gl::Drawable, public std::enable_shared_from_this<ServerDrawable> {
  public:
    // `geometry` is what the server says at the moment. Throws std::bad_alloc.
    static std::shared_ptr<ServerDrawable> make(std::shared_ptr<const Connection> connection,
                                                xcb_drawable_t id, const BufferFormat& format,
                                                const Geometry& geometry);
    ~ServerDrawable() override;

    xcb_drawable_t id() const { return m_id; }
    const BufferFormat& format() const { return m_format; }

    // Shows the back buffer; does nothing without one. `ctx` is the context whose drawing is to be finished
    // first, or null. Follows the drawable's size, and the context does. Throws std::bad_alloc, and nothing
    // has been shown then. When the server has gone it may not return.
    void swap(gl::Context* ctx);
    // Shows a part of the back buffer, in GL's window coordinates (GLX_MESA_copy_sub_buffer). Throws
    // std::bad_alloc.
    void copy_part(gl::Context* ctx, int x, int y, int width, int height);
    // Takes over the size that the drawable has now. Waits for the server. Throws
    // std::bad_alloc.
    void follow_window(gl::Follow when) override;
    // How many swaps ago the back buffer's pixels were drawn; 0: they are undefined (EGL_EXT_buffer_age).
    long long buffer_age() const;
    // Whether it is known that the server, or the drawable in it, has gone. Does not ask the server.
    bool is_gone() const;
    // Swaps so far.
    long long swap_count() const;

    void show_front(gl::Context& ctx) override;

    // The server's pixels; empty if they cannot be read. Throws std::bad_alloc.
    std::optional<Picture> read_server();

    // Nothing is shown any more and the connection is not touched again.
    void abandon() noexcept;

  protected:
    void load_front() override;

  private:
    ServerDrawable(std::shared_ptr<const Connection> connection, xcb_drawable_t id,
                   const BufferFormat& format);

    void release(bool is_open);
    Image& image();
    Image* fetch();
    void copy_to_image(gl::Context* ctx, gl::ColorBuffer buffer);
    void put(int x, int y, int width, int height);
    void show(int x, int y, int width, int height);
    std::optional<Geometry> take_answer();
    void mind_who_sees();
    void follow_answer();
    void resize(int width, int height);

    std::shared_ptr<const Connection> m_connection;  // null once the drawable is abandoned
    const xcb_drawable_t m_id;
    const BufferFormat m_format;
    const xcb_gcontext_t m_gc;
    std::optional<Image> m_image;
    std::optional<xcb_get_geometry_cookie_t> m_asked;
    bool m_followed = true;  // since the last picture was shown
    bool m_is_gone = false;  // the server knows no drawable of this name any more
    long long m_swaps = 0;
    // The swap that showed the pixels of the back and of the front buffer; 0: none did, they are undefined.
    long long m_back_frame = 0, m_front_frame = 0;
};

// The connection is about to close: abandons all its drawables, those too that nobody knows by name any more
// and a context still draws to, and those that are made with it from now on.
void abandon_drawables(const Connection& connection);

}  // namespace terrazzo::x11
