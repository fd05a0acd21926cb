// The memory of one plane of a target, bin by bin, and what is known of the pixels of each bin.
//
// What a bin holds has a number: bins of the same place with the same number hold the same pixels, in
// whichever memory they lie. So a clear to what is there already fills nothing, and planes whose pixels have
// become a texture's go on in other memory without a copy: there each bin is stale until it is touched or
// needed, and is brought over from the texture's only if its number differs.
//
// Invariant: whoever writes to a bin's pixels has called `written` or `filled` for it before anybody compares
// numbers. A bin belongs to one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "raster/target/zeroed_memory.h"

namespace terrazzo::raster {

// Of a bin that holds one value in all its pixels.
constexpr uint64_t uniform_content(uint32_t value) {
    return uint64_t{1} << 63 | value;
}

// Pixels of all bins of a plane. Once a texture has them, nobody writes to them any more.
struct PlanePixels {
    // Zeros. Throws std::bad_alloc.
    PlanePixels(size_t bins, size_t bytes_per_bin);

    std::byte* bin(size_t index) const {
        return static_cast<std::byte*>(memory.data()) + index * bytes_per_bin;
    }
    size_t bin_count() const { return contents.size(); }

    size_t bytes_per_bin;
    ZeroedMemory memory;
    std::vector<uint64_t> contents;  // the number of what each bin holds
};

// What targets share that share a plane.
class PlaneStore {
  public:
    // Throws std::bad_alloc.
    PlaneStore(size_t bins, size_t bytes_per_bin);

    std::byte* bin(size_t index) const { return m_pixels->bin(index); }

    // All pixels of the bin are about to get one value, or values that have no number.
    bool holds(size_t index, std::optional<uint32_t> value) const {
        return value && m_pixels->contents[index] == uniform_content(*value);
    }
    void filled(size_t index, std::optional<uint32_t> value) {
        m_pixels->contents[index] = value ? uniform_content(*value) : m_writing;
        m_stale[index] = 0;
    }
    // The one value of all its pixels, where it has a number.
    std::optional<uint32_t> uniform_value(size_t index) const {
        const uint64_t content = m_pixels->contents[index];
        if (is_stale(index) || content >> 63 == 0) return std::nullopt;
        return static_cast<uint32_t>(content);
    }
    // Some of its pixels are about to change.
    void written(size_t index) { m_pixels->contents[index] = m_writing; }

    // Whether the bin's pixels are still those of the texture.
    bool is_stale(size_t index) const { return m_stale[index] != 0; }
    bool needs_copy(size_t index) const {
        return is_stale(index) && m_pixels->contents[index] != m_source->contents[index];
    }
    void bring_over(size_t index);

    // Hands over the pixels, none of which is stale, and goes on in `next`.
    std::shared_ptr<PlanePixels> exchange(std::shared_ptr<PlanePixels> next);
    // Lets all bins hold what `source` does.
    void start_from(std::shared_ptr<const PlanePixels> source);
    // Nothing is stale any more, or will be overwritten.
    void let_go_of_source();

  private:
    std::shared_ptr<PlanePixels> m_pixels;
    std::shared_ptr<const PlanePixels> m_source;  // of stale bins
    std::vector<uint8_t> m_stale;                 // one a bin: a bin belongs to one thread
    uint64_t m_writing;                           // the number of what is being drawn
};

// A plane of values of one type, or none.
template <class T>
class Plane {
  public:
    Plane() = default;
    // `bins_across` of each row of bins, each with `count` values. Throws std::bad_alloc.
    Plane(int bins_across, int bins_up, size_t count)
        : m_store(std::make_shared<PlaneStore>(
              static_cast<size_t>(bins_across) * static_cast<size_t>(bins_up), count * sizeof(T))),
          m_bins_across(bins_across) {}
    explicit operator bool() const { return m_store != nullptr; }
    T* get() const { return m_store ? reinterpret_cast<T*>(m_store->bin(0)) : nullptr; }
    int bins_across() const { return m_bins_across; }
    size_t index(int column, int row) const { return static_cast<size_t>(row * m_bins_across + column); }
    // The values of the bin in this column and row; null where there is no plane.
    T* bin(int column, int row) const {
        return m_store ? reinterpret_cast<T*>(m_store->bin(index(column, row))) : nullptr;
    }
    PlaneStore& store() const { return *m_store; }

  private:
    std::shared_ptr<PlaneStore> m_store;
    int m_bins_across = 0;
};

}  // namespace terrazzo::raster
