// Completing a fragment state; see fragment_block.h.
#include "pipeline/fragment_block.h"

#include "raster/kernel_table.h"

namespace terrazzo::pipeline {

void FragmentBlock::complete() {
    state.textures = stages.data();
    state.texture_count = static_cast<uint8_t>(stages.size());
    state.polygon_stipple = polygon_stipple.data();
    state.kernel = raster::kernels().select_kernel(state.key);
}

}  // namespace terrazzo::pipeline
