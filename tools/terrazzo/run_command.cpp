// terrazzo run: a program with Terrazzo as its libGL, libEGL, libOSMesa and libglvnd vendor.
//
// Without --record and --stats it becomes the program. With them it stays behind to listen to the socket
// through which the library tells of each frame (src/frontends/window/watch.h).
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "commands.h"
#include "frontends/window/watch.h"
#include "launch.h"
#include "report/pictures.h"

namespace terrazzo {
namespace {

namespace fs = std::filesystem;
using window::WatchedFrame;

struct Options {
    int threads = -1;
    std::string record;
    bool stats = false;
    std::vector<std::string> command;
};

void set(const char* name, const std::string& value) {
    setenv(name, value.c_str(), 1);
}

class Socket {
  public:
    explicit Socket(int file) : m_file(file) {}
    ~Socket() {
        if (m_file >= 0) close(m_file);
    }
    Socket(Socket&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
    Socket& operator=(Socket&&) = delete;

    int file() const { return m_file; }
    // False when the other side is gone.
    bool read_all(void* to, std::size_t bytes) const {
        auto at = static_cast<std::byte*>(to);
        while (bytes > 0) {
            const ssize_t got = read(m_file, at, bytes);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            at += got;
            bytes -= static_cast<std::size_t>(got);
        }
        return true;
    }

  private:
    int m_file;
};

// Reports count rows from the bottom.
void flip(std::vector<std::uint8_t>& pixels, std::size_t row_bytes) {
    for (std::size_t top = 0, bottom = pixels.size(); bottom > top + row_bytes; top += row_bytes) {
        bottom -= row_bytes;
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(top),
                         pixels.begin() + static_cast<std::ptrdiff_t>(top + row_bytes),
                         pixels.begin() + static_cast<std::ptrdiff_t>(bottom));
    }
}

// Frames of all processes that the program becomes.
class Listener {
  public:
    explicit Listener(const Options& options)
        : m_options(options), m_socket(socket(AF_UNIX, SOCK_STREAM, 0)) {
        std::string pattern = (fs::temp_directory_path() / "terrazzo-run-XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder for the socket: " + pattern);
        m_folder = pattern;
        m_path = m_folder / "frames";
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (m_path.string().size() >= sizeof address.sun_path)
            throw std::runtime_error("TMPDIR is too long a path");
        std::strcpy(address.sun_path, m_path.c_str());
        if (bind(m_socket.file(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
            listen(m_socket.file(), 8) != 0)
            throw std::runtime_error("no socket at " + m_path.string());
        if (!options.record.empty()) fs::create_directories(options.record);
    }
    ~Listener() {
        std::error_code error;
        fs::remove_all(m_folder, error);
    }

    std::string path() const { return m_path.string(); }

    // Serves until the program has ended and everything that it sent is read. Returns its wait status.
    int serve(pid_t program) {
        int status = 0;
        bool running = true;
        while (running || !m_clients.empty()) {
            if (running && waitpid(program, &status, WNOHANG) == program) running = false;
            std::vector<pollfd> files{{m_socket.file(), POLLIN, 0}};
            for (const auto& [file, client] : m_clients) files.push_back({file, POLLIN, 0});
            if (poll(files.data(), files.size(), running ? 50 : 0) <= 0) {
                if (!running) break;
                continue;
            }
            if (files[0].revents & POLLIN) {
                const int file = accept(m_socket.file(), nullptr, nullptr);
                if (file >= 0) m_clients.emplace(file, Socket(file));
            }
            for (std::size_t i = 1; i < files.size(); ++i) {
                if (files[i].revents && !receive(m_clients.at(files[i].fd))) m_clients.erase(files[i].fd);
            }
        }
        return status;
    }

    void print_statistics() const {
        if (m_frames == 0) {
            fmt::print(stderr, "terrazzo: the program showed no frame\n");
            return;
        }
        const auto per_frame = [&](std::uint64_t total) {
            return static_cast<double>(total) / static_cast<double>(m_frames);
        };
        const auto milliseconds = [&](std::uint64_t total) { return per_frame(total) / 1e6; };
        const double seconds = static_cast<double>(m_sum.nanoseconds) / 1e9;
        fmt::print(stderr, "terrazzo: {} frames in {:.2f} s: {:.1f} a second, {}x{} at last\n", m_frames,
                   seconds, static_cast<double>(m_frames) / seconds, m_sum.width, m_sum.height);
        fmt::print(stderr, "  a frame  {:10.0f} primitives\n", per_frame(m_sum.primitives));
        fmt::print(stderr, "           {:10.0f} pixels\n", per_frame(m_sum.pixels));
        fmt::print(stderr, "           {:10.3f} ms vertices to primitives\n",
                   milliseconds(m_sum.vertex_nanoseconds));
        fmt::print(stderr, "           {:10.3f} ms pixels\n", milliseconds(m_sum.pixel_nanoseconds));
        fmt::print(stderr, "           {:10.3f} ms window system\n", milliseconds(m_sum.show_nanoseconds));
        fmt::print(stderr, "           {:10.3f} ms altogether, the program included\n",
                   milliseconds(m_sum.nanoseconds));
    }

  private:
    bool receive(const Socket& client) {
        WatchedFrame frame;
        if (!client.read_all(&frame, sizeof frame) || frame.magic != WatchedFrame::kMagic) return false;
        constexpr std::uint64_t kLargest = 16384ull * 16384 * 4;
        const bool sound =
            frame.picture_bytes == 0 || frame.picture_bytes == std::uint64_t{frame.width} * frame.height * 4;
        if (!sound || frame.picture_bytes > kLargest) return false;
        std::vector<std::uint8_t> pixels(frame.picture_bytes);
        if (!client.read_all(pixels.data(), pixels.size())) return false;
        ++m_frames;
        m_sum.width = frame.width;
        m_sum.height = frame.height;
        m_sum.primitives += frame.primitives;
        m_sum.pixels += frame.pixels;
        m_sum.nanoseconds += frame.nanoseconds;
        m_sum.vertex_nanoseconds += frame.vertex_nanoseconds;
        m_sum.pixel_nanoseconds += frame.pixel_nanoseconds;
        m_sum.show_nanoseconds += frame.show_nanoseconds;
        if (!pixels.empty() && !m_options.record.empty()) {
            flip(pixels, frame.width * std::size_t{4});
            const auto picture =
                report::picture_of(pixels, static_cast<int>(frame.width), static_cast<int>(frame.height), 4);
            report::write_picture(picture,
                                  (fs::path(m_options.record) / fmt::format("{:06}.png", m_frames)).string());
        }
        return true;
    }

    const Options& m_options;
    Socket m_socket;
    fs::path m_folder, m_path;
    std::map<int, Socket> m_clients;
    std::uint64_t m_frames = 0;
    WatchedFrame m_sum;
};

void run(const Options& options) {
    use_terrazzo(options.threads);
    if (options.record.empty() && !options.stats) become(options.command);
    Listener listener(options);
    set("TERRAZZO_WATCH", listener.path());
    if (!options.record.empty()) set("TERRAZZO_WATCH_PICTURES", "1");
    // A key that interrupts is the program's to answer to: what it drew is still to be told.
    signal(SIGINT, SIG_IGN);
    const pid_t program = fork();
    if (program < 0) throw std::runtime_error("fork failed");
    if (program == 0) {
        signal(SIGINT, SIG_DFL);
        become(options.command);
    }
    const int status = listener.serve(program);
    if (options.stats) listener.print_statistics();
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (code != 0) throw CLI::RuntimeError(code);
}

}  // namespace

void add_run_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "run", "Run a GLX, EGL or OSMesa program on Terrazzo: terrazzo run [OPTIONS] PROGRAM [ARGUMENTS...]");
    command
        ->add_option("-t,--threads", options->threads, "Threads that draw, the program's included; 0: as 1")
        ->check(CLI::Range(0, 64));
    command->add_option("-r,--record", options->record, "Write every frame to this folder, a PNG each");
    command->add_flag("-s,--stats", options->stats,
                      "When the program has ended, say what its frames were: primitives (points, lines, "
                      "triangles and rectangles "
                      "after clipping and culling), pixels (their fragments that passed all tests; overdraw "
                      "counts, clears do not), and where the time went");
    command->prefix_command();
    command->callback([options, command] {
        options->command = command->remaining();
        if (options->command.empty()) throw CLI::ValidationError("run", "which program?");
        run(*options);
    });
}

}  // namespace terrazzo
