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

constexpr int kMostThreads = 256;

// Numbers [0, count), a share of neighbours for each thread: it takes them one after the other, then helps
// with the last ones of the fullest share. So threads work far from each other, where no cache line is two
// bins', and a bin comes to the thread that had it in the frame before.
class Shares {
  public:
    void divide(int count, int shares) {
        m_count = shares;
        const auto bound = [&](int share) { return static_cast<uint32_t>(int64_t{count} * share / shares); };
        for (int i = 0; i < shares; ++i) m_shares[i].left.store(pack({bound(i), bound(i + 1)}), kRelaxed);
    }
    bool any() const {
        for (int i = 0; i < m_count; ++i)
            if (unpack(m_shares[i].left.load(kRelaxed)).size() != 0) return true;
        return false;
    }
    // -1 when there are none left.
    int take(int thread) {
        if (thread < m_count)
            if (const int number = take_first(m_shares[thread]); number >= 0) return number;
        for (;;) {
            Share* const fullest =
                std::max_element(m_shares, m_shares + m_count, [](const Share& a, const Share& b) {
                    return unpack(a.left.load(kRelaxed)).size() < unpack(b.left.load(kRelaxed)).size();
                });
            uint64_t packed = fullest->left.load(kRelaxed);
            const Range left = unpack(packed);
            if (left.size() == 0) return -1;
            if (fullest->left.compare_exchange_weak(packed, pack({left.first, left.end - 1}), kRelaxed))
                return static_cast<int>(left.end - 1);
        }
    }

  private:
    static constexpr auto kRelaxed = std::memory_order_relaxed;
    struct Range {
        uint32_t first, end;
        uint32_t size() const { return end - first; }
    };
    static uint64_t pack(Range r) { return uint64_t{r.end} << 32 | r.first; }
    static Range unpack(uint64_t packed) {
        return {static_cast<uint32_t>(packed), static_cast<uint32_t>(packed >> 32)};
    }
    struct alignas(64) Share {
        std::atomic<uint64_t> left = 0;
    };
    static int take_first(Share& share) {
        for (uint64_t packed = share.left.load(kRelaxed);;) {
            const Range left = unpack(packed);
            if (left.size() == 0) return -1;
            if (share.left.compare_exchange_weak(packed, pack({left.first + 1, left.end}), kRelaxed))
                return static_cast<int>(left.first);
        }
    }

    Share m_shares[kMostThreads];
    int m_count = 0;
};

class Pool {
  public:
    void run(int threads, int count, const std::function<void(int, int)>& work);
    ~Pool();

  private:
    void serve(int thread);  // from 1 on: 0 is the caller
    void take_all(int thread, const std::function<void(int, int)>& work) {
        for (int i; (i = m_shares.take(thread)) >= 0;) work(i, thread);
    }

    std::mutex m_mutex;
    std::condition_variable m_wake, m_done;
    std::vector<std::thread> m_threads;
    const std::function<void(int, int)>* m_work = nullptr;  // null while there is nothing to do
    Shares m_shares;
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
    m_shares.divide(count, threads);
    lock.unlock();
    m_wake.notify_all();

    take_all(0, work);

    lock.lock();
    m_work = nullptr;
    m_done.wait(lock, [this] { return m_busy == 0; });
    m_running = false;
}

void Pool::serve(int thread) {
    const WithoutTraps without_traps;  // threads begin with those of the one that starts them
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_stop || (m_work != nullptr && m_shares.any()); });
        if (m_stop) return;
        const std::function<void(int, int)>& work = *m_work;
        ++m_busy;
        lock.unlock();
        take_all(thread, work);
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
        if (end != text && *end == '\0' && value >= 0)
            return static_cast<int>(std::clamp(value, 1L, long{kMostThreads}));
    }
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned{kMostThreads}));
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
