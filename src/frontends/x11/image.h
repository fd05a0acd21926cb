// A picture that the X server copies into a drawable: in shared memory where server and client share one
// (MIT-SHM), else sent through the connection.
//
// Everything goes through xcb, also on connections that Xlib owns: no error of ours reaches the program's
// handler. Not synchronised; used by one thread at a time.
#pragma once

#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace terrazzo::x11 {

// What a depth's pixels look like in memory.
struct ImageFormat {
    std::uint8_t depth = 0;
    std::uint8_t bits_per_pixel = 0;  // 16 or 32
    std::uint8_t scanline_pad = 32;   // rows begin at multiples of so many bits
};

class Image {
  public:
    // Throws std::bad_alloc. 1 <= width, height <= 16384.
    Image(xcb_connection_t* connection, bool may_share, const ImageFormat& format, int width, int height);
    ~Image();
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;

    int width() const { return m_width; }
    int height() const { return m_height; }
    std::ptrdiff_t stride() const { return m_stride; }
    // The top row. A shared image may be read by the server until it has answered a request that came after
    // put().
    std::byte* data() { return m_data; }
    bool is_shared() const { return m_segment != XCB_NONE; }

    // Has the server copy a rectangle of the image to the same place of the drawable. `gc` is one without a
    // clip mask.
    void put(xcb_drawable_t drawable, xcb_gcontext_t gc, int x, int y, int width, int height);
    // Copies the drawable, whose size is at least the image's, into the image. False if it cannot be read: it
    // is gone, or a window that is not on the screen. Waits for the server.
    bool get(xcb_drawable_t drawable);
    // The connection has closed: it is not touched again.
    void abandon() { m_connection = nullptr; }

  private:
    bool share();

    xcb_connection_t* m_connection;
    ImageFormat m_format;
    int m_width, m_height;
    std::ptrdiff_t m_stride;
    xcb_shm_seg_t m_segment = XCB_NONE;
    std::unique_ptr<std::byte[]> m_own;  // null where the memory is shared
    std::byte* m_data = nullptr;
};

}  // namespace terrazzo::x11
