// Stage: benchmark of states, the few figures that many become.
// Input: rows. Output: ratios (the baseline's time by the contender's: more is faster), their means,
// histogram, worst.
#pragma once

#include <array>
#include <map>
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

// Rows that are judged together.
using Rows = std::vector<const StateRow*>;
Rows rows_of(const std::vector<StateRow>& rows);

// The states of the list, and those that a seed chose: a population of their own, to which nothing is tuned.
struct Population {
    std::string name;  // "named" or "random"
    Rows rows;
};
std::vector<Population> populations(const std::vector<StateRow>& rows);

struct StateSummary {
    std::string of;  // a geometry, or "all"
    int count = 0;   // of those that have a ratio
    double geometric_mean = 0;
    double worst = 0;
    Histogram histogram{};

    int slower() const { return histogram[0]; }  // than the baseline
};
StateSummary summarize(std::string of, const std::vector<double>& ratios);
// Of each geometry that rows have, in the order of the axis, and of all.
std::vector<StateSummary> summaries(const Rows& rows, std::size_t contender, TimeKind kind);

// Rows with a ratio, slowest first.
Rows slowest(const Rows& rows, std::size_t contender, TimeKind kind);

// How many states take a stage that was not made for them, of those whose stages are known.
struct SlowStages {
    int states = 0, known = 0;
    std::map<std::string, int> by_stage;  // states that take this one
};
SlowStages slow_stages(const Rows& rows, std::size_t contender);
// "slow: 3 of 127 states (output=general 2, test=general 1)"; empty where no stages are known.
std::string text_of(const SlowStages& stages);

nlohmann::json to_json(const StatePlan& plan, const std::vector<StateRow>& rows, TimeKind kind);

}  // namespace terrazzo::bench
