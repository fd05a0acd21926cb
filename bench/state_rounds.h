// Stage: benchmark of states, measuring. Input: states, libraries and instruction sets. Output: a row per
// state with each contender's times and how its picture differs from the baseline's. Invariant: one child
// process a contender; a state is opened in all of them, then measured in turn, round by round, so that a
// machine that slows down slows all of them. A child that dies is a failure of that state and is started
// anew.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "state_pictures.h"
#include "states/list.h"

namespace terrazzo::bench {

struct StateContender {
    std::string label;
    std::string library;
    std::string isa;  // TERRAZZO_ISA, and what the renderer must name; empty: the library's choice
};

struct StatePlan {
    std::string draw_program;
    // The last is the baseline.
    std::vector<StateContender> contenders;
    std::vector<states::NamedState> states;
    std::uint64_t seed = 0;  // of the random ones among them
    int threads = 0;
    int rounds = 5;
    double seconds = 0.008;  // the least of a measurement; 0: a single frame
    int width = 512, height = 512;
    // Pictures of which more values differ are kept; below 0: all.
    double tolerated_share = 1;
};

struct StateRun {
    std::string renderer;
    bool opened = false;  // drawn, by the library and the instruction set that were asked for
    std::vector<std::string> failures;
    // Of a frame, one a round.
    std::vector<double> cpu_seconds, wall_seconds;
    std::optional<PictureDifference> difference;  // from the baseline's
    std::vector<std::uint8_t> picture;            // when it differs, and the baseline's then
    // Ways that fragments take through ours, as TERRAZZO_DEBUG=stages tells them.
    std::vector<std::string> ways;

    bool measured() const { return !cpu_seconds.empty(); }
    bool has_slow_stage() const;
};

// The ways among what a library wrote to standard error, and the stages that such a way marks as slow.
std::vector<std::string> ways_of(const std::string& log);
std::vector<std::string> slow_stages_of(const std::string& way);

struct StateRow {
    states::NamedState state;
    std::vector<StateRun> runs;  // in the order of StatePlan::contenders
};

// `done` sees each row when it is there, and may take its pictures.
std::vector<StateRow> run_states(const StatePlan& plan, const std::function<void(StateRow&)>& done);

}  // namespace terrazzo::bench
