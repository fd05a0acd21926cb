// Stage: test and measuring tools, work done in a child process.
// Input: an executable of ours, the name of a task it serves, JSON arguments, environment. Output: the task's
// JSON result (pictures as its binary values), or how the child failed. Invariant: a child that crashes,
// exits early or outlives its time is a report, never a hang or an exception.
#pragma once

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace terrazzo::kit {

struct ChildRequest {
    std::string executable;  // empty: the running one
    std::string task;
    nlohmann::json arguments;
    std::vector<std::pair<std::string, std::string>> environment;  // set on top of the caller's
    std::chrono::milliseconds timeout{60000};
};

struct ChildReport {
    enum class Status { kFinished, kRefused, kCrashed, kTimedOut };
    Status status = Status::kRefused;
    int code = 0;           // exit status or signal number
    std::string message;    // what went wrong, for people
    std::string output;     // what the child printed
    nlohmann::json result;  // only when finished

    bool finished() const { return status == Status::kFinished; }
};

// Blocks until the child is gone. Safe to call from several threads.
ChildReport run_in_child(const ChildRequest& request);

// Child side. A task gets its arguments and returns its result; an exception becomes a kRefused report.
using ChildTask = std::function<nlohmann::json(const nlohmann::json& arguments)>;
struct NamedTask {
    const char* name;
    ChildTask task;
};
// True when the command line asks for a task: then the task has run and *exit_code is to be returned from
// main.
bool serve_child(int argc, char** argv, const std::vector<NamedTask>& tasks, int* exit_code);

// Seconds since run_in_child() started this process; child side only.
double seconds_since_start();
// The highest resident set of this process so far, in KiB. Not from rusage: that counts the parent's pages at
// fork.
long peak_resident_kib();

}  // namespace terrazzo::kit
