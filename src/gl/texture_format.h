// Internal formats of textures (GL 1.5 §3.8.1 tables 3.15, 3.16): from what the program asked for to what is
// stored.
//
// Sizes follow OSMesa's choices, which programs can query and which decide how texels are quantised: RGB5
// keeps 5-5-5, RGBA2 and RGBA4 keep 4 bits each, every 12-bit format keeps 16.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>

#include "raster/target/texture_image.h"

namespace terrazzo::gl {

struct TexelFormat {
    // GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA or GL_DEPTH_COMPONENT
    GLenum base;
    raster::BaseFormat base_format;
    raster::TexelStorage storage;
    // Bits kept of each component: R, G, B, A. Luminance and intensity are counted in R (and in G and B
    // alike), depth in R.
    std::array<unsigned char, 4> bits;
};

// The format kept for `internal_format`; null when it is no internal format of textures. The client's pixels
// choose the size where `internal_format` names none, as OSMesa has it: its rules leave out most types when
// bytes are swapped.
const TexelFormat* choose_texel_format(GLint internal_format, GLenum client_format, GLenum client_type,
                                       bool swap_bytes);

// An RGBA colour as a texture of a base format would hold it and sampling sees it (GL 1.5 §3.8.8,
// table 3.15); the depth of a depth texture is R.
std::array<GLfloat, 4> as_texel(raster::BaseFormat base, const std::array<GLfloat, 4>& rgba);

// Whether textures of an internal format have stencil values beside their depths (EXT_packed_depth_stencil).
constexpr bool has_stencil(GLint internal_format) {
    return internal_format == GL_DEPTH_STENCIL || internal_format == GL_DEPTH24_STENCIL8;
}

}  // namespace terrazzo::gl
