// Runs episodes; see episode.h. A watchdog ends the process when one call takes too long.
#include "fuzz/episode.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

#include "fuzz/operations.h"

namespace terrazzo::fuzz {
namespace {

// Looks at each thread's progress twice a second.
class Watchdog {
  public:
    Watchdog(std::vector<Progress>& progress, unsigned seconds)
        : m_progress(progress), m_limit(2 * seconds), m_thread([this] { watch(); }) {}

    ~Watchdog() {
        {
            const std::lock_guard lock(m_mutex);
            m_done = true;
        }
        m_wake.notify_one();
        m_thread.join();
    }

    void set_thread(std::size_t index, pthread_t thread) {
        const std::lock_guard lock(m_mutex);
        m_threads[index] = thread;
    }

  private:
    void watch() {
        std::vector<std::uint64_t> seen(m_progress.size());
        std::vector<unsigned> waited(m_progress.size());
        std::unique_lock lock(m_mutex);
        while (!m_wake.wait_for(lock, std::chrono::milliseconds(500), [this] { return m_done; })) {
            for (std::size_t i = 0; i < m_progress.size(); ++i) {
                const char* const call = m_progress[i].call;
                const std::uint64_t calls = m_progress[i].calls;
                waited[i] = call && calls == seen[i] ? waited[i] + 1 : 0;
                seen[i] = calls;
                if (waited[i] <= m_limit) continue;
                std::fprintf(stderr, "fuzz: %s does not return (thread %zu, operation %llu)\n", call, i,
                             static_cast<unsigned long long>(m_progress[i].operation));
                pthread_kill(m_threads[i], SIGABRT);  // there, so that the sanitizer shows where it is
                return;
            }
        }
    }

    std::vector<Progress>& m_progress;
    const unsigned m_limit;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_done = false;
    std::array<pthread_t, 16> m_threads{};
    std::thread m_thread;
};

std::unique_ptr<WindowSystem> make_system(const Library& library, const EpisodeOptions& options) {
    std::unique_ptr<WindowSystem> made;
    if (options.system == "osmesa") made = make_osmesa(library);
    if (options.system == "egl") made = make_egl(library);
    if (options.system == "glx") made = make_glx(library);
    if (made) return made;
    std::fprintf(stderr, "fuzz: there is no window system %s\n", options.system.c_str());
    std::exit(2);
}

void run_thread(Session& session, WindowSystem& windows, const EpisodeOptions& options, std::uint64_t seed) {
    const unsigned thread = session.options.thread;
    Random start(seed, thread, UINT64_MAX);
    windows.enter(session, start);
    for (std::uint64_t index = 0; index < options.operations; ++index) {
        if (!options.keep.empty() &&
            !std::ranges::binary_search(options.keep, thread * kThreadStride + index))
            continue;
        Random random(seed, thread, index);
        session.begin_operation(index);
        run_operation(session, windows, random);
    }
    windows.leave(session);
}

}  // namespace

std::uint64_t run_episode(const Library& library, const EpisodeOptions& options, std::uint64_t seed) {
    const auto windows = make_system(library, options);
    std::vector<Progress> progress(options.threads);
    {
        Watchdog watchdog(progress, options.seconds_per_call);
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < options.threads; ++i) {
            threads.emplace_back([&, i] {
                watchdog.set_thread(i, pthread_self());
                Session session(library, {.trace = options.trace, .shared = options.threads > 1, .thread = i},
                                progress[i]);
                run_thread(session, *windows, options, seed);
            });
        }
        for (std::thread& thread : threads) thread.join();
    }
    std::uint64_t calls = 0;
    for (const Progress& p : progress) calls += p.calls;
    return calls;
}

}  // namespace terrazzo::fuzz
