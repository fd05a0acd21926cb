// Memory that ends where nobody may read or write: whoever takes a value more than there is ends the test.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <new>

namespace terrazzo::test {

class GuardedMemory {
  public:
    explicit GuardedMemory(std::size_t bytes) : m_page(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
        m_size = (bytes + m_page - 1) / m_page * m_page;
        void* const memory =
            mmap(nullptr, m_size + m_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        m_memory = static_cast<std::byte*>(memory);
        if (mprotect(m_memory + m_size, m_page, PROT_NONE) != 0) throw std::bad_alloc();
    }
    ~GuardedMemory() { munmap(m_memory, m_size + m_page); }
    GuardedMemory(const GuardedMemory&) = delete;
    GuardedMemory& operator=(const GuardedMemory&) = delete;

    // The last `count` values before the guard, each of them `value`.
    template <typename Value>
    Value* last(std::size_t count, Value value = {}) {
        auto* const first = reinterpret_cast<Value*>(m_memory + m_size) - count;
        for (std::size_t i = 0; i < count; ++i) first[i] = value;
        return first;
    }

  private:
    std::size_t m_page, m_size;
    std::byte* m_memory;
};

}  // namespace terrazzo::test
