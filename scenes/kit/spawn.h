// Stage: test and measuring tools, starting and ending the processes that work is done in.
// Input: a request, descriptors. Output: a process id. Invariant: the child's descriptors are the standard
// three and the one that its answer goes to; no signal handler is needed to limit its time.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <vector>

#include "child.h"

namespace terrazzo::kit {

// argv of a child: program, this marker, result descriptor, start time in ns, task, arguments.
inline constexpr const char* kChildMarker = "--terrazzo-child";
inline constexpr int kChildArguments = 6;
// The child's result descriptor; above the standard three and fixed, so that posix_spawn can place it.
inline constexpr int kResultDescriptor = 3;

// Takes any amount; a pipe would fill up and block.
class MemoryFile {
  public:
    explicit MemoryFile(const char* name);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return m_descriptor; }
    std::vector<std::uint8_t> contents() const;

  private:
    int m_descriptor;
};

// The child answers to `result`, prints to `output`. Returns its pid, or -1 with errno set.
pid_t spawn_child(const ChildRequest& request, int result, int output);
// True when the child ended within its time; otherwise it is killed. Either way it is still to be waited for.
bool wait_within(pid_t pid, std::chrono::milliseconds timeout);

long long monotonic_nanoseconds();

}  // namespace terrazzo::kit
