// An episode: contexts, threads and operations that follow from one seed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "fuzz/library.h"
#include "fuzz/window_system.h"

namespace terrazzo::fuzz {

struct EpisodeOptions {
    std::string system = "osmesa";
    unsigned threads = 1;
    std::uint64_t operations = 1000;  // of each thread
    unsigned seconds_per_call = 30;   // then the watchdog ends the process
    bool trace = false;
    // Operations to keep, as thread * kThreadStride + index, in order; all of them where it is empty.
    std::vector<std::uint64_t> keep;
};

inline constexpr std::uint64_t kThreadStride = 1u << 20;

// Returns how many calls were made.
std::uint64_t run_episode(const Library& library, const EpisodeOptions& options, std::uint64_t seed);

}  // namespace terrazzo::fuzz
