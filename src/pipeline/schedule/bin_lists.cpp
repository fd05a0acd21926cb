// Filling bin lists; see bin_lists.h.
#include "pipeline/schedule/bin_lists.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

namespace terrazzo::pipeline {

using raster::BinClear;
using raster::kBinSize;
using raster::Primitive;

namespace {

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

}  // namespace

BinLists::Grid BinLists::grid_of(int across, int down) {
    return {std::vector<List>(static_cast<size_t>(across) * static_cast<size_t>(down)), across};
}

void BinLists::take_grid_of(const BinLists& other) {
    if (bin_count() != other.bin_count()) m_grid.lists = std::vector<List>(other.m_grid.lists.size());
    m_grid.across = other.m_grid.across;
}

// For one more command.
void BinLists::make_room(int bin) {
    List& list = m_grid.lists[static_cast<size_t>(bin)];
    if (list.last != nullptr && list.last->count < std::size(list.last->commands)) return;
    Chunk* const chunk = new (m_arena.allocate(sizeof(Chunk))) Chunk;
    chunk->next = nullptr;
    chunk->count = 0;
    (list.last ? list.last->next : list.first) = chunk;
    list.last = chunk;
}

void BinLists::push(int bin, uintptr_t command) {
    make_room(bin);
    Chunk& chunk = *m_grid.lists[static_cast<size_t>(bin)].last;
    chunk.commands[chunk.count++] = command;
    ++m_commands;
}

// What was added since the mark lies behind it in the arena, and at the ends of the lists.
void BinLists::take_back(const Mark& mark) {
    const auto is_new = [&](uintptr_t address) {
        return m_arena.is_after(mark.arena, reinterpret_cast<const void*>(address));
    };
    for (List& list : m_grid.lists) {
        List kept;
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
    m_commands = mark.commands;
    m_primitives = mark.primitives;
}

void BinLists::forget_commands() {
    std::fill(m_grid.lists.begin(), m_grid.lists.end(), List{});
    m_commands = 0;
}

void BinLists::clear() {
    forget_commands();
    m_arena.reset();
    m_primitives = 0;
}

void BinLists::cut(Part& part) {
    part.m_runs.clear();
    for (int bin = 0; bin < bin_count(); ++bin) {
        const List& list = m_grid.lists[static_cast<size_t>(bin)];
        if (list.first) part.m_runs.push_back({bin, list.first, list.last});
    }
    for (const Part::Run& run : part.m_runs) m_grid.lists[static_cast<size_t>(run.bin)] = {};
    part.m_commands = std::exchange(m_commands, 0);
    part.m_primitives = std::exchange(m_primitives, 0);
}

void BinLists::append(const Part& part) {
    // The ends of the lists were written by other threads.
    for (const Part::Run& run : part.m_runs)
        __builtin_prefetch(m_grid.lists[static_cast<size_t>(run.bin)].last, 1);
    for (const Part::Run& run : part.m_runs) {
        List& list = m_grid.lists[static_cast<size_t>(run.bin)];
        (list.last ? list.last->next : list.first) = run.first;
        list.last = run.last;
    }
    m_commands += part.m_commands;
    m_primitives += part.m_primitives;
}

void BinLists::add(const Primitive& primitive) {
    ++m_primitives;
    const int first_column = primitive.x0 / kBinSize, last_column = (primitive.x1 - 1) / kBinSize;
    const int first_row = primitive.y0 / kBinSize, last_row = (primitive.y1 - 1) / kBinSize;
    const uintptr_t command = reinterpret_cast<uintptr_t>(&primitive);
    const bool test = last_column - first_column + last_row - first_row > 1;
    for (int row = first_row; row <= last_row; ++row) {
        for (int column = first_column; column <= last_column; ++column) {
            if (test && outside_bin(primitive, column * kBinSize, row * kBinSize)) continue;
            push(row * m_grid.across + column, command);
        }
    }
}

void BinLists::add(const BinClear& clear, const raster::Target* hides) {
    BinClear* const kept = new (m_arena.allocate(sizeof(BinClear))) BinClear(clear);
    const uintptr_t command = reinterpret_cast<uintptr_t>(kept) | kClearTag;
    const auto for_each_bin = [&](auto visit) {
        for (int row = clear.y0 / kBinSize; row <= (clear.y1 - 1) / kBinSize; ++row)
            for (int column = clear.x0 / kBinSize; column <= (clear.x1 - 1) / kBinSize; ++column)
                visit(column, row, row * m_grid.across + column);
    };
    for_each_bin([&](int, int, int bin) { make_room(bin); });
    for_each_bin([&](int column, int row, int bin) {
        List& list = m_grid.lists[static_cast<size_t>(bin)];
        if (hides && raster::clears_whole_bin(clear, *hides, column * kBinSize, row * kBinSize)) {
            // What was to be drawn here will not be seen.
            list.last = list.first;
            list.first->next = nullptr;
            list.first->count = 0;
        }
        push(bin, command);
    });
}

}  // namespace terrazzo::pipeline
