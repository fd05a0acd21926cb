// What the benchmark of small frames makes of its measurements, and the names of frames.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "small_rounds.h"

namespace terrazzo::bench {
namespace {

using small_frames::Description;

TEST(SmallFrames, NamesAreRead) {
    std::set<std::string> names;
    for (const Description& frame : small_frames::descriptions()) {
        EXPECT_EQ(Description::parse(frame.name()).name(), frame.name());
        EXPECT_TRUE(names.insert(frame.name()).second) << frame.name();
    }
    for (const char* wrong : {"", "empty/64/rgba", "empty/64/rgba/window/x", "full/64/rgba/window",
                              "empty/0/rgba/window", "empty/64/bgr/window", "empty/64/rgba/door"})
        EXPECT_THROW(Description::parse(wrong), std::runtime_error) << wrong;
}

TEST(SmallFrames, DifferencesAreInStepsOf255) {
    const Description colours = Description::parse("empty/1/rgba/window"),
                      depths = Description::parse("empty/1/depth/window");
    EXPECT_EQ(differing_share(colours, {10, 20, 30, 40}, {11, 19, 30, 42}), 0.25);
    EXPECT_EQ(differing_share(colours, {}, {}), 1);
    EXPECT_EQ(differing_share(colours, {1, 2, 3, 4}, {1, 2, 3}), 1);
    const auto bytes = [](float depth) {
        std::vector<std::uint8_t> out(sizeof depth);
        std::memcpy(out.data(), &depth, sizeof depth);
        return out;
    };
    EXPECT_EQ(differing_share(depths, bytes(0.5F), bytes(0.502F)), 0);
    EXPECT_EQ(differing_share(depths, bytes(0.5F), bytes(0.51F)), 1);
}

TEST(SmallFrames, UniformIsOneColourEverywhere) {
    const Description rgb = Description::parse("triangle/2/rgb/window");
    EXPECT_TRUE(is_uniform(rgb, {}));
    EXPECT_TRUE(is_uniform(rgb, {1, 2, 3, 1, 2, 3}));
    EXPECT_FALSE(is_uniform(rgb, {1, 2, 3, 1, 2, 4}));
}

TEST(SmallFrames, RatiosAreOfMedians) {
    SmallRow row{Description(), std::vector<SmallRun>(2)};
    EXPECT_EQ(row.ratio(0), 0);
    row.runs[0].cpu_seconds = {1, 9, 2};
    row.runs[1].cpu_seconds = {7, 6, 100};
    EXPECT_DOUBLE_EQ(row.ratio(0), 3.5);
    SmallPlan plan;
    plan.contenders = {{"ours", "a.so"}, {"theirs", "b.so"}};
    const nlohmann::json json = to_json(plan, {row});
    EXPECT_EQ(json["baseline"], "theirs");
    EXPECT_EQ(json["frames"][0]["runs"][0]["ratio"], 3.5);
}

}  // namespace
}  // namespace terrazzo::bench
