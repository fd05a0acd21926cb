// Stage: test and measuring tools, a child process that is asked many things.
// Input: a task that answers questions, questions as JSON. Output: a report a question, like those of
// child.h. Invariant: a child that crashes, exits or does not answer in time is a report; it is gone then,
// and so says every further question.
#pragma once

#include <sys/types.h>

#include <memory>

#include "child.h"

namespace terrazzo::kit {

class MemoryFile;

class Dialogue {
  public:
    // request.timeout is that of an answer.
    explicit Dialogue(const ChildRequest& request);
    ~Dialogue();
    Dialogue(const Dialogue&) = delete;
    Dialogue& operator=(const Dialogue&) = delete;

    ChildReport ask(const nlohmann::json& question);
    // Lets the child end, and says what it printed.
    std::string finish();
    // False when there is nobody to ask any more.
    bool is_open() const { return m_socket >= 0; }

  private:
    ChildReport end(bool in_time);

    std::chrono::milliseconds m_timeout;
    std::unique_ptr<MemoryFile> m_output;
    int m_socket = -1;
    pid_t m_pid = -1;
};

// Child side, within a task: answers until nobody asks any more. What `answer` throws becomes a kRefused
// report of that question.
void answer_questions(const ChildTask& answer);

}  // namespace terrazzo::kit
