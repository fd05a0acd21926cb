// Pixel transfer operations (GL 1.5 §3.6.5): what happens to groups between client memory, textures and frame
// buffer.
#pragma once

#include <cstdint>

#include "gl/pixels.h"

namespace terrazzo::gl {

// Whether scale, bias or the colour maps change anything; when not, rows may take the 8-bit path.
bool changes_colors(const PixelState& state);
bool changes_depths(const PixelState& state);
bool changes_stencils(const PixelState& state);

// Scale, bias and the RGBA to RGBA maps, in this order. Values are not clamped but by the maps.
void transfer_colors(const PixelState& state, float* rgba, int count);

// Shift, offset and the maps from indices to RGBA.
void transfer_indices_to_colors(const PixelState& state, const uint32_t* indices, int count, float* rgba);

// Shift, offset and the stencil map.
void transfer_stencils(const PixelState& state, uint32_t* indices, int count);

// Scale and bias, clamped to 0..1.
void transfer_depths(const PixelState& state, float* depths, int count);

// Integers of 24 bits become those of `bits` bits; through floats where there is a scale or a bias.
void transfer_packed_depths(const PixelState& state, uint32_t* depths, int count, int bits);

}  // namespace terrazzo::gl
