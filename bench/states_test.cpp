// What the benchmark of states makes of its measurements: ratios, means, histograms, differences of pictures.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>

#include "report_parts.h"
#include "state_summary.h"

namespace terrazzo::bench {
namespace {

using states::State;

std::vector<std::uint8_t> bytes_of(const std::vector<float>& values) {
    std::vector<std::uint8_t> bytes(values.size() * sizeof(float));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

StateRow row(const char* geometry, std::vector<double> ours, std::vector<double> theirs) {
    StateRow row{{std::string("x/") + geometry, State().set(states::Axis::kGeometry, geometry)},
                 std::vector<StateRun>(2)};
    row.runs[0].cpu_seconds = row.runs[0].wall_seconds = std::move(ours);
    row.runs[1].cpu_seconds = row.runs[1].wall_seconds = std::move(theirs);
    return row;
}

TEST(StatePictures, OneStepIsNoDifference) {
    const PictureDifference none = difference(State(), {10, 20, 30, 40}, {11, 19, 30, 41});
    EXPECT_EQ(none.share, 0);
    EXPECT_EQ(none.largest, 1);
    const PictureDifference some = difference(State(), {10, 20, 30, 40}, {10, 22, 30, 45});
    EXPECT_EQ(some.share, 0.5);
    EXPECT_EQ(some.largest, 5);
}

TEST(StatePictures, CoarseBuffersAreComparedInTheirOwnSteps) {
    const State coarse = State::parse("buffer=rgb565");
    // Red 1 and 2, then 1 and 3 of 31.
    EXPECT_EQ(difference(coarse, {0, 1 << 3}, {0, 2 << 3}).share, 0);
    EXPECT_NEAR(difference(coarse, {0, 1 << 3}, {0, 3 << 3}).share, 1.0 / 3, 1e-9);
}

TEST(StatePictures, FineBuffersAreComparedInStepsOf255) {
    const State deep = State::parse("buffer=rgba16"), floats = State::parse("buffer=rgba32f");
    EXPECT_EQ(difference(deep, {0, 1, 0, 0}, {1, 2, 0, 0}).share, 0);  // 256 and 513 of 65535
    EXPECT_EQ(difference(deep, {0, 1, 0, 0}, {0, 4, 0, 0}).share, 0.5);
    EXPECT_EQ(difference(floats, bytes_of({0.5F, 1}), bytes_of({0.503F, 1.01F})).share, 0.5);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(difference(floats, bytes_of({nan, nan}), bytes_of({nan, 0})).share, 0.5);
}

TEST(StatePictures, UniformIsOneColourEverywhere) {
    EXPECT_TRUE(is_uniform(State(), {1, 2, 3, 4, 1, 2, 3, 4}));
    EXPECT_FALSE(is_uniform(State(), {1, 2, 3, 4, 1, 2, 3, 5}));
    EXPECT_FALSE(is_uniform(State::parse("buffer=rgb565"), {0, 1, 0, 2}));
}

TEST(StatePictures, OfDifferentSizesAreRefused) {
    EXPECT_THROW(difference(State(), {1, 2, 3, 4}, {1}), std::runtime_error);
}

TEST(StateSummary, RatiosAreMediansOfTheBaselineByTheOther) {
    EXPECT_DOUBLE_EQ(ratio(row("large", {1, 9, 2}, {7, 6, 100}), 0, TimeKind::kCpu), 3.5);
    EXPECT_EQ(ratio(row("large", {}, {1}), 0, TimeKind::kCpu), 0);
    EXPECT_EQ(ratio(row("large", {1}, {}), 0, TimeKind::kWall), 0);
}

TEST(StateSummary, BinsHoldTheirLowerBounds) {
    const StateSummary summary = summarize("all", {0.5, 1, 1.49, 1.5, 2, 2.5, 3, 4, 9});
    EXPECT_EQ(summary.histogram, (Histogram{1, 2, 1, 2, 1, 2}));
    EXPECT_EQ(summary.count, 9);
    EXPECT_EQ(summary.worst, 0.5);
    EXPECT_NEAR(summarize("", {1, 4}).geometric_mean, 2, 1e-12);
    EXPECT_EQ(bin_name(0), "<1");
    EXPECT_EQ(bin_name(2), "1.5-2");
    EXPECT_EQ(bin_name(5), ">4");
}

TEST(StateSummary, EachGeometryAndAll) {
    const std::vector<StateRow> rows{row("large", {1}, {2}), row("small", {1}, {8}), row("small", {1}, {2}),
                                     row("medium", {}, {1})};
    const std::vector<StateSummary> all = summaries(rows_of(rows), 0, TimeKind::kCpu);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].of, "large");
    EXPECT_EQ(all[1].of, "small");
    EXPECT_NEAR(all[1].geometric_mean, 4, 1e-12);
    EXPECT_EQ(all[2].of, "all");
    EXPECT_EQ(all[2].count, 3);
    const Rows sorted = slowest(rows_of(rows), 0, TimeKind::kCpu);
    ASSERT_EQ(sorted.size(), 3U);
    EXPECT_EQ(sorted.back(), &rows[1]);
}

TEST(StateSummary, RandomStatesAreAPopulationOfTheirOwn) {
    std::vector<StateRow> rows{row("large", {1}, {2}), row("small", {1}, {8})};
    EXPECT_EQ(populations(rows).size(), 1U);
    rows[0].state.name = "random/7-0/large";
    const std::vector<Population> both = populations(rows);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].name, "named");
    EXPECT_EQ(both[0].rows, Rows{&rows[1]});
    EXPECT_EQ(both[1].name, "random");
    EXPECT_EQ(both[1].rows, Rows{&rows[0]});
}

