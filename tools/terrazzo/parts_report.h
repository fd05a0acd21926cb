// Stage: the page of `terrazzo bench states`, its parts beside states. Output: text, HTML with plots.
#pragma once

#include <string>
#include <vector>

#include "report_parts.h"

namespace terrazzo {

void print_parts(const std::vector<bench::ReportPart>& parts);

// A tile a part and contender, to stand among those of states.
std::string parts_tiles(const std::vector<bench::ReportPart>& parts);
// Throws std::runtime_error when there is nothing to plot with.
std::string parts_sections(const std::vector<bench::ReportPart>& parts);

}  // namespace terrazzo
