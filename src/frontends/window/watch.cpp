// See watch.h.
#include "frontends/window/watch.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "pipeline/statistics.h"

namespace terrazzo::window {
namespace {

using pipeline::statistics;

class Watcher {
  public:
    Watcher() {
        const char* const path = std::getenv("TERRAZZO_WATCH");
        sockaddr_un address{};
        if (!path || std::strlen(path) >= sizeof address.sun_path) return;
        address.sun_family = AF_UNIX;
        std::strcpy(address.sun_path, path);
        m_socket = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (m_socket >= 0 && connect(m_socket, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
            close();
        m_pictures = std::getenv("TERRAZZO_WATCH_PICTURES") != nullptr;
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

    bool write_all(const void* from, std::uint64_t bytes) {
        auto at = static_cast<const std::byte*>(from);
        while (bytes > 0) {
            const ssize_t sent = ::send(m_socket, at, bytes, MSG_NOSIGNAL);
            if (sent <= 0) return false;
            at += sent;
            bytes -= static_cast<std::uint64_t>(sent);
        }
        return true;
    }

    void close() {
        ::close(m_socket);
        m_socket = -1;
        statistics.enabled = false;
    }

    std::mutex m_mutex;
    int m_socket = -1;
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
