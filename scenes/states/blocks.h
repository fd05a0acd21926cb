// Stage: client side, S3TC blocks of our textures. A plain encoder: the darkest and the lightest texel are a
// block's end points. The same blocks go to every library.
#pragma once

#include <cstdint>
#include <vector>

namespace terrazzo::states {

// RGBA8 -> DXT1 (opaque), or DXT5. Sizes that are no multiples of four are filled up with their last texels.
std::vector<std::uint8_t> encode_blocks(const std::vector<std::uint8_t>& rgba, int width, int height,
                                        bool with_alpha);

}  // namespace terrazzo::states
