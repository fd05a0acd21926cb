// Allocation of planes and images; see zeroed_memory.h.
#include "raster/target/zeroed_memory.h"

#include <cstdint>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace terrazzo::raster {

namespace {

constexpr size_t kAlignment = 64;

constexpr size_t aligned_up(size_t value, size_t alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

ZeroedMemory::ZeroedMemory(size_t bytes) {
    if (map_huge(bytes)) return;
    if (bytes > SIZE_MAX - kAlignment) return;
    m_block = std::calloc(1, bytes + kAlignment);
    if (m_block == nullptr) return;
    m_data = reinterpret_cast<void*>(aligned_up(reinterpret_cast<uintptr_t>(m_block), kAlignment));
}

ZeroedMemory::~ZeroedMemory() {
#ifdef __linux__
    if (m_mapped != 0) {
        munmap(m_block, m_mapped);
        return;
    }
#endif
    std::free(m_block);
}

void ZeroedMemory::give_back_pages() {
#ifdef __linux__
    if (m_mapped != 0) madvise(m_block, m_mapped, MADV_DONTNEED);
#endif
}

bool ZeroedMemory::map_huge(size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // The size of huge pages on x86 and on ARM with pages of 4 KiB; with others the advice is not taken.
    constexpr size_t kHugePage = size_t{2} << 20;
    if (bytes < kHugePage || bytes > SIZE_MAX / 2) return false;
    const size_t reserved = bytes + kHugePage;
    void* const block = mmap(nullptr, reserved, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) return false;
    m_block = block;
    m_mapped = reserved;
    m_data = reinterpret_cast<void*>(aligned_up(reinterpret_cast<uintptr_t>(block), kHugePage));
    madvise(m_data, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    return true;
#else
    (void)bytes;
    return false;
#endif
}

}  // namespace terrazzo::raster