TEST(StateSummary, SlowStagesAreCountedByState) {
    const std::vector<std::string> ways = ways_of(
        "terrazzo: stages: output=store\nterrazzo: glEnd: GL_INVALID_OPERATION: x\n"
        "terrazzo: stages: end: 4 tiles, 64 fragments: test=less output=general(slow)\n"
        "terrazzo: stages: end: 2 tiles, 32 fragments: test=general(slow) output=general(slow)\n"
        "terrazzo: stages: end: slow: 2 of 2 ways, 96 of 96 fragments\n");
    EXPECT_EQ(ways, (std::vector<std::string>{"test=less output=general(slow)",
                                              "test=general(slow) output=general(slow)"}));
    std::vector<StateRow> rows{row("large", {1}, {2}), row("large", {1}, {2}), row("large", {1}, {2})};
    EXPECT_EQ(text_of(slow_stages(rows_of(rows), 0)), "");
    rows[0].runs[0].ways = ways;
    rows[1].runs[0].ways = {"test=less output=store"};
    const SlowStages slow = slow_stages(rows_of(rows), 0);
    EXPECT_EQ(slow.states, 1);
    EXPECT_EQ(slow.known, 2);
    EXPECT_EQ(text_of(slow), "slow: 1 of 2 states (output=general 1, test=general 1)");
}

TEST(StateSummary, JsonHasRowsAndFailures) {
    StatePlan plan;
    plan.contenders = {{"ours", "a.so", "avx2"}, {"theirs", "b.so", ""}};
    std::vector<StateRow> rows{row("large", {0.5}, {1})};
    rows[0].runs[0].failures = {"GL_INVALID_ENUM"};
    rows[0].runs[0].ways = {"output=general(slow)"};
    rows[0].runs[0].difference = PictureDifference{0.25, 7};
    const nlohmann::json json = to_json(plan, rows, TimeKind::kCpu);
    EXPECT_EQ(json["baseline"], "theirs");
    EXPECT_EQ(json["states"][0]["runs"][0]["ratio"], 2);
    EXPECT_EQ(json["states"][0]["runs"][0]["failures"][0], "GL_INVALID_ENUM");
    EXPECT_EQ(json["states"][0]["runs"][0]["picture"]["differing_share"], 0.25);
    EXPECT_EQ(json["states"][0]["axes"]["geometry"], "large");
    EXPECT_EQ(json["contenders"][0]["populations"][0]["summaries"].back()["geometric_mean"], 2);
    EXPECT_EQ(json["contenders"][0]["populations"][0]["slow"]["states"], 1);
}

class ReportParts : public testing::Test {
  protected:
    ReportParts() : m_path(testing::TempDir() + "parts-" + std::to_string(getpid()) + ".json") {}
    ~ReportParts() override { std::remove(m_path.c_str()); }

    std::vector<ReportPart> load(const std::string& text) {
        std::ofstream(m_path) << text;
        return load_parts(m_path);
    }

  private:
    std::string m_path;
};

TEST_F(ReportParts, RatiosAreMediansOfTheLastByTheOthers) {
    const std::vector<ReportPart> parts = load(
        R"([{"title": "Traces", "about": "a", "contenders": ["ours", "theirs"], "rows": [
             {"name": "one", "times": {"ours": [2, 1, 4], "theirs": [6]}},
             {"name": "two", "times": {"ours": [3], "theirs": [1, 2]}, "note": "n"},
             {"name": "lost", "times": {"ours": [], "theirs": [1]}}]},
            {"title": "MuJoCo", "about": "b", "contenders": ["ours", "theirs"], "rows": [], "problem": "no"}])");
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].rows[0].ratio(0), 3);
    EXPECT_EQ(parts[0].rows[1].ratio(0), 0.5);
    EXPECT_EQ(parts[0].rows[2].ratio(0), 0);
    const StateSummary summary = summary_of(parts[0], 0);
    EXPECT_EQ(summary.count, 2);
    EXPECT_EQ(summary.slower(), 1);
    EXPECT_EQ(summary.worst, 0.5);
    EXPECT_EQ(slowest(parts[0], 0).front()->name, "two");
    EXPECT_EQ(parts[1].problem, "no");
    EXPECT_EQ(to_json(parts)[0]["rows"][0]["runs"][0]["ratio"], 3);
    EXPECT_EQ(to_json(parts)[0]["summaries"][0]["slower"], 1);
}

TEST_F(ReportParts, WhatIsNoPartIsRefusedInWords) {
    EXPECT_THROW(load_parts("/no/such/file"), std::runtime_error);
    EXPECT_THROW(load("["), std::runtime_error);
    EXPECT_THROW(load(R"([{"title": 3}])"), std::runtime_error);
    EXPECT_THROW(
        load(R"([{"title": "a", "about": "", "contenders": ["x"], "rows": [{"name": "r", "times": {}}]}])"),
        std::runtime_error);
}

}  // namespace
}  // namespace terrazzo::bench
