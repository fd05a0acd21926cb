// Stage: piglit-lite, a drawing's colour buffer as a picture, and what of it is background.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include "compare.h"

namespace terrazzo::piglit {

// RGBA (or RGB) whatever the scene's OSMesa format and type; rows from the top.
OIIO::ImageBuf colour_picture(const Scene& scene, const Drawing& drawing);

// Depth spread over what the picture contains, near = bright; stencil as a map of distinct tones.
OIIO::ImageBuf depth_picture(const Scene& scene, const Drawing& drawing);
OIIO::ImageBuf stencil_picture(const Scene& scene, const Drawing& drawing);

// Pixels that are background in one picture and drawn, by more than `threshold`, in the other.
std::size_t coverage_difference(const Scene& scene, const OIIO::ImageBuf& a, const OIIO::ImageBuf& b,
                                float threshold);

}  // namespace terrazzo::piglit
