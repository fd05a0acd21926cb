// The pixel formats of OSMesa: which render target each needs and how a pixel lies in the caller's buffer.
#pragma once

#include <GL/gl.h>

#include <optional>

#include "raster/target/copy_out.h"

namespace terrazzo::osmesa {

// Format of a context (OSMESA_RGBA ...), whether or not there is a type it can be drawn with.
bool is_format(int format);

// The pixels of a buffer for `format` and `type` of OSMesaMakeCurrent; empty when OSMesa does not support the
// pair.
std::optional<raster::PixelLayout> pixel_layout(int format, GLenum type);

}  // namespace terrazzo::osmesa
