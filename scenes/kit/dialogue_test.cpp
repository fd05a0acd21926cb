// Children that are asked many things, and those that refuse, crash, or do not answer in time.
#include "dialogue.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace terrazzo::kit {
namespace {

using Status = ChildReport::Status;

nlohmann::json answer(const nlohmann::json& question, int& asked) {
    ++asked;
    if (question == "crash") return std::raise(SIGSEGV);
    if (question == "exit") std::_Exit(7);
    if (question == "refuse") throw std::runtime_error("not today");
    if (question == "sleep") std::this_thread::sleep_for(std::chrono::hours(1));
    if (question == "print") std::puts("hello");
    if (question == "large") return nlohmann::json::binary(std::vector<std::uint8_t>(9'000'000, 7));
    return asked;
}

const std::vector<NamedTask> kTasks{
    {"talk", [](const nlohmann::json&) -> nlohmann::json {
         int asked = 0;
         answer_questions([&](const nlohmann::json& question) { return answer(question, asked); });
         return nullptr;
     }}};

ChildRequest request(std::chrono::milliseconds timeout = std::chrono::seconds(60)) {
    return {.executable = "", .task = "talk", .arguments = nullptr, .environment = {}, .timeout = timeout};
}

TEST(Dialogue, OneProcessAnswersEveryQuestion) {
    Dialogue dialogue(request());
    for (int i = 1; i < 5; ++i) EXPECT_EQ(dialogue.ask("again").result, i);
    EXPECT_TRUE(dialogue.is_open());
}

TEST(Dialogue, SeveralAreAskedInTurn) {
    Dialogue first(request()), second(request());
    for (int i = 1; i < 4; ++i) {
        EXPECT_EQ(first.ask("").result, i);
        EXPECT_EQ(second.ask("").result, i);
    }
}

TEST(Dialogue, LargeAnswersArriveWhole) {
    Dialogue dialogue(request());
    EXPECT_EQ(dialogue.ask("large").result.get_binary().size(), 9'000'000U);
    EXPECT_EQ(dialogue.ask("").result, 2);
}

TEST(Dialogue, ARefusalEndsNothing) {
    Dialogue dialogue(request());
    const ChildReport report = dialogue.ask("refuse");
    EXPECT_EQ(report.status, Status::kRefused);
    EXPECT_EQ(report.message, "not today");
    EXPECT_EQ(dialogue.ask("").result, 2);
}

TEST(Dialogue, CrashesAndExitsAreReports) {
    Dialogue crashing(request());
    const ChildReport crash = crashing.ask("crash");
    EXPECT_EQ(crash.status, Status::kCrashed);
    EXPECT_EQ(crash.code, SIGSEGV);
    EXPECT_FALSE(crashing.is_open());
    EXPECT_EQ(crashing.ask("").status, Status::kRefused);
    Dialogue exiting(request());
    EXPECT_EQ(exiting.ask("exit").code, 7);
}

TEST(Dialogue, OneThatDoesNotAnswerIsEnded) {
    Dialogue dialogue(request(std::chrono::milliseconds(200)));
    EXPECT_EQ(dialogue.ask("sleep").status, Status::kTimedOut);
    EXPECT_FALSE(dialogue.is_open());
}

TEST(Dialogue, WhatAChildPrintedIsThereWhenItHasEnded) {
    Dialogue dialogue(request());
    EXPECT_EQ(dialogue.ask("print").result, 1);
    EXPECT_EQ(dialogue.finish(), "hello\n");
    EXPECT_FALSE(dialogue.is_open());
    EXPECT_EQ(dialogue.finish(), "");
}

TEST(Dialogue, AMissingProgramIsAReport) {
    ChildRequest missing = request();
    missing.executable = "/no/such/program";
    Dialogue dialogue(missing);
    EXPECT_FALSE(dialogue.is_open());
    EXPECT_EQ(dialogue.ask("").status, Status::kRefused);
}

}  // namespace
}  // namespace terrazzo::kit

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv, terrazzo::kit::kTasks, &exit_code)) return exit_code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
