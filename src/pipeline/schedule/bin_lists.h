// Bin lists (sort-middle, [Frolov 2020 §2.2.2], row R-11): which primitives and clears touch each 64x64 bin
// of a target, in the order in which they came.
//
// Input: set-up primitives, which lie in the lists' arena, and clears. Output: one list of commands a bin.
// The lists are filled by one thread; then each may be read by a thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/schedule/arena.h"
#include "raster/primitive.h"
#include "raster/target/clear.h"
#include "raster/target/target.h"

namespace terrazzo::pipeline {

class BinLists {
    // Lists are chains of chunks of tagged pointers: bit 0 marks a clear.
    static constexpr uintptr_t kClearTag = 1;
    struct Chunk {
        Chunk* next;
        uint32_t count;
        uintptr_t commands[62];
    };
    static_assert(sizeof(Chunk) == 64 * sizeof(void*));
    struct List {
        Chunk* first = nullptr;
        Chunk* last = nullptr;
    };

  public:
    explicit BinLists(BlockStore& store) : m_arena(store) {}

    // The lists of a target of so many bins, row by row.
    struct Grid {
        std::vector<List> lists;
        int across = 0;
    };
    // Throws std::bad_alloc.
    static Grid grid_of(int across, int down);
    // The lists must be empty.
    void set_grid(Grid grid) { m_grid = std::move(grid); }
    // Empty lists for the same bins as the others'. Throws std::bad_alloc.
    void take_grid_of(const BinLists& other);

    int bin_count() const { return static_cast<int>(m_grid.lists.size()); }
    bool is_touched(int bin) const { return m_grid.lists[static_cast<size_t>(bin)].first != nullptr; }
    size_t command_count() const { return m_commands; }
    size_t primitive_count() const { return m_primitives; }
    // For the primitives, and what they point at.
    Arena& arena() { return m_arena; }
    const Arena& arena() const { return m_arena; }

    // Into the lists of all bins that the primitive's rectangle touches, less those an edge shuts out. Throws
    // std::bad_alloc, and may be in some of the lists then.
    void add(const raster::Primitive& primitive);
    // A clear of a rectangle of pixels, of at least one. Where it leaves nothing to be seen of what was in a
    // list, as `hides` says, the list begins with it. Throws std::bad_alloc and changes nothing then.
    void add(const raster::BinClear& clear, const raster::Target* hides);

    struct Mark {
        Arena::Mark arena;
        size_t commands, primitives;
    };
    Mark mark() const { return {m_arena.mark(), m_commands, m_primitives}; }
    // Forgets what was added since. A list that a clear has begun anew stays so.
    void take_back(const Mark& mark);
    // Forgets what is to be drawn; memory and the number of primitives stay.
    void forget_commands();
    // Forgets everything.
    void clear();

    // What was in all lists, bin by bin.
    class Part {
        friend class BinLists;
        struct Run {
            int bin;
            Chunk *first, *last;
        };
        std::vector<Run> m_runs;
        size_t m_commands = 0;
        size_t m_primitives = 0;
    };
    // Moves what is in the lists to `part`; the arena stays. Throws std::bad_alloc and leaves the lists then.
    void cut(Part& part);
    // Puts what another object's lists held to the ends of these.
    void append(const Part& part);

    // Calls `primitive` or `clear` for each command of a bin.
    template <typename VisitPrimitive, typename VisitClear>
    void for_each(int bin, VisitPrimitive primitive, VisitClear clear) const {
        for (const Chunk* chunk = m_grid.lists[static_cast<size_t>(bin)].first; chunk; chunk = chunk->next) {
            for (uint32_t i = 0; i < chunk->count; ++i) {
                const uintptr_t command = chunk->commands[i];
                if (i + kPrefetchAhead < chunk->count) prefetch(chunk->commands[i + kPrefetchAhead]);
                if (command & kClearTag) {
                    clear(*reinterpret_cast<const raster::BinClear*>(command & ~kClearTag));
                } else {
                    primitive(*reinterpret_cast<const raster::Primitive*>(command));
                }
            }
        }
    }

  private:
    // A bin's primitives lie all over the arena, which is larger than the caches.
    static constexpr uint32_t kPrefetchAhead = 4;
    static void prefetch(uintptr_t command) {
        const auto* const lines = reinterpret_cast<const std::byte*>(command);
        for (size_t offset = 0; offset < 192; offset += 64) __builtin_prefetch(lines + offset);
    }

    void make_room(int bin);
    void push(int bin, uintptr_t command);

    Arena m_arena;
    Grid m_grid;
    size_t m_commands = 0;
    size_t m_primitives = 0;
};

}  // namespace terrazzo::pipeline
