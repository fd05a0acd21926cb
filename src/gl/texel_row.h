// Rows between RGBA groups and stored texels (GL 1.5 §3.8.1 table 3.15, §6.1.4 table 6.1).
//
// Storing keeps the channels of the base format, quantises them to the format's sizes and spreads them over
// R, G, B, A as sampling sees them. Loading gives back what GetTexImage returns: luminance and intensity in R
// only.
#pragma once

#include <cstdint>

#include "gl/pixels.h"
#include "gl/texture_format.h"
#include "raster/target/texture_image.h"

namespace terrazzo::gl {

// Whether pixels of this format and type, as R, G, B, A bytes, are texels already: nothing is left to be
// spread or quantised.
bool stores_groups(const TexelFormat& texel, GLenum format, GLenum type);

// Whether components of this type have just the values that a texture of this format can hold.
bool holds_all_values(const TexelFormat& texel, GLenum type);

// How components reach sizes below 8 bits. The ways differ near the middle between two values, and programs
// see which one the reference took.
enum class Rounding {
    kThroughBytes,  // to the nearest byte, from there to the nearest: most uploads
    kOnce,          // floats straight to the nearest: uploads of RGBA floats, and whatever went through pixel
                    // transfer
    kNone,          // floats that the format holds as they are
    kAsDrawn,       // bytes as if they were drawn, which drops bits: copies
};

// Writes `count` texels from (x, y, z) on, coordinates as in TextureImage. `count` is at most kPixelChunk.
void store_texels(const TexelFormat& format, const uint8_t* rgba, Rounding rounding, int count,
                  raster::TextureImage& image, int x, int y, int z);
void store_texels(const TexelFormat& format, const float* rgba, Rounding rounding, int count,
                  raster::TextureImage& image, int x, int y, int z);

// The 8-bit form needs 8-bit storage; sizes below 8 bits are widened by repeating bits. The float form is
// exact.
void load_texels(const TexelFormat& format, const raster::TextureImage& image, int x, int y, int z, int count,
                 uint8_t* rgba);
void load_texels(const TexelFormat& format, const raster::TextureImage& image, int x, int y, int z, int count,
                 float* rgba);

// Depths of a client's row, through pixel transfer, as integers of `bits` bits.
void store_depths(const PixelState& state, GLenum type, int bits, const uint8_t* source, int count,
                  uint32_t* depths);

// A depth as an integer of `bits` bits, what is behind the point cut off.
uint32_t depth_integer(float depth, int bits);

// A depth in another number of bits, which is no more than twice as many: bits are cut off or repeated.
uint32_t resize_depth(uint32_t value, unsigned from, unsigned to);

}  // namespace terrazzo::gl
