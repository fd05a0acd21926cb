// Counts and times of a process's drawing, for people who want to know where a frame's time goes.
//
// Off, as it is unless a front end turns it on before anything is drawn, it costs one test a draw, a bin and
// a fragment state. On, fragments go through kernels that count them (FragmentKey::counts_samples).
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace terrazzo::pipeline {

struct Statistics {
    std::atomic<bool> enabled = false;
    std::atomic<std::uint64_t> primitives = 0;  // in frames; one that crosses bins counts once
    std::atomic<std::uint64_t> pixels =
        0;  // of primitives, that passed all tests: overdraw counts, clears do not
    std::atomic<std::uint64_t> vertex_nanoseconds =
        0;  // from vertices to primitives in bins, with frames drawn early
    std::atomic<std::uint64_t> pixel_nanoseconds = 0;  // frames
};

inline constinit Statistics statistics;

// Adds the time of its life to a total.
class StageTimer {
  public:
    explicit StageTimer(std::atomic<std::uint64_t>& total) : m_total(statistics.enabled ? &total : nullptr) {
        if (m_total) m_begin = std::chrono::steady_clock::now();
    }
    ~StageTimer() {
        if (m_total)
            *m_total += static_cast<std::uint64_t>((std::chrono::steady_clock::now() - m_begin).count());
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    std::atomic<std::uint64_t>* m_total;
    std::chrono::steady_clock::time_point m_begin;
};

}  // namespace terrazzo::pipeline
