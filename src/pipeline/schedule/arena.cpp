// Blocks of a frame's memory; see arena.h.
#include "pipeline/schedule/arena.h"

#include <algorithm>
#include <cstdint>

namespace terrazzo::pipeline {

void Arena::next_block() {
    if (m_used_blocks == m_blocks.size())
        m_blocks.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlockSize));
    m_next = m_blocks[m_used_blocks++].get();
    m_left = kBlockSize;
}

void Arena::reset() {
    // An empty frame says nothing about the next one.
    if (m_used_blocks == 0) return;
    // A frame like the last one finds its blocks; twice as many would be an old peak.
    const size_t wanted = std::max<size_t>(2 * m_used_blocks, 4);
    if (m_blocks.size() > wanted) m_blocks.resize(wanted);
    m_used_blocks = 0;
    m_left = 0;
    m_next = nullptr;
}

bool Arena::is_after(const Mark& mark, const void* memory) const {
    const auto address = reinterpret_cast<uintptr_t>(memory);
    const auto is_between = [&](const std::byte* first, const std::byte* end) {
        return address >= reinterpret_cast<uintptr_t>(first) && address < reinterpret_cast<uintptr_t>(end);
    };
    if (mark.used_blocks != 0 && is_between(mark.next, mark.next + mark.left)) return true;
    for (size_t i = mark.used_blocks; i < m_used_blocks; ++i) {
        const std::byte* const block = m_blocks[i].get();
        if (is_between(block, block + kBlockSize)) return true;
    }
    return false;
}

void Arena::rewind(const Mark& mark) {
    m_used_blocks = mark.used_blocks;
    m_next = mark.next;
    m_left = mark.left;
}

}  // namespace terrazzo::pipeline
