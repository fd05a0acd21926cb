// Memory of a frame: handed out in order, taken back all at once.
//
// Input: nothing but sizes. Output: memory for primitives and bin lists. Blocks come from the frame's store,
// which keeps them for the next frame; each thread that fills the frame hands its blocks out by an arena of
// its own. What was handed out after a mark can be told from what was there before, and taken back.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace terrazzo::pipeline {

class BlockStore {
  public:
    static constexpr size_t kBlockSize = 256 * 1024;

    // One more block; throws std::bad_alloc. Several threads may call this at a time.
    std::byte* take();
    size_t used_blocks() const { return m_used_blocks.load(std::memory_order_relaxed); }
    size_t used_bytes() const { return used_blocks() * kBlockSize; }
    // Takes everything back; blocks are kept for the next frame, but no more than the last ones needed.
    void reset();
    // Takes all back but the first so many.
    void rewind(size_t used_blocks) { m_used_blocks.store(used_blocks, std::memory_order_relaxed); }
    // Whether memory is in a block behind the first so many.
    bool is_behind(size_t blocks, const void* memory) const;

  private:
    std::mutex m_mutex;  // held while a block is taken
    std::vector<std::unique_ptr<std::byte[]>> m_blocks;
    std::atomic<size_t> m_used_blocks = 0;
};

class Arena {
  public:
    explicit Arena(BlockStore& store) : m_store(&store) {}

    // 16-byte aligned; throws std::bad_alloc. At most BlockStore::kBlockSize bytes.
    void* allocate(size_t bytes) {
        bytes = (bytes + 15) & ~size_t{15};
        if (bytes > m_left) next_block();
        std::byte* const memory = m_next;
        m_next += bytes;
        m_left -= bytes;
        return memory;
    }
    // Begins anew, with the next block.
    void reset() { m_next = nullptr, m_left = 0; }
    // Goes on with what is left of another arena's block, where that is more than what is left here. The
    // other begins anew.
    void take_rest(Arena& other);

    // How far the store's memory is handed out, while this is the only arena in use.
    struct Mark {
        size_t used_blocks;
        std::byte* next;
        size_t left;
    };
    Mark mark() const { return {m_store->used_blocks(), m_next, m_left}; }
    // Whether memory was handed out after the mark was taken, by whichever arena.
    bool is_after(const Mark& mark, const void* memory) const;
    // Takes back what was handed out since, by whichever arena.
    void rewind(const Mark& mark);

  private:
    void next_block() {
        m_next = m_store->take();
        m_left = BlockStore::kBlockSize;
    }

    BlockStore* m_store;
    std::byte* m_next = nullptr;
    size_t m_left = 0;
};

}  // namespace terrazzo::pipeline
