// Bin lists of a frame, and what drawing one bin means.
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
using raster::kBinSize;
using raster::Primitive;

namespace {

constexpr uintptr_t kClearTag = 1;

// Whether some edge has the whole bin outside: its value at the bin's most favourable pixel is negative.
bool outside_bin(const Primitive& primitive, int bin_x, int bin_y) {
    const bool multisample = primitive.state->multisample;
    // Samples lie up to a pixel from the corner that they are counted from; a step more is for rounding.
    const int last = multisample ? kBinSize : kBinSize - 1;
    for (int e = 0; e < primitive.edge_count; ++e) {
        const raster::Edge& edge = primitive.edges[e];
        const int64_t x = bin_x + (edge.step_x > 0 ? last : 0);
        const int64_t y = bin_y + (edge.step_y > 0 ? last : 0);
        const int64_t c = multisample ? (edge.c >> 8) + 1 : edge.c;
        if (c + edge.step_x * x + edge.step_y * y < 0) return true;
    }
    return false;
}

// A bin's primitives lie all over the frame's memory, which is larger than the caches.
constexpr uint32_t kPrefetchAhead = 4;
void prefetch(uintptr_t command) {
    const auto* const lines = reinterpret_cast<const std::byte*>(command);
    for (size_t offset = 0; offset < 192; offset += 64) __builtin_prefetch(lines + offset);
}

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
    const size_t count = target ? static_cast<size_t>(target->bin_count()) : 0;
    std::vector<BinList> bins(count);
    std::vector<int> touched;
    touched.reserve(count);
    if (target && m_batches.empty()) m_batches = new_batches();
    std::vector<std::atomic<int>> unfinished(target ? count / static_cast<size_t>(target->bins_across()) : 0);
    draw();
    m_target = std::move(target);
    m_colors = colors;
    m_bins = std::move(bins);
    m_touched = std::move(touched);
    m_unfinished = std::move(unfinished);
}

// For one more command.
void Frame::make_room(int bin) {
    BinList& list = m_bins[static_cast<size_t>(bin)];
    if (list.last != nullptr && list.last->count < std::size(list.last->commands)) return;
    Chunk* const chunk = new (m_arena.allocate(sizeof(Chunk))) Chunk;
    chunk->next = nullptr;
    chunk->count = 0;
    (list.last ? list.last->next : list.first) = chunk;
    list.last = chunk;
}

void Frame::push(int bin, uintptr_t command) {
    make_room(bin);
    Chunk& chunk = *m_bins[static_cast<size_t>(bin)].last;
    chunk.commands[chunk.count++] = command;
    ++m_commands;
}

// What was queued since the mark lies behind it in the arena, and at the ends of the lists.
void Frame::take_back(const Mark& mark) {
    if (!still_holds(mark)) return reset();
    const auto is_new = [&](uintptr_t address) {
        return m_arena.is_after(mark.arena, reinterpret_cast<const void*>(address));
    };
    for (BinList& list : m_bins) {
        BinList kept;
        for (Chunk* chunk = list.first; chunk && !is_new(reinterpret_cast<uintptr_t>(chunk));
             chunk = chunk->next) {
            if (!kept.first) kept.first = chunk;
            kept.last = chunk;
        }
        if (kept.last) {
            Chunk& last = *kept.last;
            last.next = nullptr;
            while (last.count > 0 && is_new(last.commands[last.count - 1] & ~kClearTag)) --last.count;
        }
        list = kept;
    }
    m_arena.rewind(mark.arena);
    m_kept.resize(mark.kept);
    m_kept_bytes = mark.kept_bytes;
    m_sample_counters.resize(mark.counters);
    m_commands = mark.commands;
    m_primitives = mark.primitives;
}

void Frame::add(const Primitive& primitive) {
    ++m_primitives;
    const int across = m_target->bins_across();
    const int first_column = primitive.x0 / kBinSize, last_column = (primitive.x1 - 1) / kBinSize;
    const int first_row = primitive.y0 / kBinSize, last_row = (primitive.y1 - 1) / kBinSize;
    const uintptr_t command = reinterpret_cast<uintptr_t>(&primitive);
    const bool test = last_column - first_column + last_row - first_row > 1;
    for (int row = first_row; row <= last_row; ++row) {
        for (int column = first_column; column <= last_column; ++column) {
            if (test && outside_bin(primitive, column * kBinSize, row * kBinSize)) continue;
            push(row * across + column, command);
        }
    }
}

