// Blocks of a frame's memory; see arena.h.
#include "pipeline/schedule/arena.h"

#include <algorithm>
#include <cstdint>

namespace terrazzo::pipeline {

namespace {

bool is_between(const void* memory, const std::byte* first, size_t bytes) {
    const auto address = reinterpret_cast<uintptr_t>(memory), begin = reinterpret_cast<uintptr_t>(first);
    return address >= begin && address < begin + bytes;
}

}  // namespace

std::byte* BlockStore::take() {
    const std::lock_guard lock(m_mutex);
    const size_t used = used_blocks();
    if (used == m_blocks.size()) m_blocks.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlockSize));
    rewind(used + 1);
    return m_blocks[used].get();
}

void BlockStore::reset() {
    const size_t used = used_blocks();
    // An empty frame says nothing about the next one.
    if (used == 0) return;
    // A frame like the last one finds its blocks; twice as many would be an old peak.
    const size_t wanted = std::max<size_t>(2 * used, 4);
    if (m_blocks.size() > wanted) m_blocks.resize(wanted);
    rewind(0);
}

bool BlockStore::is_behind(size_t blocks, const void* memory) const {
    for (size_t i = blocks; i < used_blocks(); ++i)
        if (is_between(memory, m_blocks[i].get(), kBlockSize)) return true;
    return false;
}

void Arena::take_rest(Arena& other) {
    if (other.m_left > m_left) {
        m_next = other.m_next;
        m_left = other.m_left;
    }
    other.reset();
}

bool Arena::is_after(const Mark& mark, const void* memory) const {
    return is_between(memory, mark.next, mark.left) || m_store->is_behind(mark.used_blocks, memory);
}

void Arena::rewind(const Mark& mark) {
    m_store->rewind(mark.used_blocks);
    m_next = mark.next;
    m_left = mark.left;
}

}  // namespace terrazzo::pipeline
