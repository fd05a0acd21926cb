// Rows of pixels between client memory and RGBA groups (GL 1.5 §3.6.4, §4.3.2).
//
// Two group types: four bytes, for client types whose components have at most 8 unsigned bits, and four
// floats for all others. Integers scale so that the largest is 1.0; signed ones c / (2^(n-1) - 1), as OSMesa
// and later versions of the specification have it. Nothing is clamped on the way in; on the way out integers
// saturate. Client rows need no alignment. Callers work in chunks of kPixelChunk pixels so that scratch rows
// stay in L1.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <bit>
#include <cstdint>

namespace terrazzo::gl {

inline constexpr int kPixelChunk = 256;

// Unsigned normalised integers between sizes of 1 to 16 bits: a wider one repeats the bits, a narrower one
// rounds to nearest. So the reference converts between integers, and so it samples formats below 8 bits.
constexpr unsigned resize_unorm(unsigned value, unsigned from_bits, unsigned to_bits) {
    if (to_bits <= from_bits) {
        const unsigned from = (1u << from_bits) - 1, to = (1u << to_bits) - 1;
        return (value * to + from / 2) / from;
    }
    unsigned repeated = value, bits = from_bits;
    for (; bits < to_bits; bits += from_bits) repeated = repeated << from_bits | value;
    return repeated >> (bits - to_bits);
}

// NaN becomes 0.
inline float clamp_to_unit(float value) {
    const float positive = value > 0.0f ? value : 0.0f;
    return positive < 1.0f ? positive : 1.0f;
}

// To the nearest integer, ties to even, for |value| < 2^22: a float of 1.5 * 2^23 and more has no fraction
// left. Unlike lrint this becomes vector code.
inline int round_to_int(float value) {
    return std::bit_cast<int>(value + 12582912.0f) - std::bit_cast<int>(12582912.0f);
}

// To an unsigned normalised integer of at most 16 bits, saturating.
inline unsigned unorm_from_float(float value, unsigned bits) {
    return static_cast<unsigned>(round_to_int(clamp_to_unit(value) * static_cast<float>((1u << bits) - 1)));
}

void bytes_from_floats(const float* values, int count, uint8_t* bytes);  // to 8 bits each

// Whether all components of this type are unsigned and have at most 8 bits: what `unpack_rgba8` can take.
bool has_8_bit_components(GLenum type);

// Client pixels to RGBA. Missing colour components become 0, missing alpha 1, luminance goes to R, G and B.
// `format` is a colour format; `unpack_rgba8` needs `has_8_bit_components(type)`.
void unpack_rgba8(GLenum format, GLenum type, bool swap_bytes, const void* source, int count, uint8_t* rgba);
void unpack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const void* source, int count,
                       float* rgba);

// Client indices. `first_bit` counts pixels from the first byte's first bit for GL_BITMAP.
void unpack_indices(GLenum type, bool swap_bytes, bool lsb_first, const void* source, int first_bit,
                    int count, uint32_t* indices);

// Client depths, one component of any unpacked type; signed integers stand for (2c + 1)/(2^b - 1) (GL 1.5
// table 2.9). What is less than 0 or more than 1 stays so.
void unpack_depths(GLenum type, bool swap_bytes, const void* source, int count, float* depths);

// Client pixels of GL_UNSIGNED_INT_24_8: depths as integers of 24 bits, and stencil indices.
void unpack_depths_and_stencils(bool swap_bytes, const void* source, int count, uint32_t* depths,
                                uint32_t* stencils);

// RGBA to client pixels; luminance takes R.
void pack_rgba8(GLenum format, GLenum type, bool swap_bytes, const uint8_t* rgba, int count,
                void* destination);
void pack_rgba_float(GLenum format, GLenum type, bool swap_bytes, const float* rgba, int count,
                     void* destination);

// Indices to client memory, masked to the type's positive range (GL 1.5 table 4.6).
void pack_indices(GLenum type, bool swap_bytes, bool lsb_first, const uint32_t* indices, int count,
                  void* destination, int first_bit);

// Depths as integers of 24 bits, and the lowest 8 bits of stencil indices, to GL_UNSIGNED_INT_24_8.
void pack_depths_and_stencils(bool swap_bytes, const uint32_t* depths, const uint32_t* stencils, int count,
                              void* destination);

// Depths in 0..1 to client memory, as one component of any unpacked type.
void pack_depths(GLenum type, bool swap_bytes, const float* depths, int count, void* destination);

}  // namespace terrazzo::gl
