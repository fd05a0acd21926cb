// Stage: test and measuring tools, work done in a child process.
// The result comes back as CBOR through a memory file, the child's output through another: neither can fill
// up and block as a pipe would. The parent waits on a pidfd, so a limit in time needs no signal handler.
#include "child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <new>

extern char** environ;

namespace terrazzo::kit {
namespace {

// argv of a child: program, this marker, result descriptor, start time in ns, task, arguments.
constexpr const char* kChildMarker = "--terrazzo-child";
constexpr int kChildArguments = 6;
// The child's result descriptor; above the standard three and fixed, so that posix_spawn can place it.
constexpr int kResultDescriptor = 3;

long long s_start_nanoseconds = 0;

long long monotonic_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

class MemoryFile {
  public:
    explicit MemoryFile(const char* name) : m_descriptor(memfd_create(name, MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (m_descriptor >= 0) close(m_descriptor);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return m_descriptor; }
    std::vector<std::uint8_t> contents() const {
        struct stat status {};
        if (fstat(m_descriptor, &status) != 0 || status.st_size <= 0) return {};
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count =
                pread(m_descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
            if (count <= 0) break;
            done += static_cast<std::size_t>(count);
        }
        bytes.resize(done);
        return bytes;
    }

  private:
    int m_descriptor;
};

std::string running_executable() {
    char path[4096];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : std::string();
}

std::vector<std::string> merged_environment(const ChildRequest& request) {
    std::vector<std::string> merged;
    for (const auto& [name, value] : request.environment) merged.push_back(name + "=" + value);
    for (char** entry = environ; *entry; ++entry) {
        const std::string_view text(*entry);
        const std::string_view name = text.substr(0, text.find('='));
        bool replaced = false;
        for (const auto& change : request.environment) replaced |= change.first == name;
        if (!replaced) merged.emplace_back(text);
    }
    return merged;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& string : strings) result.push_back(string.data());
    result.push_back(nullptr);
    return result;
}

// Returns the child's pid, or -1 with errno set.
pid_t spawn(const ChildRequest& request, const MemoryFile& result, const MemoryFile& output) {
    const std::string executable = request.executable.empty() ? running_executable() : request.executable;
    std::vector<std::string> arguments{executable,
                                       kChildMarker,
                                       std::to_string(kResultDescriptor),
                                       std::to_string(monotonic_nanoseconds()),
                                       request.task,
                                       request.arguments.dump()};
    std::vector<std::string> environment = merged_environment(request);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, result.descriptor(), kResultDescriptor);
    pid_t pid = -1;
    const int error = posix_spawn(&pid, executable.c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? pid : -1;
}

// True when the child ended within its time; otherwise it is killed.
bool wait_within(pid_t pid, std::chrono::milliseconds timeout) {
    const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
    pollfd watched{descriptor, POLLIN, 0};
    const long long end = monotonic_nanoseconds() + timeout.count() * 1'000'000LL;
    int ready = 0;
    do {
        const long long left = (end - monotonic_nanoseconds()) / 1'000'000LL;
        ready = poll(&watched, 1, static_cast<int>(left > 0 ? left : 0));
    } while (ready < 0 && errno == EINTR);
    if (ready <= 0) kill(pid, SIGKILL);
    if (descriptor >= 0) close(descriptor);
    return ready > 0;
}

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
    const pid_t pid = spawn(request, result, output);
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
