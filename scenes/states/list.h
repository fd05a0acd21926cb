// Stage: client side, which states `terrazzo bench states` draws.
// Input: the table of axes. Output: the named list and seeded random states. Invariant: names are unique, no
// state is there twice, and the same seed gives the same states everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "state.h"

namespace terrazzo::states {

// From a few base states one axis changed at a time ("textured/filter=nearest"), and what programs put
// together
// ("program/shadow-map"); each over every geometry ("textured/filter=nearest/large"), a geometry's states
// together.
std::vector<NamedState> named_states();
// The same without a geometry in the name or the state.
std::vector<NamedState> named_states_of_one_geometry();

// "random/SEED-0/GEOMETRY" ...; geometries take turns.
std::vector<NamedState> random_states(int count, std::uint64_t seed);

}  // namespace terrazzo::states
