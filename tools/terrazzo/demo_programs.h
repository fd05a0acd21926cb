// Stage: the demo's programs with windows.
// Input: the folder that bench/windows/programs.py writes. Output: the report's section about them.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <optional>
#include <string>
#include <vector>

namespace terrazzo {

// Of a picture's pixels, within one step of 255: pictures that agree.
inline constexpr double kAgreeingShare = 0.999;

struct DemoProgram {
    std::string name;
    std::string description;
    // Empty when a driver showed nothing; then `problem` says so.
    std::optional<OIIO::ImageBuf> ours;
    std::optional<OIIO::ImageBuf> theirs;
    std::string problem;
    int frames = 0;
    std::vector<double> within_one;  // shares of the pixels of a frame
    int largest_difference = 0;      // of 255
    double our_rate = 0;             // frames a second; 0: not measured
    double their_rate = 0;

    double ratio() const;  // 0: not measured
    double lowest_share() const;
    bool agrees() const;
};

struct DemoPrograms {
    std::vector<DemoProgram> programs;
    std::vector<std::string> absent;  // not installed
    std::string our_renderer, their_renderer;
};

// Throws std::runtime_error when the folder is not as that program leaves it.
DemoPrograms load_programs(const std::string& folder);
double mean_ratio(const DemoPrograms& programs);
// HTML; empty when there are none.
std::string programs_section(const DemoPrograms& programs);

}  // namespace terrazzo
