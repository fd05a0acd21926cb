// Starts and reads child processes; see children.h.
#include "fuzz/children.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string_view>

namespace terrazzo::fuzz {
namespace {

int shared_file(const char* name, off_t size) {
    const int file = memfd_create(name, 0);
    if (file >= 0 && ftruncate(file, size) == 0) return file;
    std::perror("fuzz: memfd_create");
    std::exit(2);
}

// The first line that a sanitizer or the fuzzer itself names a failure with.
std::string kind_of(std::string_view output, int status) {
    for (const std::string_view mark : {"SUMMARY: ", "fuzz: ", "runtime error: "}) {
        const auto at = output.find(mark);
        if (at == std::string_view::npos) continue;
        return std::string(output.substr(at, output.find('\n', at) - at));
    }
    return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Report& map_report(int descriptor) {
    void* const memory = mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) std::perror("fuzz: mmap"), std::exit(2);
    return *static_cast<Report*>(memory);
}

Child::Child(std::vector<std::string> arguments) : m_output(shared_file("output", 0)) {
    const int report = shared_file("report", sizeof(Report));
    m_report = new (&map_report(report)) Report;
    arguments.insert(arguments.begin(), "fuzz");
    arguments.insert(arguments.end(), {"--report", std::to_string(report)});
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    m_process = fork();
    if (m_process == 0) {
        dup2(m_output, STDERR_FILENO);
        dup2(m_output, STDOUT_FILENO);
        execv("/proc/self/exe", pointers.data());
        _exit(127);
    }
    close(report);
}

Child::~Child() {
    stop();
    close(m_output);
    munmap(m_report, sizeof(Report));
}

bool Child::wait(int milliseconds) {
    constexpr int kStep = 5;
    for (int waited = 0; !m_ended; waited += kStep) {
        m_ended = waitpid(m_process, &m_status, WNOHANG) == m_process;
        if (m_ended || waited >= milliseconds) break;
        const timespec step{0, kStep * 1000000};
        nanosleep(&step, nullptr);
    }
    return m_ended;
}

void Child::stop() {
    if (wait(0)) return;
    m_stopped = true;
    kill(m_process, SIGKILL);
    waitpid(m_process, &m_status, 0);
    m_ended = true;
}

Outcome Child::outcome() const {
    Outcome out;
    const off_t size = lseek(m_output, 0, SEEK_END);
    out.output.resize(static_cast<std::size_t>(size));
    if (pread(m_output, out.output.data(), out.output.size(), 0) != size) out.output.clear();
    out.failed = !m_stopped && !(WIFEXITED(m_status) && WEXITSTATUS(m_status) == 0);
    if (out.failed) out.kind = kind_of(out.output, m_status);
    return out;
}

}  // namespace terrazzo::fuzz
