// Completing a fragment state; see fragment_block.h.
#include "pipeline/fragment_block.h"

#include "raster/kernel_table.h"

namespace terrazzo::pipeline {

namespace {

// The state of fragments that carry coverage as well.
void add_coverage(raster::FragmentState& state, raster::Coverage coverage) {
    state.key.coverage = coverage;
    state.varyings.coverage = static_cast<int8_t>(state.varyings.count);
    state.varyings.count = static_cast<uint8_t>(state.varyings.count + 4);
}

}  // namespace

void FragmentBlock::complete(bool smooth_lines, bool smooth_points) {
    fill.textures = stages.data();
    fill.texture_count = static_cast<uint8_t>(stages.size());
    fill.polygon_stipple = polygon_stipple.data();
    line = fill;
    line.key.polygon_stipple = false;
    point = line;
    if (smooth_lines) add_coverage(line, raster::Coverage::kLine);
    if (smooth_points) add_coverage(point, raster::Coverage::kPoint);
    for (raster::FragmentState* const state : {&fill, &line, &point})
        state->kernel = raster::kernels().select_kernel(state->key);
}

}  // namespace terrazzo::pipeline
