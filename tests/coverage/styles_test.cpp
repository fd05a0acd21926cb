// Pictures of random rasterization state against Debian's libOSMesa, each library in a process of its own:
// the same pixels covered the same number of times, colours within 1/255, depths within a step.
//
// TERRAZZO_COVERAGE_FIRST says from which number on, TERRAZZO_COVERAGE_PICTURES how many: what a failure
// prints is enough to draw the same picture again.
#include "styles.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "child_runs.h"

namespace terrazzo::coverage {
namespace {

using nlohmann::json;

constexpr uint32_t kSeed = 7;

json serve_styles(const json& a) {
    json pictures = json::array();
    for (StylePicture& p : draw_styles(a.at("library"), kSeed, a.at("first"), a.at("count"), a.at("strays")))
        pictures.push_back(
            {json::binary(std::move(p.colors)), json::binary(std::move(p.counts)), std::move(p.depths)});
    return pictures;
}

json run(const Renderer& renderer, uint32_t first, uint32_t count, bool strays = false) {
    json result = run_task("styles", renderer, {{"first", first}, {"count", count}, {"strays", strays}});
    return result.is_null() ? json::array() : result;
}

struct Tally {
    size_t pixels = 0, drawn = 0, counts = 0, colors = 0, unequal_colors = 0, depths = 0, unequal_depths = 0;
};

// Adds the differences of one picture, and says where the first are that must not be.
std::string compare(const json& ours, const json& theirs, Tally& tally) {
    const std::vector<uint8_t>&our_colors = ours[0].get_binary(), &their_colors = theirs[0].get_binary();
    const std::vector<uint8_t>&our_counts = ours[1].get_binary(), &their_counts = theirs[1].get_binary();
    const auto our_depths = ours[2].get<std::vector<uint32_t>>(),
               their_depths = theirs[2].get<std::vector<uint32_t>>();
    std::string where;
    size_t counts = 0, colors = 0, depths = 0;
    for (size_t i = 0; i < their_depths.size(); ++i) {
        ++tally.pixels;
        bool wrong = false;
        if (!their_counts.empty()) {
            tally.drawn += their_counts[i] != 0;
            wrong = our_counts[i] != their_counts[i];
            counts += wrong;
        }
        // Blending squares alpha: a step of the fragment's is two of the buffer's.
        constexpr int kSteps[4] = {1, 1, 1, 2};
        int apart = 0;
        for (size_t c = 0; c < 4; ++c) {
            const int steps = std::abs(our_colors[4 * i + c] - their_colors[4 * i + c]);
            apart = std::max(apart, steps <= kSteps[c] ? std::min(steps, 1) : steps);
        }
        tally.unequal_colors += apart != 0;
        colors += apart > 1;
        const int64_t deeper = std::abs(int64_t{our_depths[i]} - int64_t{their_depths[i]});
        tally.unequal_depths += deeper != 0;
        depths += deeper > 1;
        if ((wrong || apart > 1 || deeper > 1) && where.empty())
            where = " first at " + std::to_string(i % kStyleSize) + ' ' + std::to_string(i / kStyleSize);
    }
    tally.counts += counts, tally.colors += colors, tally.depths += depths;
    if (where.empty()) return where;
    return std::to_string(counts) + " counts, " + std::to_string(colors) + " colours, " +
           std::to_string(depths) + " depths," + where;
}

struct Pictures {
    uint32_t first, count;
};
std::vector<Pictures> chosen_pictures() {
    if (std::getenv("TERRAZZO_COVERAGE_FIRST") || std::getenv("TERRAZZO_COVERAGE_PICTURES"))
        return {{number_from("TERRAZZO_COVERAGE_FIRST", 0), number_from("TERRAZZO_COVERAGE_PICTURES", 1)}};
    // The second hundred or so has points between stippled lines that pass the reference's chain of stages
    // (920, 949).
    return {{0, 200}, {900, 60}};
}

TEST(Styles, AreTheReferences) {
    if (std::ifstream(TERRAZZO_REFERENCE_LIBRARY).fail())
        GTEST_SKIP() << TERRAZZO_REFERENCE_LIBRARY " is missing";
    Tally tally;
    size_t pictures = 0;
    constexpr uint32_t kAtOnce = 100;
    for (const auto& [first, count] : chosen_pictures()) {
        for (uint32_t at = 0; at < count; at += kAtOnce) {
            const uint32_t some = std::min(kAtOnce, count - at);
            const json ours = run(kOurs, first + at, some), theirs = run(kTheirs, first + at, some);
            ASSERT_EQ(ours.size(), some);
            ASSERT_EQ(theirs.size(), some);
            pictures += some;
            for (uint32_t i = 0; i < some; ++i) {
                const std::string difference = compare(ours[i], theirs[i], tally);
                EXPECT_TRUE(difference.empty()) << "TERRAZZO_COVERAGE_FIRST=" << first + at + i << ", seed "
                                                << kSeed << ": " << difference;
            }
        }
    }
    std::printf(
        "%zu pictures, %zu pixels, %zu of them drawn and counted; %zu counts differ, %zu colours (%zu not "
        "equal), "
        "%zu depths (%zu not equal)\n",
        pictures, tally.pixels, tally.drawn, tally.counts, tally.colors, tally.unequal_colors, tally.depths,
        tally.unequal_depths);
    EXPECT_GT(tally.drawn, tally.pixels / 12) << "the pictures must show";
}

// NaN, infinities and enormous numbers in positions, normals, colours and texture coordinates: nothing
// crashes, and every instruction set and thread count draws the same.
TEST(Styles, OfStraysAreTheSameEverywhere) {
    const uint32_t count = number_from("TERRAZZO_COVERAGE_PICTURES", 150);
    const json one = run(kOurs, 0, count, true), other = run(kThreaded, 0, count, true);
    ASSERT_EQ(one.size(), count);
    ASSERT_EQ(other.size(), count);
    size_t drawn = 0;
    for (uint32_t i = 0; i < count; ++i) {
        for (const uint8_t times : one[i][1].get_binary()) drawn += times != 0;
        EXPECT_TRUE(one[i] == other[i]) << "picture " << i << ", seed " << kSeed;
    }
    EXPECT_GT(drawn, size_t{count} * kStyleSize * kStyleSize / 20) << "the pictures must show";
    std::printf("%u pictures with strays, %zu pixels drawn and counted\n", count, drawn);
}

}  // namespace
}  // namespace terrazzo::coverage

int main(int argc, char** argv) {
    using namespace terrazzo::coverage;
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, {{"styles", serve_styles}}, &exit_code)) return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
