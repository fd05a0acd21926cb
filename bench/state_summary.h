// Stage: benchmark of states, the few figures that many become.
// Input: rows. Output: ratios (the baseline's time by the contender's: more is faster), their means,
// histogram, worst.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "state_rounds.h"

namespace terrazzo::bench {

// Which time decides: that of the process, which other programs on the machine disturb less, or that of the
// clock.
enum class TimeKind { kCpu, kWall };

// Median of a frame over the rounds; 0 when it was not measured.
double frame_seconds(const StateRun& run, TimeKind kind);
// 0 when one of the two was not measured.
double ratio(const StateRow& row, std::size_t contender, TimeKind kind);

// Ratios below the first bound, between two, above the last.
inline constexpr std::array<double, 5> kHistogramBounds{1, 1.5, 2, 3, 4};
using Histogram = std::array<int, kHistogramBounds.size() + 1>;
std::string bin_name(std::size_t bin);

struct StateSummary {
    std::string of;  // a geometry, or "all"
    int count = 0;   // of those that have a ratio
    double geometric_mean = 0;
    double worst = 0;
    Histogram histogram{};
};
StateSummary summarize(std::string of, const std::vector<double>& ratios);
// Of each geometry that rows have, in the order of the axis, and of all.
std::vector<StateSummary> summaries(const std::vector<StateRow>& rows, std::size_t contender, TimeKind kind);

// Rows with a ratio, slowest first.
std::vector<const StateRow*> slowest(const std::vector<StateRow>& rows, std::size_t contender, TimeKind kind);

nlohmann::json to_json(const StatePlan& plan, const std::vector<StateRow>& rows, TimeKind kind);

}  // namespace terrazzo::bench
