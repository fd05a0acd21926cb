// Stage: the page of `terrazzo bench states`. Input: rows. Output: HTML with plots.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

#include "report_parts.h"
#include "state_summary.h"

namespace terrazzo {

// What a run drew; it must have kept its picture.
OIIO::ImageBuf picture_of(const bench::StatePlan& plan, const bench::StateRow& row, std::size_t contender);

// Throws std::runtime_error when there is nothing to plot with.
std::string states_page(const bench::StatePlan& plan, const std::vector<bench::StateRow>& rows,
                        bench::TimeKind kind, const std::vector<bench::ReportPart>& parts);

}  // namespace terrazzo
