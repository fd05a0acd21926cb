// The seed of tests whose threads meet in another way every time.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>

namespace terrazzo::stress {

// A new one for each process, or the one of TERRAZZO_SHARE_SEED; printed when it is first asked for.
inline std::uint64_t seed_of_run() {
    static const std::uint64_t seed = [] {
        const char* const wanted = std::getenv("TERRAZZO_SHARE_SEED");
        const std::uint64_t chosen = wanted ? std::strtoull(wanted, nullptr, 10) : std::random_device()();
        std::cout << "TERRAZZO_SHARE_SEED=" << chosen << '\n';
        return chosen;
    }();
    return seed;
}

}  // namespace terrazzo::stress
