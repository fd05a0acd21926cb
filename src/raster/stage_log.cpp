// Ways and their counts, kept until the process ends; see stage_log.h.
#include "raster/stage_log.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <vector>

#include "simd/environment.h"

namespace terrazzo::raster {

struct StageCount {
    std::string text;
    bool is_slow = false;
    std::atomic<uint64_t> tiles = 0, fragments = 0;
};

namespace {

std::string text_of(const StageNames& names) {
    std::string text;
    for (int i = 0; i < names.count; ++i) {
        const StageName& stage = names.of[i];
        if (i != 0) text += ' ';
        text += stage.part;
        if (stage.unit >= 0) text += std::to_string(stage.unit);
        text += '=';
        text += stage.name;
        if (stage.is_slow) text += "(slow)";
    }
    return text.empty() ? "nothing" : text;
}

class Ways {
  public:
    StageCount& of(const StageNames& names) {
        std::string text = text_of(names);
        const std::lock_guard lock(m_mutex);
        StageCount& count = m_counts[text];
        if (count.text.empty()) {
            count.is_slow = std::any_of(names.of, names.of + names.count,
                                        [](const StageName& stage) { return stage.is_slow; });
            count.text = std::move(text);
        }
        return count;
    }
    void print() {
        const std::lock_guard lock(m_mutex);
        std::vector<const StageCount*> taken;
        uint64_t slow = 0, fragments = 0, slow_fragments = 0;
        for (const auto& [text, count] : m_counts) {
            if (count.tiles == 0) continue;
            taken.push_back(&count);
            fragments += count.fragments;
            if (!count.is_slow) continue;
            ++slow;
            slow_fragments += count.fragments;
        }
        std::stable_sort(taken.begin(), taken.end(), [](const StageCount* a, const StageCount* b) {
            return a->fragments > b->fragments;
        });
        for (const StageCount* count : taken)
            std::fprintf(stderr, "terrazzo: stages: end: %" PRIu64 " tiles, %" PRIu64 " fragments: %s\n",
                         count->tiles.load(), count->fragments.load(), count->text.c_str());
        if (!taken.empty())
            std::fprintf(stderr,
                         "terrazzo: stages: end: slow: %" PRIu64 " of %zu ways, %" PRIu64 " of %" PRIu64
                         " fragments\n",
                         slow, taken.size(), slow_fragments, fragments);
    }
    void lock() { m_mutex.lock(); }
    void unlock() { m_mutex.unlock(); }
    // A child counts what it draws itself.
    void forget_counts() {
        for (auto& [text, count] : m_counts) count.tiles = 0, count.fragments = 0;
    }

  private:
    std::mutex m_mutex;
    std::map<std::string, StageCount> m_counts;  // states point at them: they stay where they are
};

// Never destroyed: programs may draw in destructors of their own.
std::atomic<Ways*> g_ways = nullptr;

Ways& ways() {
    static Ways& the_ways = []() -> Ways& {
        Ways& made = *new Ways;
        g_ways = &made;
        pthread_atfork([] { g_ways.load()->lock(); }, [] { g_ways.load()->unlock(); },
                       [] {
                           g_ways.load()->forget_counts();
                           g_ways.load()->unlock();
                       });
        return made;
    }();
    return the_ways;
}

struct LastWords {
    ~LastWords() {
        try {
            if (Ways* const made = g_ways) made->print();
        } catch (const std::bad_alloc&) {
        }
    }
} g_last_words;

}  // namespace

bool logs_stages() {
    return debug_wishes().stages;
}

StageCount* count_of_stages(const StageNames& names) noexcept {
    try {
        return &ways().of(names);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void count_drawn(StageCount& count, uint64_t tiles, uint64_t fragments) {
    count.fragments.fetch_add(fragments, std::memory_order_relaxed);
    if (count.tiles.fetch_add(tiles, std::memory_order_relaxed) == 0)
        std::fprintf(stderr, "terrazzo: stages: %s\n", count.text.c_str());
}

}  // namespace terrazzo::raster
