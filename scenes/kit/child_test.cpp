// Children that answer, refuse, crash, exit, print and never end: each is a report. The test program is its
// own child.
#include "child.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "shared_bytes.h"

namespace terrazzo::kit {
namespace {

using Status = ChildReport::Status;

const std::vector<NamedTask> kTasks{
    {"echo", [](const nlohmann::json& arguments) { return arguments; }},
    {"environment", [](const nlohmann::json&) -> nlohmann::json { return std::getenv("TERRAZZO_TEST"); }},
    {"time", [](const nlohmann::json&) -> nlohmann::json { return seconds_since_start(); }},
    {"memory", [](const nlohmann::json&) -> nlohmann::json { return peak_resident_kib(); }},
    {"large",
     [](const nlohmann::json&) -> nlohmann::json {
         return nlohmann::json::binary(std::vector<std::uint8_t>(9'000'000, 7));
     }},
    {"refuse", [](const nlohmann::json&) -> nlohmann::json { throw std::runtime_error("not today"); }},
    {"crash", [](const nlohmann::json&) -> nlohmann::json { return std::raise(SIGSEGV); }},
    {"exit", [](const nlohmann::json&) -> nlohmann::json { std::_Exit(7); }},
    {"print",
     [](const nlohmann::json&) -> nlohmann::json {
         for (int i = 0; i < 30000; ++i) std::fputs("0123456789", stdout);  // more than a pipe holds
         return 1;
     }},
    {"sleep",
     [](const nlohmann::json&) -> nlohmann::json {
         std::this_thread::sleep_for(std::chrono::hours(1));
         return 1;
     }},
    {"read", [](const nlohmann::json& arguments) -> nlohmann::json {
         return read_bytes(arguments.get<std::string>());
     }}};

ChildReport run(const char* task, nlohmann::json arguments = nlohmann::json::object()) {
    return run_in_child(
        {.executable = "", .task = task, .arguments = std::move(arguments), .environment = {}});
}

TEST(Child, AnswersWithItsArguments) {
    const nlohmann::json arguments{{"text", "a \"quoted\" word"}, {"list", {1, 2.5, true}}};
    const ChildReport report = run("echo", arguments);
    ASSERT_TRUE(report.finished()) << report.message;
    EXPECT_EQ(report.result, arguments);
}

TEST(Child, LargeResultsArriveWhole) {
    const ChildReport report = run("large");
    ASSERT_TRUE(report.finished());
    EXPECT_EQ(report.result.get_binary().size(), 9'000'000U);
}

TEST(Child, OutputIsKeptAndBlocksNobody) {
    const ChildReport report = run("print");
    ASSERT_TRUE(report.finished());
    EXPECT_EQ(report.output.size(), 300000U);
}

TEST(Child, EnvironmentIsSetOnTop) {
    setenv("TERRAZZO_TEST", "parent", 1);
    EXPECT_EQ(run("environment").result, "parent");
    const ChildReport report = run_in_child({.executable = "",
                                             .task = "environment",
                                             .arguments = {},
                                             .environment = {{"TERRAZZO_TEST", "child"}}});
    EXPECT_EQ(report.result, "child");
}

TEST(Child, RefusalsCrashesAndExitsAreReports) {
    EXPECT_EQ(run("refuse").status, Status::kRefused);
    EXPECT_EQ(run("refuse").message, "not today");
    EXPECT_EQ(run("no such task").status, Status::kRefused);
    EXPECT_EQ(run("crash").status, Status::kCrashed);
    EXPECT_EQ(run("crash").code, SIGSEGV);
    EXPECT_EQ(run("exit").status, Status::kCrashed);
    EXPECT_EQ(run("exit").code, 7);
}

TEST(Child, AMissingProgramIsAReport) {
    const ChildReport report =
        run_in_child({.executable = "/no/such/program", .task = "echo", .arguments = {}, .environment = {}});
    EXPECT_EQ(report.status, Status::kRefused);
}

TEST(Child, OneThatNeverEndsIsEnded) {
    const ChildReport report = run_in_child({.executable = "",
                                             .task = "sleep",
                                             .arguments = {},
                                             .environment = {},
                                             .timeout = std::chrono::milliseconds(200)});
    EXPECT_EQ(report.status, Status::kTimedOut);
}

TEST(Child, TimeAndMemoryAreItsOwn) {
    const double seconds = run("time").result.get<double>();
    EXPECT_GT(seconds, 0);
    EXPECT_LT(seconds, 60);
    // The parent's own pages must not count as the child's.
    const std::vector<char> ballast(std::size_t{200} << 20, 1);
    EXPECT_LT(run("memory").result.get<long>(), 100L << 10);
    EXPECT_EQ(ballast.back(), 1);
}

TEST(Child, SharedBytesAreReadByName) {
    const std::vector<std::uint8_t> bytes{1, 2, 3, 250};
    const SharedBytes shared(bytes);
    EXPECT_EQ(run("read", shared.path()).result.get<std::vector<std::uint8_t>>(), bytes);
}

}  // namespace
}  // namespace terrazzo::kit

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, terrazzo::kit::kTasks, &exit_code)) return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
