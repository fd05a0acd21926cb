// Random sequences of state commands, played on our libOSMesa and on the reference's in a process each: after
// every command the error and everything that can be queried must be equal.
//
// TERRAZZO_STATE_SEED=n plays the one seed a failure names; TERRAZZO_STATE_SEEDS=n plays the first n.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "kit/child.h"
#include "kit/offscreen.h"
#include "player.h"
#include "state_dump.h"

namespace terrazzo::test {
namespace {

using nlohmann::json;

constexpr int kSeeds = 60;
constexpr int kSteps = 120;

// Formats of the buffer and depths take turns: queries of colours and of the target's bits depend on them.
kit::ContextOptions options_of(unsigned seed) {
    switch (seed % 4) {
        case 1:
            return {.type = GL_FLOAT};
        case 2:
            return {.format = OSMESA_RGB, .type = GL_UNSIGNED_SHORT, .depth_bits = 16, .stencil_bits = 0};
        case 3:
            return {.format = OSMESA_BGRA, .depth_bits = 0, .stencil_bits = 0};
    }
    return {};
}

// Child side: what every seed did, step by step; of the state only the lines that a step changed.
json play_seed(const kit::Library& library, unsigned seed) {
    const kit::OffscreenContext context(library, options_of(seed));
    StatePlayer player(library.gl, seed);
    std::vector<std::string> before = dump_state(library.gl);
    json steps = json::array({{{"command", "(initial state)"}, {"error", 0}, {"changed", before}}});
    for (int i = 0; i < kSteps; ++i) {
        const std::string command = player.play();
        const GLenum error = library.gl.GetError();
        std::vector<std::string> after = dump_state(library.gl);
        steps.push_back({{"command", command}, {"error", error}, {"changed", changed(before, after)}});
        before = std::move(after);
    }
    return steps;
}

json play(const json& arguments) {
    const kit::Library library(arguments.at("library").get<std::string>());
    json seeds = json::array();
    for (unsigned seed : arguments.at("seeds")) seeds.push_back(play_seed(library, seed));
    return seeds;
}

std::string difference(const json& ours, const json& theirs) {
    if (ours["error"] != theirs["error"]) {
        return "error " + ours["error"].dump() + ", the reference's is " + theirs["error"].dump();
    }
    const std::set<std::string> our_lines = ours["changed"], their_lines = theirs["changed"];
    std::string text;
    for (const std::string& line : our_lines) {
        if (!their_lines.contains(line)) text += "\n  ours    " + line;
    }
    for (const std::string& line : their_lines) {
        if (!our_lines.contains(line)) text += "\n  theirs  " + line;
    }
    return text;
}

std::string history(const json& steps, std::size_t last) {
    std::string text;
    for (std::size_t step = 1; step < last; ++step) {
        text += "\n  " + std::to_string(step) + ' ' + steps[step]["command"].get<std::string>();
    }
    return text;
}

// The first step at which the two differ: after it their states are different and say nothing more.
void expect_equal(unsigned seed, const json& ours, const json& theirs) {
    for (std::size_t step = 0; step < ours.size(); ++step) {
        const std::string found = difference(ours[step], theirs[step]);
        if (found.empty()) continue;
        ADD_FAILURE() << "seed " << seed << " step " << step << ": "
                      << ours[step]["command"].get<std::string>() << found << "\nafter"
                      << history(ours, step);
        return;
    }
}

json run(const std::string& library, const std::vector<unsigned>& seeds) {
    const kit::ChildReport report = kit::run_in_child({.executable = {},
                                                       .task = "play",
                                                       .arguments = {{"library", library}, {"seeds", seeds}},
                                                       .environment = {}});
    EXPECT_TRUE(report.finished()) << library << ": " << report.message << '\n' << report.output;
    return report.finished() ? report.result : json::array();
}

std::vector<unsigned> chosen_seeds() {
    if (const char* seed = std::getenv("TERRAZZO_STATE_SEED"))
        return {static_cast<unsigned>(std::atoi(seed))};
    const char* count = std::getenv("TERRAZZO_STATE_SEEDS");
    std::vector<unsigned> seeds(static_cast<std::size_t>(count ? std::atoi(count) : kSeeds));
    for (unsigned i = 0; i < seeds.size(); ++i) seeds[i] = i + 1;
    return seeds;
}

TEST(StateCompare, EveryCommandLeavesTheStateOfTheReference) {
    if (std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail())
        GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    const std::vector<unsigned> seeds = chosen_seeds();
    const json ours = run(TERRAZZO_OWN_LIBRARY, seeds);
    const json theirs = run(TERRAZZO_REFERENCE_LIBRARY, seeds);
    ASSERT_EQ(ours.size(), seeds.size());
    ASSERT_EQ(theirs.size(), seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) expect_equal(seeds[i], ours[i], theirs[i]);
}

}  // namespace
}  // namespace terrazzo::test

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"play", terrazzo::test::play}}, &exit_code))
        return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
