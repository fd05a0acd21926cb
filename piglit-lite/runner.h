// Stage: piglit-lite, drawing scenes with every library and configuration.
// Input: scenes and libraries. Output: one SceneReport a scene: drawings, comparisons, broken promises.
// Invariant: a drawing is one child process; scenes run side by side, their reports come back in order.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare.h"

namespace terrazzo::piglit {

struct Options {
    std::string draw_program;
    std::string ours;
    std::string theirs;
    std::vector<int> threads{0, 2};
    std::vector<std::string> isas{""};  // "" lets the library choose
    bool softpipe = true;               // draw Mesa's own second opinion, the bar to beat
    bool in_object = false;             // draw to a frame buffer object in the window's place
    bool ours_is_softpipe =
        false;        // softpipe stands in for ours: how the comparison judges Mesa against itself
    int samples = 0;  // of the object's pixels; 0: it is not multisampled
    unsigned jobs = 2;
    bool fail_fast = false;  // start no scene after one has failed
};

struct SceneReport {
    const Scene* scene = nullptr;
    Drawing ours;
    Drawing theirs;
    Drawing softpipe;
    Comparison comparison;
    Comparison softpipe_comparison;
    std::vector<std::string> problems;  // the comparison's and those among our own configurations
    double seconds = 0;
    bool open = false;  // differs as Scene::open_difference says

    bool passed() const { return problems.empty(); }
};

// The reports of the chosen scenes in their order; without those that were not started after a failure.
std::vector<SceneReport> run(const Options& options, const std::vector<const Scene*>& chosen,
                             const std::function<void(const SceneReport&)>& finished);

}  // namespace terrazzo::piglit
