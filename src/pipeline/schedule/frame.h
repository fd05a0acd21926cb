// A frame: the draws and clears that wait for their pixels, sorted into bins (bin_lists.h).
//
// Set-up primitives and bin lists live in the frame's arena; states and images that they refer to are kept
// alive by `keep`. A frame is filled by one thread, which others may hand parts of lists to (bin_lists.h),
// then drawn bin by bin, each bin by one thread, in the order of its list. Frames of several threads may have
// one target: they are drawn one after the other.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/schedule/bin_lists.h"
#include "pipeline/schedule/kept.h"
#include "raster/kernel_table.h"
#include "raster/target/clear.h"
#include "raster/target/target.h"
#include "raster/target/texture_image.h"

namespace terrazzo::pipeline {

// The colour buffers of the target that a frame draws to. Of both the depth test sees one history.
enum class DrawnColors : uint8_t { kFirst, kSecond, kBoth };

// The one that a frame leaves in its place.
constexpr raster::ColorPlane shown_color(DrawnColors colors) {
    return colors == DrawnColors::kSecond ? raster::ColorPlane::kSecond : raster::ColorPlane::kFirst;
}

class Frame {
  public:
    Frame();
    ~Frame();

    // What a frame may hold before it has to be drawn: primitives and states, and as much again in images
    // that their textures have given up. All together stays far below 256 MB.
    static constexpr size_t kMaxBytes = 64u << 20;

    // Draws what is queued, then begins anew on these colour buffers of `target`, which has them. Throws
    // std::bad_alloc and changes nothing then.
    void begin(std::shared_ptr<raster::Target> target, DrawnColors colors);
    const std::shared_ptr<raster::Target>& target() const { return m_target; }
    DrawnColors colors() const { return m_colors; }

    bool empty() const { return m_lists.command_count() == 0 && !m_background; }
    // Threads that fill lists for the frame may ask, too.
    bool full() const {
        return m_blocks.used_bytes() + m_kept.bytes() >= kMaxBytes ||
               raster::TextureImage::abandoned_bytes() >= kMaxBytes;
    }
    // Where primitives go.
    BinLists& lists() { return m_lists; }
    // What lists of other threads take their memory from.
    BlockStore& blocks() { return m_blocks; }

    // What is queued at the moment, for taking back what is queued after it.
    struct Mark {
        BinLists::Mark lists;
        Kept::Mark kept;
        uint64_t frame;
    };
    Mark mark() const { return {m_lists.mark(), m_kept.mark(), m_frame}; }
    // Whether nothing has been drawn since the mark was taken.
    bool still_holds(const Mark& mark) const { return mark.frame == m_frame; }
    // Forgets what was queued since. Of a frame that has been drawn meanwhile everything: it was queued
    // later. A clear that had become part of the frame stays.
    void take_back(const Mark& mark);

    // Keeps a fragment state alive until the frame has been drawn.
    void keep(std::shared_ptr<const FragmentBlock> block) { m_kept.keep(std::move(block)); }
    // The same for other memory.
    void keep(std::shared_ptr<const void> memory, size_t bytes) { m_kept.keep(std::move(memory), bytes); }

    // A clear of a rectangle of pixels through masks. Throws std::bad_alloc and changes nothing then. Of what
    // is cleared before anything else is queued nothing is written into the bins' lists, however many there
    // are.
    void add(const raster::BinClear& clear);

    // Draws everything queued, on all threads, and forgets it; other frames that draw to the target wait.
    // Needs no memory, but for drawing to both colour buffers: throws std::bad_alloc then, before anything
    // is drawn.
    void draw();
    // What is handed over at a time: a bin, or a whole row of them.
    enum class Group : uint8_t { kBin, kRow };
    // The same, and hands each bin, or row of bins, of the target over to `finished` as soon as its pixels
    // are done, while they are still in the cache of a thread that drew them: those of the colour buffer
    // drawn to, the first of both. `finished` may run on several threads at a time and must not throw.
    void draw(Group group, const std::function<void(int first, int count)>& finished);

  private:
    bool hides_what_is_queued(const raster::BinClear& clear) const;
    bool joins_background(const raster::BinClear& clear);
    void clear_background();
    // `thread`: of those that draw, from 0.
    void draw_bin(int index, int thread) const;
    void draw_bins();
    void draw_second_color();
    void reset();

    std::shared_ptr<raster::Target> m_target;
    BlockStore m_blocks;
    BinLists m_lists{m_blocks};
    Kept m_kept;
    std::vector<int> m_touched;                  // bins with something to draw; has room for all
    std::vector<std::atomic<int>> m_unfinished;  // bins of each row, while they are drawn to be handed over
    std::vector<std::unique_ptr<raster::Batch>> m_batches;  // one a thread
    std::optional<raster::BinClear> m_background;           // of the whole target, before all lists
    uint64_t m_frame = 0;                                   // how many were drawn before
    DrawnColors m_colors = DrawnColors::kFirst;
    mutable std::atomic<uint64_t> m_samples_passed =
        0;  // of all primitives that count samples, in drawn bins
};

}  // namespace terrazzo::pipeline
