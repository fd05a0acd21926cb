// Random GL commands from a seed: state of every kind, then draws of every kind, again and again.
//
// Input: a function table with a current context of the given size. Output: a picture in that context.
// Invariant: the same seed gives the same commands on every machine, so a seed that fails is all there is to
// report. Only commands of OpenGL 1.1 that Terrazzo implements are used, and only with arguments that the
// specification allows.
#pragma once

#include <cstdint>

#include "gl_table.h"

namespace terrazzo::stress {

void draw_random(const kit::Gl& gl, std::uint64_t seed, int width, int height);

}  // namespace terrazzo::stress
