// Draws the arguments of one call: mostly what the registry says they may be, sometimes anything.
// Invariant: what is drawn depends on the random numbers alone, not on the state of a context.
#pragma once

#include <cstdint>
#include <vector>

#include "fuzz/random.h"
#include "fuzz/table.h"

namespace terrazzo::fuzz {

inline constexpr unsigned kNames = 12;      // objects of a kind have names from 1 to this, sometimes others
inline constexpr unsigned kPlainLists = 8;  // lists of greater names may call lists of any name

// Arguments that are not pointers; pointers stay null.
void draw_scalars(const Command& command, Random& random, Value* values);

std::uint32_t draw_enumerant(const EnumGroup& group, Random& random);
std::uint32_t draw_name(Random& random);
std::int64_t draw_integer(Random& random);
double draw_real(Random& random);
// A value that the parameter `pname` of a texture, a light, fog, ... may take, or any.
double draw_parameter_value(std::uint32_t pname, Random& random);

}  // namespace terrazzo::fuzz
