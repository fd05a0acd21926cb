// Stage: the benchmark's report, what is measured by programs beside states (bench/report.py): MuJoCo,
// traces, programs with windows. Input: a file of parts, each a table of times of several contenders, the
// last of which is the baseline. Output: medians and ratios as those of states.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "state_summary.h"

namespace terrazzo::bench {

struct PartRow {
    std::string name;
    std::string note;
    std::vector<std::vector<double>> times;  // seconds, by contender

    double seconds(std::size_t contender) const;  // median; 0: not measured
    double ratio(std::size_t contender) const;    // the baseline's time by the contender's; 0: not measured
};

struct ReportPart {
    std::string title;
    std::string about;
    std::string problem;  // why there are no rows
    std::vector<std::string> contenders;
    std::vector<PartRow> rows;
};

// Throws std::runtime_error in words when the file is not there or is no such file.
std::vector<ReportPart> load_parts(const std::string& path);

// Of all rows that have a ratio.
StateSummary summary_of(const ReportPart& part, std::size_t contender);
std::vector<const PartRow*> slowest(const ReportPart& part, std::size_t contender);

nlohmann::json to_json(const std::vector<ReportPart>& parts);

}  // namespace terrazzo::bench
