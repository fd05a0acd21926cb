// Completing a fragment state; see fragment_block.h.
#include "pipeline/schedule/fragment_block.h"

#include <cmath>

#include "raster/kernel_table.h"

namespace terrazzo::pipeline {

namespace {

// The state of fragments that carry coverage as well.
void add_coverage(raster::FragmentState& state, raster::Coverage coverage) {
    state.key.coverage = coverage;
    state.varyings.coverage = static_cast<int8_t>(state.varyings.count);
    state.varyings.count = static_cast<uint8_t>(state.varyings.count + 4);
}

void weigh_errors(raster::FragmentState& state) {
    const raster::Varyings& v = state.varyings;
    auto& weights = state.error_weights;
    weights.fill(1.0f);  // colours, coverage
    if (v.fog >= 0) weights[static_cast<size_t>(v.fog)] = std::fabs(state.fog_scale);
    for (int i = 0; i < state.texture_count; ++i) {
        const raster::TextureStage& stage = state.textures[i];
        const raster::MipLevel& level = stage.sampler.levels[0];
        const auto first = static_cast<size_t>(v.texture[stage.unit]);
        // Neighbouring texels seldom differ by more than an eighth of the range.
        const bool exact = state.stages.exact_coordinates;
        weights[first] = exact ? 0.0f : static_cast<float>(level.width) / 8;
        weights[first + 1] = exact ? 0.0f : static_cast<float>(level.height) / 8;
        if (v.uses_r >> stage.unit & 1) weights[first + 2] = 0.0f;
        if (v.projective >> stage.unit & 1) weights[first + 3] = 0.0f;
    }
}

// Chooses the kernels.
void finish(raster::FragmentState& state, std::vector<raster::TextureStage>& stages) {
    raster::kernels().choose(state, stages);
    weigh_errors(state);
}

}  // namespace

void FragmentBlock::complete(bool smooth_lines, bool smooth_points) {
    fill.textures = stages.data();
    fill.texture_count = static_cast<uint8_t>(stages.size());
    fill.polygon_stipple = polygon_stipple.data();
    finish(fill, stages);
    line = fill;
    line.key.polygon_stipple = false;
    point = line;
    if (smooth_lines) add_coverage(line, raster::Coverage::kLine);
    if (smooth_points) add_coverage(point, raster::Coverage::kPoint);
    // Of one key one choice.
    for (raster::FragmentState* const state : {&line, &point})
        if (state->key != fill.key) finish(*state, stages);
}

}  // namespace terrazzo::pipeline
