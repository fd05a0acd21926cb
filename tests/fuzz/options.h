// The fuzzer's command line.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/episode.h"

namespace terrazzo::fuzz {

struct Options {
    EpisodeOptions episode;
    std::string library;
    std::string only;           // a regular expression over the commands' names
    std::uint64_t seed = 1;     // of the first episode; each has the next one
    std::uint64_t calls = 0;    // ends after so many, 0 for no limit
    std::uint64_t seconds = 0;  // ends after so many, 0 for no limit
    unsigned failures = 3;      // ends after so many
    bool here = false;          // episodes run in this process
    bool minimise = false;
    int report = -1;             // the file of shared memory that tells the parent how far this process is
    std::uint64_t episodes = 0;  // ends after so many, 0 for no limit
};

// Ends the process where the command line is wrong, or asks for help.
Options parse_options(int count, char** arguments);

}  // namespace terrazzo::fuzz
