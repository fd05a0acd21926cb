// Memory for planes and images: zeros, on 64-byte boundaries, returned when its owner goes.
//
// Whole megabytes come in huge pages where the system has them: a first frame spends more time on page faults
// than on pixels otherwise. No more memory is touched for it than is asked for.
#pragma once

#include <cstddef>
#include <utility>

namespace terrazzo::raster {

class ZeroedMemory {
  public:
    ZeroedMemory() = default;
    // `data()` is null where there is no memory.
    explicit ZeroedMemory(size_t bytes);
    ~ZeroedMemory();
    ZeroedMemory(ZeroedMemory&& other) noexcept { *this = std::move(other); }
    ZeroedMemory& operator=(ZeroedMemory&& other) noexcept {
        std::swap(m_block, other.m_block);
        std::swap(m_data, other.m_data);
        std::swap(m_mapped, other.m_mapped);
        return *this;
    }

    void* data() const { return m_data; }
    // Makes zeros of it again, or leaves it as it is, where that gives memory back to the system.
    void give_back_pages();

  private:
    bool map_huge(size_t bytes);

    void* m_block = nullptr;  // what is to be freed
    void* m_data = nullptr;
    size_t m_mapped = 0;  // bytes, where the block is a mapping of its own
};

}  // namespace terrazzo::raster
