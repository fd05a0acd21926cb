// Sheets: pictures of many cells at a time, reduced to one number a primitive. Child side; each library draws
// them in a process of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "corpus.h"

namespace terrazzo::coverage {

// What a primitive covers: how many pixels, and a sum over which ones.
struct Footprint {
    uint64_t sum;
    uint32_t pixels;
    uint32_t reserved;

    friend bool operator==(const Footprint&, const Footprint&) = default;
};

struct Place {
    int sheet;
    Rectangle viewport;
};

// Where the cell stands; sheets have cells of several sizes.
Place place_of(uint32_t cell);

// The footprints of all primitives of the cells [0, count).
std::vector<Footprint> draw_cells(const std::string& library, uint32_t seed, uint32_t count);

// The pixels of one cell, row by row from the bottom: bit i is set where primitive i covers.
std::vector<uint32_t> draw_cell(const std::string& library, uint32_t seed, uint32_t cell);

// Cells of vertices without a window position on every other square of a sheet.
struct StrayResult {
    uint32_t inside, outside;  // pixels drawn to within the cells' scissors and elsewhere
    uint64_t picture;          // a hash

    friend bool operator==(const StrayResult&, const StrayResult&) = default;
};
inline constexpr uint32_t kStraysOfSheet = 128;
std::vector<StrayResult> draw_strays(const std::string& library, uint32_t seed, uint32_t sheets);

}  // namespace terrazzo::coverage
