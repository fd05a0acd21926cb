// TERRAZZO_DEBUG=stages: which stages fragments go through (raster/stages) or which kernel they get, by name.
//
// Input: the names that an instruction set gives its choices, and what is drawn with them. Output: lines on
// standard error, one for each different way when fragments first take it, and in the end of the process all
// of them with their tiles and fragments. Invariant: where nobody asks, no state has a count, and drawing
// costs nothing more. This header is included where code is compiled once per instruction set: it has no
// code.
#pragma once

#include <cstdint>

#include "raster/fragment_state.h"

namespace terrazzo::raster {

// One choice. Slow: it reads the state as it runs, a tile at a time, for whatever no stage was made for.
struct StageName {
    const char* part;  // "test", "coordinates", "texels", "colour", "output", "kernel"
    int unit;          // of textures; -1 where there is none
    const char* name;
    bool is_slow;
};

// Those of a fragment state, in their order.
struct StageNames {
    StageName of[4 + 2 * kMaxTextureUnits];
    int count;
};

// Whether anybody asks.
bool logs_stages();

// The count of all states that take these stages. Null where there is no memory for it. Threads: any.
StageCount* count_of_stages(const StageNames& names) noexcept;

// Fragments as coverage finds them, before any test. Threads: any.
void count_drawn(StageCount& count, uint64_t tiles, uint64_t fragments);

}  // namespace terrazzo::raster
