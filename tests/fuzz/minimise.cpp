// Delta debugging over the operations of an episode; see minimise.h. It works because what an operation does
// depends on the seed and its own index, not on the operations before it.
#include "fuzz/minimise.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "fuzz/children.h"

namespace terrazzo::fuzz {
namespace {

using Operations = std::vector<std::uint64_t>;

class Minimiser {
  public:
    explicit Minimiser(const Options& options)
        : m_options(options), m_file("/tmp/terrazzo-fuzz-" + std::to_string(getpid())) {}
    ~Minimiser() { unlink(m_file.c_str()); }

    Outcome run(const Operations& operations, bool trace = false) {
        {
            std::ofstream file(m_file);
            for (const std::uint64_t operation : operations) file << operation << '\n';
        }
        auto arguments = episode_arguments(m_options, m_options.seed);
        arguments.insert(arguments.end(), {"--keep", m_file});
        if (trace) arguments.push_back("--trace");
        Child child(arguments);
        child.wait(600'000);
        child.stop();
        return child.outcome();
    }

    // Whether it fails, and for the same cause. Threads meet at different moments each time: they get more
    // than one try.
    bool fails(const Operations& operations, const std::string& kind) {
        const int tries = m_options.episode.threads > 1 ? 8 : 1;
        for (int i = 0; i < tries; ++i) {
            const Outcome outcome = run(operations);
            if (outcome.failed && outcome.kind == kind) return true;
        }
        return false;
    }

    Operations shrink(Operations operations, const std::string& kind) {
        for (std::size_t chunk = std::max<std::size_t>(operations.size() / 2, 1);; chunk /= 2) {
            for (std::size_t at = 0; at < operations.size() && operations.size() > 1;) {
                Operations fewer = operations;
                const auto from = fewer.begin() + static_cast<std::ptrdiff_t>(at);
                fewer.erase(from,
                            from + static_cast<std::ptrdiff_t>(std::min(chunk, operations.size() - at)));
                if (!fewer.empty() && fails(fewer, kind))
                    operations = std::move(fewer);
                else
                    at += chunk;
            }
            std::fprintf(stderr, "fuzz: %zu operations left\n", operations.size());
            if (chunk <= 1) return operations;
        }
    }

  private:
    const Options& m_options;
    const std::string m_file;
};

Operations all_operations(const EpisodeOptions& episode) {
    if (!episode.keep.empty()) return episode.keep;
    Operations all;
    for (std::uint64_t thread = 0; thread < episode.threads; ++thread) {
        for (std::uint64_t i = 0; i < episode.operations; ++i) all.push_back(thread * kThreadStride + i);
    }
    return all;
}

}  // namespace

std::vector<std::string> episode_arguments(const Options& options, std::uint64_t seed) {
    const EpisodeOptions& episode = options.episode;
    std::vector<std::string> arguments = {"--here",
                                          "--library",
                                          options.library,
                                          "--system",
                                          episode.system,
                                          "--seed",
                                          std::to_string(seed),
                                          "--episodes",
                                          "1",
                                          "--operations",
                                          std::to_string(episode.operations),
                                          "--threads",
                                          std::to_string(episode.threads),
                                          "--call-seconds",
                                          std::to_string(episode.seconds_per_call)};
    if (!options.only.empty()) arguments.insert(arguments.end(), {"--only", options.only});
    return arguments;
}

int minimise(const Options& options) {
    Minimiser minimiser(options);
    const Operations all = all_operations(options.episode);
    const Outcome whole = minimiser.run(all);
    if (!whole.failed) {
        std::printf("Episode %llu does not fail.\n", static_cast<unsigned long long>(options.seed));
        return 0;
    }
    std::printf("Episode %llu: %s\n", static_cast<unsigned long long>(options.seed), whole.kind.c_str());
    const Operations few = minimiser.shrink(all, whole.kind);
    std::printf("%zu operations are enough:\n%s\nTo repeat it, --keep a file with", few.size(),
                minimiser.run(few, true).output.c_str());
    for (const std::uint64_t operation : few)
        std::printf(" %llu", static_cast<unsigned long long>(operation));
    std::printf("\n");
    return 1;
}

}  // namespace terrazzo::fuzz
