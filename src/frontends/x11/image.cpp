// Shared and sent images; see image.h.
#include "frontends/x11/image.h"

#include <sys/ipc.h>
#include <sys/shm.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "frontends/x11/reply.h"

namespace terrazzo::x11 {

Image::Image(xcb_connection_t* connection, bool may_share, const ImageFormat& format, int width, int height)
    : m_connection(connection), m_format(format), m_width(width), m_height(height) {
    const int pad = format.scanline_pad;
    m_stride = (std::ptrdiff_t{width} * format.bits_per_pixel + pad - 1) / pad * pad / 8;
    if (may_share && share()) return;
    m_own = std::make_unique<std::byte[]>(static_cast<std::size_t>(m_stride * height));
    m_data = m_own.get();
}

Image::~Image() {
    if (!is_shared()) return;
    if (m_connection) {
        quietly(m_connection, xcb_shm_detach_checked(m_connection, m_segment));
        xcb_flush(m_connection);
    }
    shmdt(m_data);
}

bool Image::share() {
    const int id = shmget(IPC_PRIVATE, static_cast<std::size_t>(m_stride * m_height), IPC_CREAT | 0600);
    if (id < 0) return false;
    void* const memory = shmat(id, nullptr, 0);
    if (memory == reinterpret_cast<void*>(-1)) {
        shmctl(id, IPC_RMID, nullptr);
        return false;
    }
    const xcb_shm_seg_t segment = xcb_generate_id(m_connection);
    // A server on another machine knows MIT-SHM, too, but not our memory.
    const xcb_void_cookie_t attach =
        xcb_shm_attach_checked(m_connection, segment, static_cast<std::uint32_t>(id), false);
    const Reply<xcb_generic_error_t> error(xcb_request_check(m_connection, attach));
    // The memory is freed when both sides have let go of it, however they end.
    shmctl(id, IPC_RMID, nullptr);
    if (error || xcb_connection_has_error(m_connection)) {
        shmdt(memory);
        return false;
    }
    m_segment = segment;
    m_data = static_cast<std::byte*>(memory);
    return true;
}

void Image::put(xcb_drawable_t drawable, xcb_gcontext_t gc, int x, int y, int width, int height) {
    if (is_shared()) {
        quietly(m_connection,
                xcb_shm_put_image_checked(m_connection, drawable, gc, static_cast<std::uint16_t>(m_width),
                                          static_cast<std::uint16_t>(m_height), static_cast<std::int16_t>(x),
                                          static_cast<std::int16_t>(y), static_cast<std::uint16_t>(width),
                                          static_cast<std::uint16_t>(height), static_cast<std::int16_t>(x),
                                          static_cast<std::int16_t>(y), m_format.depth,
                                          XCB_IMAGE_FORMAT_Z_PIXMAP, 0, m_segment, 0));
    } else {
        // Whole rows, as many as a request holds; the server leaves out what lies beside the rectangle.
        const bool is_part = x > 0 || width < m_width;
        if (is_part) {
            const xcb_rectangle_t inside{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                                         static_cast<std::uint16_t>(width),
                                         static_cast<std::uint16_t>(height)};
            quietly(m_connection, xcb_set_clip_rectangles_checked(m_connection, XCB_CLIP_ORDERING_UNSORTED,
                                                                  gc, 0, 0, 1, &inside));
        }
        const std::ptrdiff_t longest = std::ptrdiff_t{4} * xcb_get_maximum_request_length(m_connection) - 64;
        const int rows = static_cast<int>(std::max<std::ptrdiff_t>(longest / m_stride, 1));
        for (int first = y; first < y + height; first += rows) {
            const int count = std::min(rows, y + height - first);
            quietly(m_connection, xcb_put_image_checked(
                                      m_connection, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable, gc,
                                      static_cast<std::uint16_t>(m_width), static_cast<std::uint16_t>(count),
                                      0, static_cast<std::int16_t>(first), 0, m_format.depth,
                                      static_cast<std::uint32_t>(m_stride * count),
                                      reinterpret_cast<const std::uint8_t*>(m_data + first * m_stride)));
        }
        const std::uint32_t everything = XCB_NONE;
        if (is_part)
            quietly(m_connection, xcb_change_gc_checked(m_connection, gc, XCB_GC_CLIP_MASK, &everything));
    }
    xcb_flush(m_connection);
}

bool Image::get(xcb_drawable_t drawable) {
    const auto width = static_cast<std::uint16_t>(m_width), height = static_cast<std::uint16_t>(m_height);
    if (is_shared()) {
        const Reply<xcb_shm_get_image_reply_t> reply(
            xcb_shm_get_image_reply(m_connection,
                                    xcb_shm_get_image(m_connection, drawable, 0, 0, width, height, ~0u,
                                                      XCB_IMAGE_FORMAT_Z_PIXMAP, m_segment, 0),
                                    nullptr));
        return reply != nullptr;
    }
    const Reply<xcb_get_image_reply_t> reply(xcb_get_image_reply(
        m_connection,
        xcb_get_image(m_connection, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable, 0, 0, width, height, ~0u), nullptr));
    if (!reply) return false;
    const auto bytes = std::min<std::ptrdiff_t>(xcb_get_image_data_length(reply.get()), m_stride * m_height);
    std::memcpy(m_data, xcb_get_image_data(reply.get()), static_cast<std::size_t>(bytes));
    return true;
}

}  // namespace terrazzo::x11
