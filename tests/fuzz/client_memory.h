// Client memory of exactly the documented size. With the address sanitizer each block is the allocator's,
// which sees every byte before and behind it. Without, a block ends where a page ends, and the next page
// cannot be touched; what is before it holds known bytes, which are looked at now and then. Invariant: a
// block keeps its address until it or the memory it belongs to goes.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "fuzz/random.h"

namespace terrazzo::fuzz {

enum class Contents { kBytes, kFloats, kZeros, kOutput };

class Block {
  public:
    explicit Block(std::size_t bytes);
    Block(Block&& other) noexcept : m_memory(std::exchange(other.m_memory, {})), m_size(other.m_size) {}
    Block& operator=(Block&&) = delete;
    ~Block();

    std::byte* data() const { return m_memory.data() + m_memory.size() - m_size; }
    std::size_t size() const { return m_size; }
    void fill(Random& random, Contents contents);
    // Ends the process with a message where something wrote outside.
    void check() const;

  private:
    std::span<std::byte> m_memory;  // the block and what comes before it
    std::size_t m_size;
};

// Blocks that live as long as a context may look at them.
class ClientMemory {
  public:
    std::byte* add(std::size_t bytes, Random& random, Contents contents);
    void check() const;
    void clear() { m_blocks.clear(); }

  private:
    std::vector<Block> m_blocks;
};

}  // namespace terrazzo::fuzz
