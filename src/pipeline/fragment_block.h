// A fragment state with everything it points at, as one shared object: draws that are queued keep it alive,
// and so do the images it samples.
#pragma once

#include <memory>
#include <vector>

#include "raster/state.h"

namespace terrazzo::pipeline {

struct FragmentBlock {
    raster::FragmentState state;  // `textures` and `polygon_stipple` point into this block
    std::vector<raster::TextureStage> stages;
    std::vector<uint32_t> polygon_stipple;
    std::vector<std::shared_ptr<const void>> images;

    FragmentBlock() = default;
    FragmentBlock(const FragmentBlock&) = delete;
    FragmentBlock& operator=(const FragmentBlock&) = delete;

    // Ties the pointers and chooses the kernel; called once when everything is filled in.
    void complete();
};

}  // namespace terrazzo::pipeline
