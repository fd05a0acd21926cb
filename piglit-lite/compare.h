// Stage: piglit-lite, comparing what two libraries drew.
// Input: two drawings of one scene and its tolerance. Output: figures and the list of broken promises.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "kit/child.h"
#include "scene.h"

namespace terrazzo::piglit {

struct Drawing {
    std::string failure;  // empty when the child finished
    std::string renderer;
    GLenum format = OSMESA_RGBA;
    std::vector<std::uint8_t> colour;
    std::vector<std::uint32_t> depth;
    std::vector<std::uint8_t> stencil;
    std::vector<std::string> errors;
    std::vector<NotedValue> values;

    bool drawn() const { return failure.empty(); }
};

Drawing drawing_of(const kit::ChildReport& report);
// Equal hashes: same pixels, depth, stencil, errors and values.
std::uint64_t hash_of(const Drawing& drawing);
// True when every pixel still has the background's colour.
bool is_blank(const Scene& scene, const Drawing& drawing);

struct Comparison {
    std::size_t pixels = 0;
    std::size_t differing = 0;        // by more than the tolerated steps
    std::size_t coverage = 0;         // drawn in one, background in the other
    std::size_t depth_differing = 0;  // by more than the tolerated steps
    std::size_t stencil_differing = 0;
    double largest_difference = 0;  // in steps of 1/255
    double mean_difference = 0;
    std::uint32_t largest_depth_difference = 0;
    std::vector<std::string> problems;

    bool passed() const { return problems.empty(); }
};

Comparison compare(const Scene& scene, const Drawing& ours, const Drawing& theirs);

}  // namespace terrazzo::piglit