void Frame::add(const BinClear& clear) {
    if (clear.x0 >= clear.x1 || clear.y0 >= clear.y1) return;
    BinClear* const kept = new (m_arena.allocate(sizeof(BinClear))) BinClear(clear);
    const uintptr_t command = reinterpret_cast<uintptr_t>(kept) | kClearTag;
    const raster::TargetFormat& format = m_target->format();
    const bool everything = clear.planes.color && (clear.planes.depth || format.depth_bits == 0) &&
                            (clear.planes.stencil || format.stencil_bits == 0);
    const int across = m_target->bins_across();
    const auto for_each_bin = [&](auto visit) {
        for (int row = clear.y0 / kBinSize; row <= (clear.y1 - 1) / kBinSize; ++row)
            for (int column = clear.x0 / kBinSize; column <= (clear.x1 - 1) / kBinSize; ++column)
                visit(column, row, row * across + column);
    };
    for_each_bin([&](int, int, int bin) { make_room(bin); });
    for_each_bin([&](int column, int row, int bin) {
        BinList& list = m_bins[static_cast<size_t>(bin)];
        if (everything && m_sample_counters.empty() &&
            raster::clears_whole_bin(clear, *m_target, column * kBinSize, row * kBinSize)) {
            // What was to be drawn here will not be seen.
            list.last = list.first;
            list.first->next = nullptr;
            list.first->count = 0;
        }
        push(bin, command);
    });
}

void Frame::draw_bin(int index, int thread) const {
    const FloatEnvironment environment;
    const BinList& list = m_bins[static_cast<size_t>(index)];
    raster::Bin bin = m_target->bin(index);
    raster::Batch& batch = *m_batches[static_cast<size_t>(thread)];
    const raster::KernelTable& kernels = raster::kernels();
    const auto draw = m_target->format().samples == 1 ? kernels.draw_primitive : kernels.draw_multisampled;
    for (const Chunk* chunk = list.first; chunk != nullptr; chunk = chunk->next) {
        for (uint32_t i = 0; i < chunk->count; ++i) {
            const uintptr_t command = chunk->commands[i];
            if (i + kPrefetchAhead < chunk->count) prefetch(chunk->commands[i + kPrefetchAhead]);
            if (command & kClearTag) {
                kernels.flush(bin, batch);
                raster::clear_bin(*reinterpret_cast<const BinClear*>(command & ~kClearTag), *m_target, index);
            } else {
                const Primitive& primitive = *reinterpret_cast<const Primitive*>(command);
                const raster::FragmentKey& key = primitive.state->key;
                m_target->materialize(index, {true, key.depth_test, key.stencil_test},
                                      {key.color_mask != 0, key.depth_write, key.stencil_test});
                draw(primitive, bin, batch);
            }
        }
    }
    kernels.flush(bin, batch);
    if (bin.samples_passed) m_samples_passed.fetch_add(bin.samples_passed, std::memory_order_relaxed);
}

void Frame::draw_bins() {
    m_touched.clear();
    for (size_t i = 0; i < m_bins.size(); ++i)
        if (m_bins[i].first != nullptr) m_touched.push_back(static_cast<int>(i));
    // A handful of commands is drawn sooner than a thread wakes up.
    constexpr size_t kFewCommands = 32;
    if (m_commands <= kFewCommands) {
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
    for (uint64_t* const counter : m_sample_counters) counters.emplace_back(counter, *counter);
    m_target->select_color(raster::ColorPlane::kSecond);
    draw_bins();
    m_target->select_color(raster::ColorPlane::kFirst);
    for (const auto& [counter, count] : counters) *counter = count;
    m_samples_passed = 0;
    m_target->restore_depths(before);
}

void Frame::draw() {
    const StageTimer timer(statistics.pixel_nanoseconds);
    if (m_commands != 0) {
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
        if (m_commands != 0 && m_colors == DrawnColors::kBoth) draw_second_color();
        const int across = m_target->bins_across();
        for (std::atomic<int>& count : m_unfinished) count.store(across, std::memory_order_relaxed);
        run_parallel(static_cast<int>(m_bins.size()), [&](int bin, int thread) {
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
    std::fill(m_bins.begin(), m_bins.end(), BinList{});
    m_kept.clear();
    m_kept_bytes = 0;
    m_sample_counters.clear();
    m_arena.reset();
    if (statistics.enabled) {
        statistics.primitives += m_primitives;
        statistics.pixels += m_samples_passed;
    }
    m_primitives = 0;
    m_samples_passed = 0;
    m_commands = 0;
    ++m_frame;
}

}  // namespace terrazzo::pipeline
