// Starting and ending child processes. The parent waits on a pidfd.
#include "spawn.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <string_view>

extern char** environ;

namespace terrazzo::kit {
namespace {

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

}  // namespace

pid_t spawn_child(const ChildRequest& request, int result, int output) {
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
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, result, kResultDescriptor);
    pid_t pid = -1;
    const int error = posix_spawn(&pid, executable.c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? pid : -1;
}

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

MemoryFile::MemoryFile(const char* name) : m_descriptor(memfd_create(name, MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
    if (m_descriptor >= 0) close(m_descriptor);
}

std::vector<std::uint8_t> MemoryFile::contents() const {
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

long long monotonic_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

}  // namespace terrazzo::kit
