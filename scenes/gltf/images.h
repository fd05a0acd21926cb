// Stage: models from files, images. Input: a PNG or JPEG file's bytes. Output: RGBA as the file has it,
// colours not multiplied by alpha, and its smaller levels. Invariant: no image is decoded that says it has
// more pixels than the budget holds.
#pragma once

#include <span>
#include <vector>

#include "container.h"
#include "model.h"

namespace terrazzo::gltf {

Level decode_image(std::span<const unsigned char> bytes, Budget& pixels);  // throws std::runtime_error

// Half as wide and high, rounded down, to 1x1: each the mean of what it covers of the one before, weighted by
// area, colours by alpha too. A level of alpha 255 throughout stays so.
void add_smaller_levels(std::vector<Level>& levels);

// Levels as wide and high as no library refuses, reduced from a larger one.
Level reduced_to(Level level, int largest);

}  // namespace terrazzo::gltf
