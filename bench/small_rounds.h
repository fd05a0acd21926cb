// Stage: benchmark of small frames, measuring. Input: frames, libraries. Output: a row per frame with each
// library's times, and whether the pictures agree. Invariant: one child process a library; a frame is opened
// in all of them, then measured in turn, round by round, so that a machine that slows down slows all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "small/small_frames.h"

namespace terrazzo::bench {

struct SmallContender {
    std::string label;
    std::string library;
};

struct SmallPlan {
    std::string draw_program;
    std::vector<SmallContender> contenders;  // the last is the baseline
    std::vector<small_frames::Description> frames;
    int threads = 0;
    int rounds = 7;
    double seconds = 0.02;  // the least of a measurement
};

struct SmallRun {
    std::vector<std::string> failures;
    std::vector<double> cpu_seconds;  // of a frame, one a round
    std::vector<std::uint8_t> picture;
    double differing = 0;  // share of values that are not the baseline's

    double frame_seconds() const;  // the median; 0 when nothing was measured
};

struct SmallRow {
    small_frames::Description frame;
    std::vector<SmallRun> runs;  // in the order of SmallPlan::contenders

    // How many times the baseline's speed; 0 when one of the two was not measured.
    double ratio(std::size_t contender) const;
};

// The share of values that differ by more than a step of 1/255: bytes, or depths as floats. 1 where pictures
// are of different sizes or there is none.
double differing_share(const small_frames::Description& frame, const std::vector<std::uint8_t>& a,
                       const std::vector<std::uint8_t>& b);

// Whether all pixels are alike, or there are none.
bool is_uniform(const small_frames::Description& frame, const std::vector<std::uint8_t>& picture);

// `done` sees each row when it is there.
std::vector<SmallRow> run_small(const SmallPlan& plan, const std::function<void(const SmallRow&)>& done);

nlohmann::json to_json(const SmallPlan& plan, const std::vector<SmallRow>& rows);

}  // namespace terrazzo::bench
