// The fuzzer: every command that a library exports, in random order, with random arguments and the documented
// sizes of client memory. Episodes run in child processes, so that a failure ends one of them and is told
// with its seed.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "fuzz/children.h"
#include "fuzz/minimise.h"
#include "fuzz/options.h"

namespace terrazzo::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t seconds_since(Clock::time_point start) {
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start).count());
}

// Runs episodes in this process until one of the limits.
int run_here(const Options& options) {
    Report unread;
    Report& report = options.report < 0 ? unread : map_report(options.report);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit memory{std::uint64_t{6} << 30,
                        std::uint64_t{6} << 30};  // what asks for more is told that there is none
    setrlimit(RLIMIT_AS, &memory);
#endif
    const Library library(options.library, options.only);
    const auto start = Clock::now();
    for (std::uint64_t i = 0;; ++i) {
        const bool done = (options.episodes > 0 && i >= options.episodes) ||
                          (options.calls > 0 && report.calls >= options.calls) ||
                          (options.seconds > 0 && seconds_since(start) >= options.seconds);
        if (done) break;
        report.seed = options.seed + i;
        report.calls += run_episode(library, options.episode, options.seed + i);
    }
    return 0;
}

std::vector<std::string> remaining(const Options& options, std::uint64_t seed, std::uint64_t calls,
                                   std::uint64_t seconds) {
    std::vector<std::string> arguments = episode_arguments(options, seed);
    const auto set = [&](const char* name, std::uint64_t value) {
        arguments.insert(arguments.end(), {name, std::to_string(value)});
    };
    set("--episodes", options.episodes == 0 ? 0 : options.seed + options.episodes - seed);
    if (options.calls > 0) set("--calls", options.calls - calls);
    if (options.seconds > 0) set("--seconds", std::max<std::uint64_t>(options.seconds - seconds, 1));
    return arguments;
}

void tell(const Options& options, std::uint64_t seed, const Outcome& outcome) {
    const std::size_t shown = std::min<std::size_t>(outcome.output.size(), 6000);
    std::printf("%.*s\nEpisode %llu failed: %s\nTo repeat it:", static_cast<int>(shown),
                outcome.output.c_str(), static_cast<unsigned long long>(seed), outcome.kind.c_str());
    for (const std::string& argument : episode_arguments(options, seed)) std::printf(" %s", argument.c_str());
    std::printf("\nFor the calls that matter, --minimise instead of --here.\n");
    std::fflush(stdout);
}

// Runs children until one of the limits; each failure ends a child, and the next begins behind it.
int run_children(const Options& options) {
    constexpr int kTellEvery = 10'000;  // milliseconds
    const auto start = Clock::now();
    std::uint64_t seed = options.seed, calls = 0;
    unsigned failures = 0;
    const auto is_over = [&] {
        return failures >= options.failures || (options.calls > 0 && calls >= options.calls) ||
               (options.seconds > 0 && seconds_since(start) >= options.seconds) ||
               (options.episodes > 0 && seed >= options.seed + options.episodes);
    };
    const auto progress = [&](std::uint64_t made) {
        std::printf("%s, %u thread%s: %llu calls, episode %llu, %llu s, %u failures\n",
                    options.episode.system.c_str(), options.episode.threads,
                    options.episode.threads == 1 ? "" : "s", static_cast<unsigned long long>(made),
                    static_cast<unsigned long long>(seed),
                    static_cast<unsigned long long>(seconds_since(start)), failures);
        std::fflush(stdout);
    };
    while (!is_over()) {
        Child child(remaining(options, seed, calls, seconds_since(start)));
        while (!child.wait(kTellEvery)) {
            seed = child.report().seed;
            progress(calls + child.report().calls);
        }
        calls += child.report().calls;
        const Outcome outcome = child.outcome();
        seed = child.report().seed;
        if (outcome.failed) {
            ++failures;
            tell(options, seed, outcome);
        }
        ++seed;
    }
    --seed;
    progress(calls);
    return failures > 0 || calls == 0 ? 1 : 0;
}

}  // namespace
}  // namespace terrazzo::fuzz

int main(int count, char** arguments) {
    using namespace terrazzo::fuzz;
    const Options options = parse_options(count, arguments);
    if (options.minimise) return minimise(options);
    return options.here ? run_here(options) : run_children(options);
}
