// Finds few operations of an episode that still fail as the whole episode does.
#pragma once

#include "fuzz/options.h"

namespace terrazzo::fuzz {

// Prints the calls that are left; returns the process's status.
int minimise(const Options& options);
// The arguments with which this program runs one episode in its own process.
std::vector<std::string> episode_arguments(const Options& options, std::uint64_t seed);

}  // namespace terrazzo::fuzz
