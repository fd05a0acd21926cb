// Exact blocks; see client_memory.h.
#include "fuzz/client_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

namespace terrazzo::fuzz {
namespace {

constexpr std::byte kGuardByte{0xa7};

#ifdef __SANITIZE_ADDRESS__

std::span<std::byte> allocate(std::size_t bytes) {
    return {static_cast<std::byte*>(::operator new(bytes)), bytes};
}

void release(std::span<std::byte> memory) {
    ::operator delete(memory.data());
}

#else

constexpr std::size_t kPage = 4096;

std::span<std::byte> allocate(std::size_t bytes) {
    const std::size_t size = (bytes + kPage) / kPage * kPage;
    void* const memory =
        mmap(nullptr, size + kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED || mprotect(static_cast<std::byte*>(memory) + size, kPage, PROT_NONE) != 0)
        throw std::bad_alloc();
    const std::span out(static_cast<std::byte*>(memory), size);
    std::ranges::fill(out.first(size - bytes), kGuardByte);
    return out;
}

void release(std::span<std::byte> memory) {
    munmap(memory.data(), memory.size() + kPage);
}

#endif

float hostile_float(Random& random) {
    using Limits = std::numeric_limits<float>;
    if (!random.one_in(8)) return static_cast<float>(random.between(-1000, 1000)) / 500.0f;
    return random.of({0.0f, -0.0f, 1.0f, -1.0f, 1e30f, -1e30f, Limits::max(), Limits::infinity(),
                      -Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min(), 65536.0f,
                      2147483648.0f});
}

}  // namespace

Block::Block(std::size_t bytes) : m_memory(allocate(bytes)), m_size(bytes) {}

Block::~Block() {
    if (!m_memory.data()) return;
    check();
    release(m_memory);
}

void Block::check() const {
    const auto before = m_memory.first(m_memory.size() - m_size);
    if (std::ranges::all_of(before, [](std::byte b) { return b == kGuardByte; })) return;
    std::fprintf(stderr, "fuzz: written before a block of %zu bytes\n", m_size);
    std::abort();
}

void Block::fill(Random& random, Contents contents) {
    constexpr std::size_t kDistinct = 1024;  // what follows repeats, so that large images stay quick
    const std::size_t drawn = std::min(m_size, kDistinct);
    if (contents == Contents::kOutput || contents == Contents::kZeros) {
        std::memset(data(), contents == Contents::kZeros ? 0 : 0x5a, m_size);
        return;
    }
    for (std::size_t at = 0; at < drawn;) {
        const float real = hostile_float(random);
        const std::uint64_t bits = random.bits();
        const bool is_float = contents == Contents::kFloats;
        const std::size_t size = std::min(drawn - at, is_float ? sizeof real : sizeof bits);
        std::memcpy(data() + at, is_float ? static_cast<const void*>(&real) : &bits, size);
        at += size;
    }
    for (std::size_t at = kDistinct; at < m_size; at += kDistinct)
        std::memcpy(data() + at, data(), std::min(kDistinct, m_size - at));
}

std::byte* ClientMemory::add(std::size_t bytes, Random& random, Contents contents) {
    m_blocks.emplace_back(bytes).fill(random, contents);
    return m_blocks.back().data();
}

void ClientMemory::check() const {
    for (const Block& block : m_blocks) block.check();
}

}  // namespace terrazzo::fuzz
