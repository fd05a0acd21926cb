// Frames, and what drawing one bin means.
#include "pipeline/schedule/frame.h"

#include <algorithm>
#include <new>
#include <utility>

#include "pipeline/schedule/float_environment.h"
#include "pipeline/schedule/statistics.h"
#include "pipeline/schedule/workers.h"
#include "raster/batch.h"

namespace terrazzo::pipeline {

using raster::BinClear;
using raster::Primitive;

namespace {

// One for each thread that may draw. They serve every target.
std::vector<std::unique_ptr<raster::Batch>> new_batches() {
    std::vector<std::unique_ptr<raster::Batch>> batches(static_cast<size_t>(thread_count()));
    for (auto& batch : batches) batch = std::make_unique_for_overwrite<raster::Batch>();
    return batches;
}

}  // namespace

Frame::Frame() = default;
Frame::~Frame() = default;

void Frame::begin(std::shared_ptr<raster::Target> target, DrawnColors colors) {
    if (target == m_target) {
        draw();
        m_colors = colors;
        return;
    }
    const int across = target ? target->bins_across() : 0;
    const int down = target ? target->bin_count() / across : 0;
    BinLists::Grid grid = BinLists::grid_of(across, down);
    std::vector<int> touched;
    touched.reserve(grid.lists.size());
    if (target && m_batches.empty()) m_batches = new_batches();
    std::vector<std::atomic<int>> unfinished(static_cast<size_t>(down));
    draw();
    m_target = std::move(target);
    m_colors = colors;
    m_lists.set_grid(std::move(grid));
    m_touched = std::move(touched);
    m_unfinished = std::move(unfinished);
}

void Frame::take_back(const Mark& mark) {
    if (!still_holds(mark)) return reset();
    m_lists.take_back(mark.lists);
    m_kept.take_back(mark.kept);
}

// Whether nothing of what is queued will be seen, where the clear covers it. Occlusion queries count what is
// not seen, too.
bool Frame::hides_what_is_queued(const BinClear& clear) const {
    const raster::TargetFormat& format = m_target->format();
    return clear.planes.color && (clear.planes.depth || format.depth_bits == 0) &&
           (clear.planes.stencil || format.stencil_bits == 0) && m_kept.sample_counters().empty();
}

// Whether the clear can be done for all bins before their lists: planes that it does not touch stay as an
// earlier one left them.
bool Frame::joins_background(const BinClear& clear) {
    if (!raster::clears_whole_target(clear, *m_target)) return false;
    if (m_lists.command_count() != 0) {
        if (!hides_what_is_queued(clear)) return false;
        m_lists.forget_commands();
    }
    if (!m_background) m_background = BinClear{};
    raster::join(clear, *m_background);
    return true;
}

// A bin whose list is empty is not looked at again.
void Frame::clear_background() {
    if (!m_background) return;
    for (int bin = 0; bin < m_target->bin_count(); ++bin)
        m_target->clear_bin(bin, m_background->planes, m_background->values);
}

void Frame::add(const BinClear& clear) {
    if (clear.x0 >= clear.x1 || clear.y0 >= clear.y1 || joins_background(clear)) return;
    m_lists.add(clear, hides_what_is_queued(clear) ? m_target.get() : nullptr);
}

void Frame::draw_bin(int index, int thread) const {
    const FloatEnvironment environment;
    raster::Bin bin = m_target->bin(index);
    raster::Batch& batch = *m_batches[static_cast<size_t>(thread)];
    const raster::KernelTable& kernels = raster::kernels();
    const auto draw = m_target->format().samples == 1 ? kernels.draw_primitive : kernels.draw_multisampled;
    const raster::FragmentState* prepared_for = nullptr;  // what the bin's planes are filled for
    m_lists.for_each(
        index,
        [&](const Primitive& primitive) {
            if (primitive.state != prepared_for) {
                prepared_for = primitive.state;
                const raster::FragmentKey& key = prepared_for->key;
                m_target->materialize(index, {true, key.depth_test, key.stencil_test},
                                      {key.color_mask != 0, key.depth_write, key.stencil_test});
            }
            draw(primitive, bin, batch);
        },
        [&](const BinClear& clear) {
            kernels.flush(bin, batch);
            prepared_for = nullptr;
            raster::clear_bin(clear, *m_target, index);
        });
    kernels.flush(bin, batch);
    if (bin.samples_passed) m_samples_passed.fetch_add(bin.samples_passed, std::memory_order_relaxed);
}

void Frame::draw_bins() {
    clear_background();
    m_touched.clear();
    for (int bin = 0; bin < m_lists.bin_count(); ++bin)
        if (m_lists.is_touched(bin)) m_touched.push_back(bin);
    // A handful of commands is drawn sooner than a thread wakes up.
    constexpr size_t kFewCommands = 32;
    if (m_lists.command_count() <= kFewCommands) {
        for (const int bin : m_touched) draw_bin(bin, 0);
    } else {
        run_parallel(static_cast<int>(m_touched.size()),
                     [this](int i, int thread) { draw_bin(m_touched[static_cast<size_t>(i)], thread); });
    }
}

// A fragment passes the tests or not whatever buffer its colour goes to: the first time is for the second
// buffer, then depth and stencil go back to where they were. Samples count once. Rare enough to be slow.
void Frame::draw_second_color() {
    const raster::Target::Depths before = m_target->save_depths();
    std::vector<std::pair<uint64_t*, uint64_t>> counters;
    for (uint64_t* const counter : m_kept.sample_counters()) counters.emplace_back(counter, *counter);
    m_target->select_color(raster::ColorPlane::kSecond);
    draw_bins();
    m_target->select_color(raster::ColorPlane::kFirst);
    for (const auto& [counter, count] : counters) *counter = count;
    m_samples_passed = 0;
    m_target->restore_depths(before);
}

void Frame::draw() {
    const StageTimer timer(statistics.pixel_nanoseconds);
    if (!empty()) {
        const raster::TargetUse use(*m_target, shown_color(m_colors));
        if (m_colors == DrawnColors::kBoth) draw_second_color();
        draw_bins();
    }
    reset();
}

void Frame::draw(Group group, const std::function<void(int, int)>& finished) {
    const StageTimer timer(statistics.pixel_nanoseconds);
    {
        const raster::TargetUse use(*m_target, shown_color(m_colors));
        if (!empty() && m_colors == DrawnColors::kBoth) draw_second_color();
        clear_background();
        const int across = m_target->bins_across();
        for (std::atomic<int>& count : m_unfinished) count.store(across, std::memory_order_relaxed);
        run_parallel(m_lists.bin_count(), [&](int bin, int thread) {
            draw_bin(bin, thread);
            if (group == Group::kBin) return finished(bin, 1);
            const int row = bin / across;
            if (m_unfinished[static_cast<size_t>(row)].fetch_sub(1, std::memory_order_acq_rel) == 1)
                finished(row * across, across);
        });
    }
    reset();
}

void Frame::reset() {
    m_background.reset();
    if (statistics.enabled) {
        statistics.primitives += m_lists.primitive_count();
        statistics.pixels += m_samples_passed;
    }
    m_lists.clear();
    m_blocks.reset();
    m_kept.clear();
    m_samples_passed = 0;
    ++m_frame;
}

}  // namespace terrazzo::pipeline
