// Stage: reports. Plots inside our HTML pages, drawn by gnuplot.
// Input: gnuplot's commands without terminal and output. Output: an SVG element. Invariant: nothing is
// written to disk.
#pragma once

#include <string>
#include <string_view>

namespace terrazzo::report {

// Throws std::runtime_error when gnuplot is not there or does not understand. Colours that are to be read in
// light and dark are the caller's; text is grey.
std::string plot(std::string_view commands, int width, int height);

}  // namespace terrazzo::report
