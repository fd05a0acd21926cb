// See watch.h.
#include "frontends/window/watch.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>

#include "pipeline/schedule/statistics.h"
#include "simd/environment.h"

namespace terrazzo::window {
namespace {

using pipeline::statistics;

class Watcher {
  public:
    Watcher() {
        const char* const path = setting("TERRAZZO_WATCH");
        sockaddr_un address{};
        if (!path || std::strlen(path) >= sizeof address.sun_path) return;
        address.sun_family = AF_UNIX;
        std::strcpy(address.sun_path, path);
        m_socket = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        if (m_socket >= 0 && !connect_to(address)) close();
        m_pictures = setting("TERRAZZO_WATCH_PICTURES") != nullptr;
        statistics.enabled = is_open();
        m_last = Clock::now();
    }

    bool is_open() const { return m_socket >= 0; }
    bool wants_pictures() const { return is_open() && m_pictures; }

    void send(WatchedFrame frame, const std::byte* rows) {
        const std::lock_guard lock(m_mutex);
        if (!is_open()) return;
        const Clock::time_point now = Clock::now();
        frame.process = static_cast<std::uint32_t>(getpid());
        frame.nanoseconds = static_cast<std::uint64_t>((now - m_last).count());
        frame.primitives = statistics.primitives.exchange(0);
        frame.pixels = statistics.pixels.exchange(0);
        frame.vertex_nanoseconds = statistics.vertex_nanoseconds.exchange(0);
        frame.pixel_nanoseconds = statistics.pixel_nanoseconds.exchange(0);
        if (!write_all(&frame, sizeof frame) || !write_all(rows, frame.picture_bytes)) close();
        m_last = Clock::now();  // the watcher's time is not the program's
    }

  private:
    using Clock = std::chrono::steady_clock;

    // How long a watcher may do nothing, and be waited for. Writing the PNG of a 3840x2160 frame takes it
    // half a second.
    static constexpr std::chrono::milliseconds kPatience{3000};

    // A socket whose queue of callers is full answers EAGAIN, and poll() says nothing about it.
    bool connect_to(const sockaddr_un& address) {
        const Clock::time_point end = Clock::now() + kPatience;
        while (::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
            if ((errno != EAGAIN && errno != EINTR) || Clock::now() >= end) return false;
            if (errno == EAGAIN) poll(nullptr, 0, 1);
        }
        return true;
    }

    // False once the watcher has gone, or has read nothing for as long as we are patient.
    bool write_all(const void* from, std::uint64_t bytes) {
        auto at = static_cast<const std::byte*>(from);
        Clock::time_point end = Clock::now() + kPatience;
        while (bytes > 0) {
            const ssize_t sent = ::send(m_socket, at, bytes, MSG_NOSIGNAL);
            if (sent > 0) {
                at += sent;
                bytes -= static_cast<std::uint64_t>(sent);
                end = Clock::now() + kPatience;
                continue;
            }
            if (sent < 0 && errno == EINTR) continue;
            if (sent == 0 || errno != EAGAIN) return false;
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
            if (left.count() <= 0) return false;
            pollfd file{m_socket, POLLOUT, 0};
            poll(&file, 1, static_cast<int>(left.count()));
        }
        return true;
    }

    void close() {
        ::close(m_socket);
        m_socket = -1;
        statistics.enabled = false;
    }

    std::mutex m_mutex;
    std::atomic<int> m_socket = -1;  // closed under the mutex
    bool m_pictures = false;
    Clock::time_point m_last;
};

Watcher& watcher() {
    // Never destroyed: the last frames come from programs' own destructors.
    static Watcher& the_watcher = *new Watcher;
    return the_watcher;
}

}  // namespace

bool is_watched() {
    return watcher().is_open();
}

bool wants_pictures() {
    return watcher().wants_pictures();
}

void watch_frame(int width, int height, std::uint64_t show_nanoseconds, const std::byte* rows) {
    WatchedFrame frame;
    frame.width = static_cast<std::uint32_t>(width);
    frame.height = static_cast<std::uint32_t>(height);
    frame.picture_bytes = rows ? std::uint64_t{frame.width} * frame.height * 4 : 0;
    frame.show_nanoseconds = show_nanoseconds;
    watcher().send(frame, rows);
}

}  // namespace terrazzo::window
