// The thread pool; see workers.h.
#include "pipeline/schedule/workers.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "simd/environment.h"
#include "simd/traps.h"

namespace terrazzo::pipeline {

namespace {

class Pool {
  public:
    void run(int threads, int count, const std::function<void(int, int)>& work);
    ~Pool();

  private:
    void serve(int thread);  // from 1 on: 0 is the caller
    static void take(std::atomic<int>& next, int count, int thread,
                     const std::function<void(int, int)>& work) {
        for (int i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) work(i, thread);
    }

    std::mutex m_mutex;
    std::condition_variable m_wake, m_done;
    std::vector<std::thread> m_threads;
    const std::function<void(int, int)>* m_work = nullptr;  // null while there is nothing to do
    std::atomic<int> m_next{0};
    int m_count = 0;
    int m_busy = 0;  // threads inside the current job
    bool m_running = false, m_stop = false;
};

void Pool::run(int threads, int count, const std::function<void(int, int)>& work) {
    std::unique_lock lock(m_mutex);
    if (m_running) {
        lock.unlock();
        for (int i = 0; i < count; ++i) work(i, 0);
        return;
    }
    m_running = true;
    try {
        while (static_cast<int>(m_threads.size()) < threads - 1)
            m_threads.emplace_back(
                [this, thread = static_cast<int>(m_threads.size()) + 1] { serve(thread); });
    } catch (const std::system_error&) {
        // The caller draws with the threads there are.
    } catch (const std::bad_alloc&) {
    }
    m_work = &work;
    m_count = count;
    m_next.store(0, std::memory_order_relaxed);
    lock.unlock();
    m_wake.notify_all();

    take(m_next, count, 0, work);

    lock.lock();
    m_work = nullptr;
    m_done.wait(lock, [this] { return m_busy == 0; });
    m_running = false;
}

void Pool::serve(int thread) {
    const WithoutTraps without_traps;  // threads begin with those of the one that starts them
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] {
            return m_stop || (m_work != nullptr && m_next.load(std::memory_order_relaxed) < m_count);
        });
        if (m_stop) return;
        const std::function<void(int, int)>& work = *m_work;
        const int count = m_count;
        ++m_busy;
        lock.unlock();
        take(m_next, count, thread, work);
        lock.lock();
        if (--m_busy == 0) m_done.notify_one();
    }
}

Pool::~Pool() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_all();
    for (std::thread& thread : m_threads) thread.join();
}

// Replaced in a forked child, where the parent's threads do not exist and its mutex may be held.
Pool* g_pool = nullptr;
std::mutex g_pool_mutex;

// Null where there is no memory for it.
Pool* pool() {
    const std::lock_guard lock(g_pool_mutex);
    static bool registered = false;
    if (!registered)
        registered = pthread_atfork([] { g_pool_mutex.lock(); }, [] { g_pool_mutex.unlock(); },
                                    [] { g_pool = nullptr, g_pool_mutex.unlock(); }) == 0;
    if (registered && g_pool == nullptr) g_pool = new (std::nothrow) Pool;
    return g_pool;
}

// Threads must be gone before the library's code is: dlclose runs this.
struct PoolEnd {
    ~PoolEnd() {
        delete g_pool;
        g_pool = nullptr;
    }
} g_pool_end;

int read_thread_count() {
    if (const char* const text = setting("TERRAZZO_THREADS")) {
        char* end = nullptr;
        const long value = std::strtol(text, &end, 10);
        if (end != text && *end == '\0' && value >= 0) return static_cast<int>(std::clamp(value, 1L, 256L));
    }
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
}

}  // namespace

int thread_count() {
    static const int count = read_thread_count();
    return count;
}

void run_parallel(int count, const std::function<void(int, int)>& work) {
    const WithoutTraps without_traps;
    const int threads = std::min(thread_count(), count);
    if (Pool* const threads_there = threads > 1 ? pool() : nullptr) {
        threads_there->run(threads, count, work);
    } else {
        for (int i = 0; i < count; ++i) work(i, 0);
    }
}

}  // namespace terrazzo::pipeline
