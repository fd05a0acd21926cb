// What the primitives of a frame point at, kept alive until the frame has been drawn: fragment states with
// their images, the pixels of rectangles. And the counters of the occlusion queries among the states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "pipeline/schedule/fragment_block.h"

namespace terrazzo::pipeline {

class Kept {
  public:
    // A fragment state.
    void keep(std::shared_ptr<const FragmentBlock> block) {
        if (!m_kept.empty() && m_kept.back() == block) return;
        if (block->fill.samples_passed) m_sample_counters.push_back(block->fill.samples_passed);
        const size_t bytes = block->size_in_bytes();
        keep(std::move(block), bytes);
    }
    // The same for other memory.
    void keep(std::shared_ptr<const void> memory, size_t bytes) {
        m_kept.push_back(std::move(memory));
        m_bytes += bytes;
    }
    // Without images.
    size_t bytes() const { return m_bytes; }
    const std::vector<uint64_t*>& sample_counters() const { return m_sample_counters; }

    struct Mark {
        size_t kept, bytes, counters;
    };
    Mark mark() const { return {m_kept.size(), m_bytes, m_sample_counters.size()}; }
    // Forgets what was kept since.
    void take_back(const Mark& mark) {
        m_kept.resize(mark.kept);
        m_bytes = mark.bytes;
        m_sample_counters.resize(mark.counters);
    }
    void clear() { take_back({0, 0, 0}); }

  private:
    std::vector<std::shared_ptr<const void>> m_kept;
    size_t m_bytes = 0;
    std::vector<uint64_t*> m_sample_counters;
};

}  // namespace terrazzo::pipeline
