// A render target: colour, depth and stencil in two-level tiles [Frolov 2020 §3, row R-13].
//
// Row 0 is the first row in memory: RowOrder says whether it is the top one or the bottom one. The target is
// cut into bins of 64x64 pixels, row by row; a bin's planes are contiguous, its 4x4 tiles follow one another
// row by row, the 16 pixels of a tile likewise. Colour is what ColorFormat says, depth is one uint32 a pixel
// holding depth_bits significant bits (whatever their number), stencil one byte a pixel. A clear of the whole
// target only marks its bins; a bin is filled when it is first touched.
//
// Of a multisampled target (GL 1.5 §3.2.1) a bin has each plane once for every sample, one behind the other.
// Where all samples of a tile's pixels are alike the tile is marked so, and only the first sample's pixels
// count: most tiles never know more than that. Writing the same to all samples leaves the marks as they are.
//
// Of a target with two colour buffers one is in its place at a time, where bin() finds it.
//
// Threads: size and format never change. Whoever touches the planes of a target that others may have at the
// same time holds its mutex meanwhile, as TargetUse does; at any time a bin belongs to one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "raster/target/formats.h"
#include "raster/target/plane.h"

namespace terrazzo::raster {

inline constexpr int kTileSize = 4;
inline constexpr int kTilePixels = kTileSize * kTileSize;
inline constexpr int kBinSize = 64;
inline constexpr int kBinPixels = kBinSize * kBinSize;
inline constexpr int kBinTiles = kBinPixels / kTilePixels;
inline constexpr int kTilesAcross = kBinSize / kTileSize;

inline constexpr int kMaxSamples = 4;

// Where in a pixel its samples are, in 256ths; y as rows go (GL 1.5 §3.2.1 leaves it to us: the reference's
// places).
struct SamplePosition {
    int x, y;
};
constexpr SamplePosition kSamplePositions[kMaxSamples] = {{96, 32}, {224, 96}, {32, 160}, {160, 224}};

// Index of a pixel within its bin's planes, for 0 <= x, y < 64.
constexpr int pixel_index(int x, int y) {
    return ((y >> 2) * kTilesAcross + (x >> 2)) * kTilePixels + (y & 3) * kTileSize + (x & 3);
}

struct ClearValues {
    float color[4] = {};
    uint32_t depth = 0;  // in the target's depth format
    uint8_t stencil = 0;
};

// Which planes a clear touches.
struct ClearPlanes {
    bool color = false, depth = false, stencil = false;

    constexpr bool any() const { return color || depth || stencil; }
};

// Windows have their top row first, frame buffer objects their bottom row, as in the reference: it decides
// how vertices snap and in which direction planes are interpolated.
enum class RowOrder : uint8_t { kTopFirst, kBottomFirst };

struct TargetFormat {
    ColorFormat color = ColorFormat::kRgba8;
    bool has_alpha = true;
    uint8_t depth_bits = 24;   // 0, 16, 24 (or 32: the bits of a float, later)
    uint8_t stencil_bits = 8;  // 0 or 8
    RowOrder rows = RowOrder::kTopFirst;
    uint8_t samples = 1;  // of a pixel: 1 or kMaxSamples

