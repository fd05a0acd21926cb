// See drawable.h.
//
// Every picture is followed by a GetGeometry request. Its reply tells two things when the next picture is
// due: the drawable's size, and that the server has read the shared memory. By then it has long arrived.
#include "frontends/x11/drawable.h"

#include <algorithm>
#include <memory>

#include "gl/context.h"
#include "gl/limits.h"
#include "gl/surface.h"

namespace terrazzo::x11 {
namespace {

raster::TargetFormat checked(const BufferFormat& format) {
    raster::TargetFormat target = format.target;
    target.color = format.visual.color;
    return target;
}

}  // namespace

ServerDrawable::ServerDrawable(const Connection& connection, xcb_drawable_t id, const BufferFormat& format,
                               const Geometry& geometry)
    : Drawable(format.double_buffered ? gl::Buffering::kDouble : gl::Buffering::kSingle),
      m_connection(connection),
      m_id(id),
      m_format(format),
      m_gc(xcb_generate_id(connection.xcb)) {
    const std::uint32_t no_exposures = 0;
    xcb_create_gc(connection.xcb, m_gc, id, XCB_GC_GRAPHICS_EXPOSURES, &no_exposures);
    resize(geometry.width, geometry.height);
}

ServerDrawable::~ServerDrawable() {
    if (!m_connection.xcb) return;
    if (m_asked) xcb_discard_reply(m_connection.xcb, m_asked->sequence);
    xcb_free_gc(m_connection.xcb, m_gc);
}

void ServerDrawable::abandon() {
    if (!m_connection.xcb) return;
    if (m_asked) xcb_discard_reply(m_connection.xcb, m_asked->sequence);
    m_asked.reset();
    m_image.reset();
    m_connection.xcb = nullptr;
}

void ServerDrawable::resize(int width, int height) {
    width = std::clamp(width, 1, gl::kMaxViewportSize);
    height = std::clamp(height, 1, gl::kMaxViewportSize);
    if (width == this->width() && height == this->height()) return;
    allocate(width, height, checked(m_format));
    m_image.reset();
    m_age = 0;
}

std::optional<Geometry> ServerDrawable::take_answer() {
    if (!m_asked) return {};
    const auto answer = geometry_answer(m_connection.xcb, *m_asked);
    m_asked.reset();
    return answer;
}

void ServerDrawable::follow_window(gl::Follow when) {
    if (!m_connection.xcb || (m_followed && when == gl::Follow::kOncePerPicture)) return;
    m_followed = true;
    take_answer();
    // Without an answer the drawable is gone: we go on drawing for nobody.
    if (const auto now = geometry(m_connection.xcb, m_id)) resize(now->width, now->height);
}

Image& ServerDrawable::image() {
    if (!m_image)
        m_image.emplace(m_connection.xcb, m_connection.may_share, m_format.visual.image, width(), height());
    return *m_image;
}

void ServerDrawable::copy_to_image(gl::Context* ctx, gl::ColorBuffer buffer) {
    take_answer();  // the server may still be reading the last picture
    Image& to = image();
    std::byte* const bottom_row = to.data() + (height() - 1) * to.stride();
    if (ctx && ctx->surface.draw.get() == this) {
        gl::copy_picture(*ctx, buffer, m_format.visual.layout, bottom_row, -to.stride());
    } else {
        gl::copy_picture(*this, buffer, m_format.visual.layout, bottom_row, -to.stride());
    }
}

void ServerDrawable::put(int x, int y, int width, int height) {
    m_image->put(m_id, m_gc, x, y, width, height);
    m_asked = xcb_get_geometry(m_connection.xcb, m_id);
    xcb_flush(m_connection.xcb);
    m_followed = false;
}

void ServerDrawable::swap(gl::Context* ctx) {
    if (!m_connection.xcb || !is_double_buffered()) return;
    const auto answer = take_answer();
    copy_to_image(ctx, gl::ColorBuffer::kBack);
    put(0, 0, width(), height());
    swap_pixels();
    if (ctx && ctx->surface.draw.get() == this) ctx->surface.drawn = false;
    ++m_swaps;
    m_age = has_front_pixels() ? (m_age == 0 ? 0 : 2) : 1;
    if (answer) resize(answer->width, answer->height);
}

void ServerDrawable::copy_part(gl::Context* ctx, int x, int y, int width, int height) {
    if (!m_connection.xcb || !is_double_buffered()) return;
    const int left = std::max(x, 0), right = std::min(x + width, this->width());
    const int bottom = std::max(y, 0), top = std::min(y + height, this->height());
    if (left >= right || bottom >= top) return;
    copy_to_image(ctx, gl::ColorBuffer::kBack);
    put(left, this->height() - top, right - left, top - bottom);
}

void ServerDrawable::show_front(gl::Context& ctx) {
    if (!m_connection.xcb) return;
    copy_to_image(&ctx, gl::ColorBuffer::kFront);
    put(0, 0, width(), height());
}

Image* ServerDrawable::read_server() {
    if (!m_connection.xcb) return nullptr;
    return image().get(m_id) ? &*m_image : nullptr;
}

void ServerDrawable::load_front() {
    Image* const shown = read_server();
    if (!shown) return;
    gl::load_picture(*this, m_format.visual.layout, shown->data(), shown->stride());
}

}  // namespace terrazzo::x11
