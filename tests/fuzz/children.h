// Child processes that run episodes, and what they tell while they do.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace terrazzo::fuzz {

// In memory that parent and child share.
struct Report {
    std::atomic<std::uint64_t> seed{0};   // of the episode that runs
    std::atomic<std::uint64_t> calls{0};  // of the episodes that are done
};

// Maps the report that a file descriptor names.
Report& map_report(int descriptor);

struct Outcome {
    bool failed = false;
    std::string kind;    // what sort of failure: the line that names it
    std::string output;  // all that the child wrote
};

// This program once more, with these arguments.
class Child {
  public:
    explicit Child(std::vector<std::string> arguments);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Waits for it, at most so many milliseconds; whether it has ended.
    bool wait(int milliseconds);
    // Ends it.
    void stop();
    // After it has ended.
    Outcome outcome() const;
    Report& report() { return *m_report; }

  private:
    int m_process = -1, m_output = -1, m_status = 0;
    bool m_ended = false, m_stopped = false;
    Report* m_report;
};

}  // namespace terrazzo::fuzz