    friend bool operator==(const TargetFormat&, const TargetFormat&) = default;
};

// Pixels of a target in its own coordinates: row 0 is the first in memory.
struct RowRect {
    int x, row, width, height;
};

// Rows `first` to `end` - 1.
struct RowRange {
    int64_t first, end;
};

// The rows of a target that lie `low` to `high` - 1 above its lowest row, and the other way round. They may
// leave the target.
constexpr RowRange turn_rows(RowOrder order, int height, int64_t low, int64_t high) {
    return order == RowOrder::kTopFirst ? RowRange{height - high, height - low} : RowRange{low, high};
}

// Which of a target's colour buffers; one that has no second has the first.
enum class ColorPlane : uint8_t { kFirst, kSecond };

// What is known of a bin besides its pixels.
struct BinState {
    ClearPlanes pending;  // planes still to be filled with `clear`
    ClearValues clear;
    // No pixel's depth is above this, as window z; infinite where nothing better is known (hidden.h).
    float farthest = std::numeric_limits<float>::infinity();
    bool bounds_pending = false;  // of the bin's tiles: all are `farthest`, and are still to be written
    uint32_t hidden = 0;          // primitives that were found behind all tiles they touch
};

// One bin of a target as the kernels see it.
struct Bin {
    std::byte* color;
    uint32_t* depth;
    uint8_t* stencil;
    float* farthest;  // one bound a tile, as BinState's; whoever writes depths keeps them true
    int x, y;         // of its first pixel
    BinState* state;
    // One byte a tile: whether the first sample's pixels are those of all samples. Null where there is one
    // sample.
    uint8_t *color_alike = nullptr, *depth_alike = nullptr, *stencil_alike = nullptr;
    uint64_t samples_passed = 0;  // while FragmentKey::counts_samples says so
};

// One sample's planes of a multisampled bin, as if they were all there are.
[[gnu::always_inline]] inline Bin planes_of_sample(const Bin& bin, int sample, ColorFormat format) {
    Bin out = bin;
    const size_t pixels = static_cast<size_t>(sample) * kBinPixels;
    if (bin.color) out.color += pixels * static_cast<size_t>(bytes_per_pixel(format));
    if (bin.depth) out.depth += pixels;
    if (bin.stencil) out.stencil += pixels;
    return out;
}

// Gives each sample of a tile pixels of its own, in a plane whose pixels have so many bytes.
[[gnu::always_inline]] inline void spread_tile(void* plane, int tile, size_t pixel_bytes, uint8_t* alike) {
    if (!alike[tile]) return;
    alike[tile] = 0;
    std::byte* const first =
        static_cast<std::byte*>(plane) + static_cast<size_t>(tile) * kTilePixels * pixel_bytes;
    for (size_t s = 1; s < kMaxSamples; ++s)
        std::memcpy(first + s * kBinPixels * pixel_bytes, first, kTilePixels * pixel_bytes);
}

class Target;

// Planes that a target has in common with others, of its size or larger.
struct SharedPlanes {
    const Target* color = nullptr;  // null: no colour plane; nothing may be drawn to it
    const Target* depth = nullptr;
    const Target* stencil = nullptr;
};

class Target {
  public:
    // Throws std::bad_alloc. 1 <= width, height <= 16384.
    Target(int width, int height, TargetFormat format);
    // The planes are others'. Only one of the targets that share them may be in use at a time: settle() comes
    // before the next one, start_over() first of all in that.
    Target(int width, int height, TargetFormat format, const SharedPlanes& planes);
    // Without a colour plane.
    static std::shared_ptr<Target> depth_and_stencil(int width, int height, TargetFormat format);
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    // Fills what is still to be cleared everywhere. By rows of bins, which may be settled on several threads
    // at a time, and how many bins there are to fill in all.
    void settle();
    void settle_row(int row_of_bins);
    int bins_to_fill() const;
    // Takes over planes that others have drawn to.
    void start_over();

    int width() const { return m_width; }
    int height() const { return m_height; }
    // The row that lies y above the lowest one.
    int row(int y) const { return static_cast<int>(turn_rows(m_format.rows, m_height, y, y + 1).first); }
    bool has_color() const { return static_cast<bool>(m_color); }
    int bins_across() const { return m_bins_across; }
    int bins_up() const { return m_bins_up; }
    int bin_count() const { return m_bins_across * m_bins_up; }
    const TargetFormat& format() const { return m_format; }
    // Whether pixels beyond this target's edges belong to others that share its planes.
    bool is_part() const { return m_is_part; }

