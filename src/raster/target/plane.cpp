// What becomes of a plane's memory; see plane.h.
#include "raster/target/plane.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <utility>

namespace terrazzo::raster {

namespace {

uint64_t new_content() {
    static std::atomic<uint64_t> last{0};
    return 1 + last.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

PlanePixels::PlanePixels(size_t bins, size_t bytes)
    : bytes_per_bin(bytes), memory(bins * bytes), contents(bins, uniform_content(0)) {
    if (memory.data() == nullptr) throw std::bad_alloc();
}

PlaneStore::PlaneStore(size_t bins, size_t bytes_per_bin)
    : m_pixels(std::make_shared<PlanePixels>(bins, bytes_per_bin)), m_stale(bins), m_writing(new_content()) {}

void PlaneStore::bring_over(size_t index) {
    if (needs_copy(index)) {
        std::memcpy(m_pixels->bin(index), m_source->bin(index), m_pixels->bytes_per_bin);
        m_pixels->contents[index] = m_source->contents[index];
    }
    m_stale[index] = 0;
}

std::shared_ptr<PlanePixels> PlaneStore::exchange(std::shared_ptr<PlanePixels> next) {
    auto pixels = std::exchange(m_pixels, std::move(next));
    start_from(pixels);
    return pixels;
}

void PlaneStore::start_from(std::shared_ptr<const PlanePixels> source) {
    m_source = std::move(source);
    std::ranges::fill(m_stale, uint8_t{1});
    m_writing = new_content();
}

void PlaneStore::let_go_of_source() {
    std::ranges::fill(m_stale, uint8_t{0});
    m_source.reset();
}

}  // namespace terrazzo::raster
