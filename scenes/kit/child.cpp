// Stage: test and measuring tools, work done in a child process.
// The result comes back as CBOR through a memory file, the child's output through another: neither can fill
// up and block as a pipe would. The parent waits on a pidfd, so a limit in time needs no signal handler.
#include "child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>

#include "spawn.h"

namespace terrazzo::kit {
namespace {

long long s_start_nanoseconds = 0;

void describe_end(int wait_status, bool in_time, const MemoryFile& result, ChildReport& report) {
    if (!in_time) {
        report.status = ChildReport::Status::kTimedOut;
        report.message = "the child did not end in time";
        return;
    }
    if (WIFSIGNALED(wait_status)) {
        report.status = ChildReport::Status::kCrashed;
        report.code = WTERMSIG(wait_status);
        report.message = std::string("the child was ended by ") + strsignal(report.code);
        return;
    }
    report.code = WEXITSTATUS(wait_status);
    nlohmann::json answer = nlohmann::json::from_cbor(result.contents(), true, false);
    if (answer.is_discarded() || !answer.is_object()) {
        report.status = ChildReport::Status::kCrashed;
        report.message = "the child exited with status " + std::to_string(report.code) + " and no result";
    } else if (answer.contains("refused")) {
        report.message = answer["refused"].get<std::string>();
    } else {
        report.status = ChildReport::Status::kFinished;
        report.result = std::move(answer["result"]);
    }
}

void write_answer(int descriptor, const nlohmann::json& answer) {
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(answer);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
        if (count <= 0) return;
        done += static_cast<std::size_t>(count);
    }
}

nlohmann::json answer_of(const std::vector<NamedTask>& tasks, const char* name, const char* arguments) {
    for (const NamedTask& task : tasks) {
        if (std::strcmp(task.name, name) != 0) continue;
        try {
            return {{"result", task.task(nlohmann::json::parse(arguments))}};
        } catch (const std::bad_alloc&) {
            return {{"refused", "there is not enough memory"}};
        } catch (const std::exception& failure) {
            return {{"refused", failure.what()}};
        }
    }
    return {{"refused", std::string("no task is called ") + name}};
}

}  // namespace

ChildReport run_in_child(const ChildRequest& request) {
    ChildReport report;
    const MemoryFile result("terrazzo-result");
    const MemoryFile output("terrazzo-output");
    const pid_t pid = spawn_child(request, result.descriptor(), output.descriptor());
    if (pid < 0) {
        report.message = std::string("the child could not be started: ") + std::strerror(errno);
        return report;
    }
    const bool in_time = wait_within(pid, request.timeout);
    int wait_status = 0;
    while (waitpid(pid, &wait_status, 0) < 0 && errno == EINTR) {
    }
    describe_end(wait_status, in_time, result, report);
    const std::vector<std::uint8_t> printed = output.contents();
    report.output.assign(printed.begin(), printed.end());
    return report;
}

bool serve_child(int argc, char** argv, const std::vector<NamedTask>& tasks, int* exit_code) {
    if (argc != kChildArguments || std::strcmp(argv[1], kChildMarker) != 0) return false;
    // A crash is an expected report here; nobody wants its core file.
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int descriptor = std::atoi(argv[2]);
    s_start_nanoseconds = std::atoll(argv[3]);
    const nlohmann::json answer = answer_of(tasks, argv[4], argv[5]);
    write_answer(descriptor, answer);
    std::fflush(nullptr);
    *exit_code = answer.contains("refused") ? 1 : 0;
    return true;
}

double seconds_since_start() {
    return static_cast<double>(monotonic_nanoseconds() - s_start_nanoseconds) * 1e-9;
}

long peak_resident_kib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) return std::atol(line.c_str() + 6);
    return 0;
}

}  // namespace terrazzo::kit