    Bin bin(int index);
    // Marks the planes of one bin as cleared.
    void clear_bin(int index, ClearPlanes planes, const ClearValues& values);
    // What all pixels of a bin hold, still to be cleared or not, of the planes that are asked for and exist;
    // none where they differ or nothing is known of them.
    std::optional<ClearValues> uniform_values(int index, ClearPlanes planes) const;
    // Fills what is still to be cleared, so that the planes hold what GL says they hold and may be written
    // to.
    void materialize(int index) { materialize(index, {true, true, true}); }
    // The same for some planes.
    void materialize(int index, ClearPlanes wanted) { materialize(index, wanted, wanted); }
    // To be read, of which only some are written to.
    void materialize(int index, ClearPlanes wanted, ClearPlanes written);
    void materialize_to_read(int index) { materialize(index, {true, true, true}, {}); }
    // Held by the thread that uses the planes.
    std::mutex& mutex() const { return m_mutex; }
    // Gives the target its second colour buffer, all zero, if it has none yet. Throws std::bad_alloc.
    void make_second_color();
    // Draws to, or shows, this colour buffer from now on, with the same depth and stencil. It is there.
    void select_color(ColorPlane plane);
    // Each colour buffer gets the other's pixels. There is a second one.
    void swap_colors();
    // All but the colours, to be drawn over and come back to. Throws std::bad_alloc.
    struct Depths {
        std::vector<uint32_t> depth;
        std::vector<uint8_t> stencil, depth_alike, stencil_alike;
        std::vector<float> farthest;
        std::vector<BinState> states;
    };
    Depths save_depths() const;
    void restore_depths(const Depths& saved);
    // Lets a bin's depths be anything: for those who write them outside the kernels.
    void forget_farthest(int index);
    void forget_bounds();
    // Depths in which a texture may be sampled, of a target without anything still to be cleared. They are
    // handed over, and drawing goes on in `next`, memory of the same size, on what was drawn.
    std::unique_ptr<PlanePixels> new_depths() const;
    std::shared_ptr<PlanePixels> exchange_depths(std::shared_ptr<PlanePixels> next);
    // Lets the depths be those of a texture.
    void start_from_depths(std::shared_ptr<const PlanePixels> depths);
    // Brings over what is still the texture's alone: by rows of bins, and how many bins there are to copy.
    void keep_depths_of_row(int row_of_bins);
    int depths_to_copy() const;
    // When they are all there, or all will be overwritten.
    void let_go_of_texture();
    BinState& state(int index) { return m_states[static_cast<size_t>(index)]; }

  private:
    Target(int width, int height, TargetFormat format, std::nullptr_t);
    void allocate_depth_and_stencil();
    // The bin's place in a plane, which may be larger than the target.
    template <class T>
    size_t place_in(const Plane<T>& plane, int index) const {
        if (plane.bins_across() == m_bins_across) return static_cast<size_t>(index);
        return plane.index(index % m_bins_across, index / m_bins_across);
    }
    void fill_color_of(int index);
    void fill_depth_of(int index);
    void fill_stencil_of(int index);
    std::optional<uint32_t> clear_color_word(const BinState& bin) const;
    void exchange_color();
    Plane<std::byte> new_color() const;
    Plane<float> new_farthest() const;
    Plane<uint8_t> new_alike_marks() const;
    // Of all samples of a bin.
    size_t bin_samples() const { return size_t{kBinPixels} * m_format.samples; }

    int m_width, m_height, m_bins_across, m_bins_up;
    TargetFormat m_format;
    bool m_is_part = false;
    mutable std::mutex m_mutex;
    ColorPlane m_selected = ColorPlane::kFirst;  // what is in m_color
    // Null where the format has no such plane.
    Plane<std::byte> m_color;
    Plane<std::byte> m_other_color;  // null until it is asked for
    Plane<uint32_t> m_depth;
    Plane<uint8_t> m_stencil;
    Plane<uint8_t> m_color_alike, m_other_color_alike, m_depth_alike, m_stencil_alike;
    Plane<float> m_farthest;
    std::vector<BinState> m_states;
};

// The planes of a target, one of its colour buffers in its place, for the calling thread alone while it
// lives.
class TargetUse {
  public:
    TargetUse(Target& target, ColorPlane color) : m_lock(target.mutex()) { target.select_color(color); }

  private:
    std::lock_guard<std::mutex> m_lock;
};

}  // namespace terrazzo::raster
