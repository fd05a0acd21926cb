// What comparisons of pixels with the reference share: both libraries driven with the same calls, random
// pixel store and pixel transfer modes, all pairs of format and type, and the comparison of what they
// returned.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "gl/context.h"
#include "osmesa.h"

namespace terrazzo::test {

using Bytes = std::vector<unsigned char>;

struct ClientPixel {
    GLenum format, type;
};

std::ostream& operator<<(std::ostream& out, ClientPixel pixel);

// All pairs that the specification allows, of colours and indices, with and without GL_COLOR_INDEX and
// GL_BITMAP.
std::vector<ClientPixel> legal_pixels();

// Bits of the largest component of a type.
int component_bits(GLenum type);

inline bool is_32_bits(GLenum type) {
    return type == GL_UNSIGNED_INT || type == GL_INT;
}

class BothLibraries {
  public:
    BothLibraries(const Osmesa& reference, unsigned seed);

    unsigned pick(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random); }
    ClientPixel pick(const std::vector<ClientPixel>& pixels) {
        return pixels[pick(static_cast<unsigned>(pixels.size()))];
    }
    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }

    // The values of GL_(UN)PACK_SWAP_BYTES, LSB_FIRST, ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS and ALIGNMENT,
    // whose enumerants follow one another in this order.
    using Modes = std::array<GLint, 6>;
    Modes random_modes();
    void set_modes(GLenum first, const Modes& modes);

    void random_transfer();

    void expect_same_errors();

    // Compares what was read into rows of `width` pixels under the pack modes. With a `step` of 0 every byte
    // must be the same; otherwise components may differ by that much, and bytes between the pixels may not.
    void expect_same_pixels(ClientPixel client, int width, int height, Bytes ours, Bytes theirs, float step);

    const Osmesa& gl;
    std::unique_ptr<terrazzo::gl::Context> context;
    std::mt19937 random;
    bool clamp_theirs = false;  // to 0..1, where components are compared as numbers
    std::ostringstream log;     // the calls so far, for the message of a failure
};

}  // namespace terrazzo::test
