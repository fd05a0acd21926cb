// Completing a fragment state; see fragment_block.h.
#include "pipeline/fragment_block.h"

#include "raster/kernel_table.h"

namespace terrazzo::pipeline {

void FragmentBlock::complete() {
    fill.textures = stages.data();
    fill.texture_count = static_cast<uint8_t>(stages.size());
    fill.polygon_stipple = polygon_stipple.data();
    const auto& select_kernel = raster::kernels().select_kernel;
    fill.kernel = select_kernel(fill.key);
    line = fill;
    if (line.key.polygon_stipple) {
        line.key.polygon_stipple = false;
        line.kernel = select_kernel(line.key);
    }
    point = line;
}

}  // namespace terrazzo::pipeline
