// Pictures of random primitives under random rasterization state: polygon modes, culling, offset, stipples,
// smoothing, widths, shade models, two-sided lighting, user planes. Child side.
//
// A picture has one state, and both sides of its polygons one mode: the reference's state is stale after some
// changes, and it mixes modes up (doc/reference.md §3.3, defects).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace terrazzo::coverage {

inline constexpr int kStyleSize = 160;  // pixels each way

struct StylePicture {
    std::vector<uint8_t> colors;  // RGBA
    std::vector<uint8_t> counts;  // fragments of each pixel that were drawn, modulo 256
    std::vector<uint32_t> depths;
};

// A number of pictures from the one of that number on.
// `strays`: textured, and with any numbers in place of some of the vertices'.
std::vector<StylePicture> draw_styles(const std::string& library, uint32_t seed, uint32_t first,
                                      uint32_t count, bool strays);

}  // namespace terrazzo::coverage
