// Meshes whose triangles cut the viewport up: with additive blending every pixel must be counted exactly
// once. Child side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace terrazzo::coverage {

struct MeshResult {
    uint32_t triangles;
    uint32_t missed, doubled;  // pixels
    uint64_t picture;          // a hash of all counts

    friend bool operator==(const MeshResult&, const MeshResult&) = default;
};

// One result a mesh. Meshes are flat to the window, tilted in perspective, or reach over the window's borders
// and the near plane.
std::vector<MeshResult> draw_meshes(const std::string& library, uint32_t seed, uint32_t count);

}  // namespace terrazzo::coverage
