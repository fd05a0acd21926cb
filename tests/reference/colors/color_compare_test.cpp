// Random state drawn by our libOSMesa and by the reference's, in a process each: colours must be as close as
// each trial says; most must be equal in every bit.
//
// TERRAZZO_COLOR_SEED=n draws the one seed a failure names; TERRAZZO_COLOR_SEEDS=n the first n of every
// trial.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "colors/trial.h"
#include "kit/child.h"

namespace terrazzo::test {
namespace {

using nlohmann::json;

std::vector<Trial> all_trials() {
    std::vector<Trial> trials = lighting_trials();
    for (const auto& more : {fragment_trials(), combine_trials()})
        trials.insert(trials.end(), more.begin(), more.end());
    return trials;
}

const Trial& find_trial(const std::string& name) {
    static const std::vector<Trial> trials = all_trials();
    for (const Trial& trial : trials)
        if (trial.name == name) return trial;
    throw std::runtime_error("no such trial: " + name);
}

// Child side: the colour buffer of each seed.
json draw(const json& arguments) {
    const kit::Library library(arguments.at("library").get<std::string>());
    const Trial& trial = find_trial(arguments.at("trial"));
    const kit::ContextOptions options{
        .format = trial.format, .type = trial.type, .width = kTrialSize, .height = kTrialSize};
    json pictures = json::array();
    for (const unsigned seed : arguments.at("seeds")) {
        const kit::OffscreenContext context(library, options);
        const Gl& gl = library.gl;
        gl.ClearColor(kClear, kClear, kClear, kClear);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        Dice dice(seed);
        trial.draw(gl, dice);
        gl.Finish();
        const std::vector<GLenum> errors = context.take_errors();
        if (!errors.empty())
            throw std::runtime_error(trial.name + std::string(" leaves ") + kit::error_name(errors[0]));
        pictures.push_back(json::binary({context.colour_buffer().begin(), context.colour_buffer().end()}));
    }
    return pictures;
}

// One component as a number of steps of 1/255.
double steps_at(const std::vector<std::uint8_t>& picture, GLenum type, std::size_t index) {
    if (type == GL_UNSIGNED_BYTE) return picture[index];
    if (type == GL_UNSIGNED_SHORT) {
        std::uint16_t value;
        std::memcpy(&value, picture.data() + 2 * index, sizeof value);
        return value / 257.0;
    }
    float value;
    std::memcpy(&value, picture.data() + 4 * index, sizeof value);
    return value * 255.0;
}

struct Difference {
    std::size_t drawn = 0, unequal = 0, differing = 0;
    double largest = 0;
    std::string first;
};

void compare(const Trial& trial, unsigned seed, const std::vector<std::uint8_t>& ours,
             const std::vector<std::uint8_t>& theirs, Difference& result) {
    if (trial.type == GL_UNSIGNED_SHORT_5_6_5) {
        for (std::size_t i = 0; i + 1 < theirs.size(); i += 2) {
            ++result.drawn;
            if (ours[i] == theirs[i] && ours[i + 1] == theirs[i + 1]) continue;
            ++result.unequal, ++result.differing;
            result.largest = 255;
            if (result.first.empty()) result.first = "seed " + std::to_string(seed);
        }
        return;
    }
    for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(kTrialSize) * kTrialSize; ++pixel) {
        double apart = 0;
        bool unequal = false, drawn = false;
        for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c) {
            const double a = steps_at(ours, trial.type, c), b = steps_at(theirs, trial.type, c);
            drawn |= b != kClear * 255;
            if (a == b || (std::isnan(a) && std::isnan(b))) continue;
            unequal = true;
            apart = std::max(apart, std::isfinite(a - b) ? std::abs(a - b) : 1e9);
        }
        result.drawn += drawn;
        result.unequal += unequal;
        result.differing += unequal && apart > trial.bound.steps;
        result.largest = std::max(result.largest, apart);
        if (!unequal || apart <= trial.bound.largest || !result.first.empty()) continue;
        result.first = "seed " + std::to_string(seed) + " at " + std::to_string(pixel % kTrialSize) + ' ' +
                       std::to_string(pixel / kTrialSize) + ":";
        for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c)
            result.first += "\n  " + std::to_string(steps_at(ours, trial.type, c) / 255) + " instead of " +
                            std::to_string(steps_at(theirs, trial.type, c) / 255);
    }
}

json run(const std::string& library, const Trial& trial, const std::vector<unsigned>& seeds) {
    const kit::ChildReport report =
        kit::run_in_child({.executable = {},
                           .task = "draw",
                           .arguments = {{"library", library}, {"trial", trial.name}, {"seeds", seeds}},
                           .environment = {{"LP_NUM_THREADS", "0"}, {"TERRAZZO_THREADS", "0"}}});
    EXPECT_TRUE(report.finished()) << library << ": " << report.message << '\n' << report.output;
    return report.finished() ? report.result : json::array();
}

std::vector<unsigned> chosen_seeds(const Trial& trial) {
    if (const char* seed = std::getenv("TERRAZZO_COLOR_SEED"))
        return {static_cast<unsigned>(std::atoi(seed))};
    const char* const count = std::getenv("TERRAZZO_COLOR_SEEDS");
    std::vector<unsigned> seeds(static_cast<std::size_t>(count ? std::atoi(count) : trial.seeds));
    for (unsigned i = 0; i < seeds.size(); ++i) seeds[i] = i + 1;
    return seeds;
}

class ColorCompare : public testing::TestWithParam<Trial> {};

TEST_P(ColorCompare, IsTheReferences) {
    const Trial& trial = GetParam();
    if (std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail())
        GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    const std::vector<unsigned> seeds = chosen_seeds(trial);
    const json ours = run(TERRAZZO_OWN_LIBRARY, trial, seeds);
    const json theirs = run(TERRAZZO_REFERENCE_LIBRARY, trial, seeds);
    ASSERT_EQ(ours.size(), seeds.size());
    ASSERT_EQ(theirs.size(), seeds.size());
    Difference result;
    for (std::size_t i = 0; i < seeds.size(); ++i)
        compare(trial, seeds[i], ours[i].get_binary(), theirs[i].get_binary(), result);
    RecordProperty("drawn", static_cast<int>(result.drawn));
    RecordProperty("unequal", static_cast<int>(result.unequal));
    RecordProperty("largest", std::to_string(result.largest));
    std::printf("%-24s %8zu pixels, %7zu not equal, %7zu further than %g, largest %.3g\n", trial.name,
                result.drawn, result.unequal, result.differing, trial.bound.steps, result.largest);
    ASSERT_GT(result.drawn, seeds.size() * 50) << "the trial must draw something";
    EXPECT_LE(static_cast<double>(result.differing),
              trial.bound.differing_share * static_cast<double>(result.drawn))
        << result.first;
    EXPECT_LE(result.largest, trial.bound.largest) << result.first;
}

INSTANTIATE_TEST_SUITE_P(All, ColorCompare, testing::ValuesIn(all_trials()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace terrazzo::test

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"draw", terrazzo::test::draw}}, &exit_code))
        return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
