// Memory of a frame: handed out in order, taken back all at once.
//
// Input: nothing but sizes. Output: memory for primitives and bin lists, in blocks that the next frame finds
// again. What was handed out after a mark can be told from what was there before, and taken back.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace terrazzo::pipeline {

class Arena {
  public:
    static constexpr size_t kBlockSize = 256 * 1024;

    // 16-byte aligned; throws std::bad_alloc. At most kBlockSize bytes.
    void* allocate(size_t bytes) {
        bytes = (bytes + 15) & ~size_t{15};
        if (bytes > m_left) next_block();
        std::byte* const memory = m_next;
        m_next += bytes;
        m_left -= bytes;
        return memory;
    }
    size_t used_bytes() const { return m_used_blocks * kBlockSize; }
    // Takes everything back; blocks are kept for the next frame, but no more than the last ones needed.
    void reset();

    // How far the memory is handed out.
    struct Mark {
        size_t used_blocks;
        std::byte* next;
        size_t left;
    };
    Mark mark() const { return {m_used_blocks, m_next, m_left}; }
    // Whether memory was handed out after the mark was taken.
    bool is_after(const Mark& mark, const void* memory) const;
    // Takes back what was handed out since.
    void rewind(const Mark& mark);

  private:
    void next_block();

    std::vector<std::unique_ptr<std::byte[]>> m_blocks;
    size_t m_used_blocks = 0;
    std::byte* m_next = nullptr;
    size_t m_left = 0;
};

}  // namespace terrazzo::pipeline
