// A fragment state with everything it points at, as one shared object: draws that are queued keep it alive,
// and so do the images it samples.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "raster/fragment_state.h"

namespace terrazzo::pipeline {

struct FragmentBlock {
    // What the fragments of filled polygons go through, and those of lines and points, which no polygon
    // stipple touches. `textures` and `polygon_stipple` point into this block.
    raster::FragmentState fill, line, point;
    std::vector<raster::TextureStage> stages;
    using CubeFaces = std::array<raster::Sampler, 6>;
    std::vector<std::unique_ptr<const CubeFaces>> cubes;
    std::vector<uint32_t> polygon_stipple;
    std::vector<std::shared_ptr<const void>> images;  // and whatever else the states point at

    // Without the images, which textures hold.
    size_t size_in_bytes() const {
        return sizeof *this + stages.capacity() * sizeof stages[0] + 4 * polygon_stipple.capacity() +
               images.capacity() * sizeof images[0] + cubes.size() * sizeof(CubeFaces);
    }

    FragmentBlock() = default;
    FragmentBlock(const FragmentBlock&) = delete;
    FragmentBlock& operator=(const FragmentBlock&) = delete;

    // Makes the others from `fill`, ties the pointers and chooses the kernels; called once when everything is
    // filled in.
    void complete(bool smooth_lines, bool smooth_points);
};

}  // namespace terrazzo::pipeline
