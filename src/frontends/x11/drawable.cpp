// See drawable.h.
//
// Every picture is followed by a GetGeometry request. Its reply tells two things when the next picture is
// due: the drawable's size, and that the server has read the shared memory. By then it has long arrived.
#include "frontends/x11/drawable.h"

#include <xcb/xcbext.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "frontends/window/refresh.h"
#include "frontends/window/watch.h"
#include "frontends/x11/reply.h"
#include "gl/context.h"
#include "gl/limits.h"
#include "gl/surface.h"

namespace terrazzo::x11 {
namespace {

// Of layouts kRgba8, kBgra8 and kRgb565; alpha is 255.
std::vector<std::byte> rgba_rows(Image& image, raster::PixelLayout layout) {
    std::vector<std::byte> out(static_cast<std::size_t>(image.width()) *
                               static_cast<std::size_t>(image.height()) * 4);
    std::byte* to = out.data();
    for (int y = 0; y < image.height(); ++y) {
        const std::byte* from = image.data() + y * image.stride();
        for (int x = 0; x < image.width(); ++x, to += 4) {
            if (layout == raster::PixelLayout::kRgb565) {
                std::uint16_t word;
                std::memcpy(&word, from + 2 * x, sizeof word);
                const unsigned red = word >> 11, green = word >> 5 & 63, blue = word & 31;
                to[0] = static_cast<std::byte>(red << 3 | red >> 2);
                to[1] = static_cast<std::byte>(green << 2 | green >> 4);
                to[2] = static_cast<std::byte>(blue << 3 | blue >> 2);
            } else {
                std::memcpy(to, from + 4 * x, 3);
                if (layout == raster::PixelLayout::kBgra8) std::swap(to[0], to[2]);
            }
            to[3] = std::byte{255};
        }
    }
    return out;
}

// Of all connections. The mutex comes after all others and is never held while anything is waited for; it
// guards the connections' ends, too.
struct Living {
    std::mutex mutex;
    std::map<ServerDrawable*, const Connection*> drawables;
    std::condition_variable left;  // a connection, by one of those that were leaving it
};
Living& living() {
    static Living& all = *new Living;  // never destroyed, as the front ends' registries
    return all;
}

}  // namespace

std::shared_ptr<ServerDrawable> ServerDrawable::make(std::shared_ptr<const Connection> connection,
                                                     xcb_drawable_t id, const BufferFormat& format,
                                                     const Geometry& geometry) {
    std::shared_ptr<ServerDrawable> made(new ServerDrawable(std::move(connection), id, format));
    made->resize(geometry.width, geometry.height);
    window::is_watched();  // a watcher is told of everything that is drawn here, so find it before
    const std::lock_guard lock(living().mutex);
    if (made->m_connection->end.is_closed) {
        made->m_connection = nullptr;
    } else {
        living().drawables.emplace(made.get(), made->m_connection.get());
    }
    return made;
}

ServerDrawable::ServerDrawable(std::shared_ptr<const Connection> connection, xcb_drawable_t id,
                               const BufferFormat& format)
    : Drawable(format.double_buffered ? gl::Buffering::kDouble : gl::Buffering::kSingle),
      m_connection(std::move(connection)),
      m_id(id),
      m_format(format),
      m_gc(xcb_generate_id(m_connection->xcb)) {
    const std::uint32_t no_exposures = 0;
    quietly(m_connection->xcb,
            xcb_create_gc_checked(m_connection->xcb, m_gc, id, XCB_GC_GRAPHICS_EXPOSURES, &no_exposures));
}

// Nobody else knows the drawable any more.
ServerDrawable::~ServerDrawable() {
    const std::shared_ptr<const Connection> connection = m_connection;
    bool is_open = false;
    {
        const std::lock_guard lock(living().mutex);
        living().drawables.erase(this);
        is_open = connection && !connection->end.is_closed;
        if (is_open) ++connection->end.being_left;
    }
    release(is_open);
    if (!is_open) return;
    const std::lock_guard lock(living().mutex);
    --connection->end.being_left;
    living().left.notify_all();
}

// Lets go of the connection and what it holds for us.
void ServerDrawable::release(bool is_open) {
    if (is_open) {
        if (m_asked) xcb_discard_reply(m_connection->xcb, m_asked->sequence);
        quietly(m_connection->xcb, xcb_free_gc_checked(m_connection->xcb, m_gc));
    } else if (m_image) {
        m_image->abandon();
    }
    m_asked.reset();
    m_image.reset();
    m_connection = nullptr;
}

void ServerDrawable::abandon() noexcept {
    const Lock lock(mutex());
    release(m_connection != nullptr);
}

void abandon_drawables(const Connection& connection) {
    Living& all = living();
    const auto is_of = [&](const auto& known) { return known.second == &connection; };
    std::unique_lock lock(all.mutex);
    for (;;) {
        const auto found = std::ranges::find_if(all.drawables, is_of);
        if (found == all.drawables.end()) break;
        std::shared_ptr<ServerDrawable> owner = found->first->weak_from_this().lock();
        all.drawables.erase(found);
        lock.unlock();
        if (owner) owner->abandon();
        owner.reset();
        lock.lock();
    }
    connection.end.is_closed = true;
    all.left.wait(lock, [&] { return connection.end.being_left == 0; });
}

void ServerDrawable::resize(int width, int height) {
    width = std::clamp(width, 1, gl::kMaxViewportSize);
    height = std::clamp(height, 1, gl::kMaxViewportSize);
    if (width == this->width() && height == this->height()) return;
    allocate(width, height, m_format.target);
    m_image.reset();
    m_back_frame = m_front_frame = 0;
}

std::optional<Geometry> ServerDrawable::take_answer() {
    if (!m_asked) return {};
    const auto answer = geometry_answer(m_connection->xcb, *m_asked);
    m_asked.reset();
    m_is_gone = !answer;
    return answer;
}

// Called when a picture has been shown and nothing is left to be done for it.
void ServerDrawable::mind_who_sees() {
    if (!is_gone()) return;
    if (m_connection->is_lost() && m_connection->lost) m_connection->lost(m_connection->owner);
    window::wait_for_msc(window::msc_at(window::current_ust()) + 1, 0, 0);
}

// Programs give their windows a size, map and move them around the first pictures: these are worth waiting
// for.
void ServerDrawable::follow_answer() {
    constexpr int kYoung = 4;  // pictures
    if (!m_asked || !m_connection) return;
    std::optional<Geometry> answer;
    if (m_swaps <= kYoung) {
        answer = take_answer();
    } else {
        void* reply = nullptr;
        xcb_generic_error_t* error = nullptr;
        if (!xcb_poll_for_reply(m_connection->xcb, m_asked->sequence, &reply, &error)) return;
        m_asked.reset();
        if (const auto* known = static_cast<xcb_get_geometry_reply_t*>(reply))
            answer = Geometry{known->width, known->height, known->depth};
        m_is_gone = !answer;
        std::free(reply);
        std::free(error);
    }
    if (answer) resize(answer->width, answer->height);
}

void ServerDrawable::follow_window(gl::Follow when) {
    const Lock lock(mutex());
    if (when == gl::Follow::kPictureBegins) return follow_answer();
    if (!m_connection || (m_followed && when == gl::Follow::kOncePerPicture)) return;
    m_followed = true;
    take_answer();
    const auto now = geometry(m_connection->xcb, m_id);
    m_is_gone = !now;
    if (now) resize(now->width, now->height);
}

Image& ServerDrawable::image() {
    if (!m_image)
        m_image.emplace(m_connection->xcb, m_connection->may_share, m_format.visual.image, width(), height());
    return *m_image;
}

void ServerDrawable::copy_to_image(gl::Context* ctx, gl::ColorBuffer buffer) {
    take_answer();  // the server may still be reading the last picture
    if (ctx && ctx->surface.draw.get() == this) gl::follow_drawables(*ctx);
    Image& to = image();
    std::byte* const bottom_row = to.data() + (height() - 1) * to.stride();
    if (ctx) {
        gl::copy_picture(*ctx, *this, buffer, m_format.visual.layout, bottom_row, -to.stride());
    } else {
        gl::copy_picture(*this, buffer, m_format.visual.layout, bottom_row, -to.stride());
    }
}

void ServerDrawable::put(int x, int y, int width, int height) {
    m_image->put(m_id, m_gc, x, y, width, height);
    m_asked = xcb_get_geometry(m_connection->xcb, m_id);
    xcb_flush(m_connection->xcb);
    m_followed = false;
}

// A whole picture is there to be seen: by the watcher, too.
void ServerDrawable::show(int x, int y, int width, int height) {
    if (!window::is_watched()) return put(x, y, width, height);
    std::uint64_t nanoseconds = 0;
    {
        const auto begin = std::chrono::steady_clock::now();
        put(x, y, width, height);
        nanoseconds = static_cast<std::uint64_t>((std::chrono::steady_clock::now() - begin).count());
    }
    std::vector<std::byte> rows;
    try {
        if (window::wants_pictures()) rows = rgba_rows(*m_image, m_format.visual.layout);
    } catch (const std::bad_alloc&) {
        // The watcher is told without the picture.
    }
    window::watch_frame(this->width(), this->height(), nanoseconds, rows.empty() ? nullptr : rows.data());
}

void ServerDrawable::swap(gl::Context* ctx) {
    const Lock lock(mutex());
    if (!m_connection || !is_double_buffered()) return;
    const auto answer = take_answer();
    copy_to_image(ctx, gl::ColorBuffer::kBack);
    show(0, 0, width(), height());
    swap_pixels();
    if (ctx) gl::picture_was_shown(*ctx, *this);
    ++m_swaps;
    m_back_frame = has_front_pixels() ? std::exchange(m_front_frame, m_swaps) : m_swaps;
    try {
        if (answer) resize(answer->width, answer->height);
        if (ctx && ctx->surface.draw.get() == this) gl::follow_drawables(*ctx);
    } catch (const std::bad_alloc&) {
        // The picture has been shown. The next one begins with the same.
    }
    mind_who_sees();
}

void ServerDrawable::copy_part(gl::Context* ctx, int x, int y, int width, int height) {
    const Lock lock(mutex());
    if (!m_connection || !is_double_buffered()) return;
    const auto end = [](int begin, int size, int limit) {
        return static_cast<int>(
            std::min(static_cast<long long>(begin) + size, static_cast<long long>(limit)));
    };
    const int left = std::max(x, 0), right = end(x, width, this->width());
    const int bottom = std::max(y, 0), top = end(y, height, this->height());
    if (left >= right || bottom >= top) return;
    copy_to_image(ctx, gl::ColorBuffer::kBack);
    put(left, this->height() - top, right - left, top - bottom);
    mind_who_sees();
}

void ServerDrawable::show_front(gl::Context& ctx) {
    const Lock lock(mutex());
    if (!m_connection) return;
    copy_to_image(&ctx, gl::ColorBuffer::kFront);
    show(0, 0, width(), height());
    mind_who_sees();
}

// In an image of the drawable's size, top row first; null if it cannot be read.
Image* ServerDrawable::fetch() {
    if (!m_connection) return nullptr;
    return image().get(m_id) ? &*m_image : nullptr;
}

std::optional<Picture> ServerDrawable::read_server() {
    const Lock lock(mutex());
    Image* const shown = fetch();
    if (!shown) return {};
    const auto row_bytes = static_cast<std::size_t>(shown->width()) *
                           static_cast<std::size_t>(raster::bytes_per_pixel(m_format.visual.layout));
    Picture out{shown->width(), shown->height(), {}};
    out.rows.resize(row_bytes * static_cast<std::size_t>(out.height));
    for (int y = 0; y < out.height; ++y)
        std::memcpy(out.rows.data() + static_cast<std::size_t>(out.height - 1 - y) * row_bytes,
                    shown->data() + y * shown->stride(), row_bytes);
    return out;
}

void ServerDrawable::load_front() {
    Image* const shown = fetch();
    m_front_frame = shown ? m_swaps : 0;
    if (!shown) return;
    gl::load_picture(*target(), plane_of(gl::ColorBuffer::kFront), m_format.visual.layout, shown->data(),
                     shown->stride());
}

long long ServerDrawable::buffer_age() const {
    const Lock lock(mutex());
    return m_back_frame == 0 ? 0 : m_swaps - m_back_frame + 1;
}

bool ServerDrawable::is_gone() const {
    const Lock lock(mutex());
    return m_connection && (m_is_gone || m_connection->is_lost());
}

long long ServerDrawable::swap_count() const {
    const Lock lock(mutex());
    return m_swaps;
}

}  // namespace terrazzo::x11
