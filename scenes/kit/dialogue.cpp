// A socket pair in the place of the result file. A message is its length in eight bytes and CBOR.
#include "dialogue.h"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>

#include "spawn.h"

namespace terrazzo::kit {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Length = std::uint64_t;
// How long a child may take to end by itself.
constexpr std::chrono::milliseconds kFarewell{2000};
// More than any picture; a child's nonsense must not become an allocation.
constexpr Length kLongest = Length{1} << 31;

// A peer that is gone is an error here, not a signal.
bool send_all(int socket, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    while (size > 0) {
        const ssize_t count = send(socket, bytes, size, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool send_message(int socket, const nlohmann::json& message) {
    const Bytes bytes = nlohmann::json::to_cbor(message);
    const Length length = bytes.size();
    return send_all(socket, &length, sizeof length) && send_all(socket, bytes.data(), bytes.size());
}

// `end`: monotonic nanoseconds. False when the peer is gone or, then !in_time, slow.
bool receive_all(int socket, void* data, std::size_t size, long long end, bool& in_time) {
    auto* bytes = static_cast<std::uint8_t*>(data);
    while (size > 0) {
        pollfd watched{socket, POLLIN, 0};
        const long long left = std::max(end - monotonic_nanoseconds(), 0LL) / 1'000'000;
        const int wait = static_cast<int>(std::min<long long>(left, std::numeric_limits<int>::max()));
        const int ready = poll(&watched, 1, wait);
        if (ready < 0 && errno == EINTR) continue;
        in_time = ready != 0;
        if (ready <= 0) return false;
        const ssize_t count = recv(socket, bytes, size, 0);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool receive_message(int socket, Bytes& bytes, long long end, bool& in_time) {
    Length length = 0;
    if (!receive_all(socket, &length, sizeof length, end, in_time) || length > kLongest) return false;
    bytes.resize(static_cast<std::size_t>(length));
    return receive_all(socket, bytes.data(), bytes.size(), end, in_time);
}

nlohmann::json answer_to(const ChildTask& answer, const Bytes& question) {
    try {
        return {{"result", answer(nlohmann::json::from_cbor(question))}};
    } catch (const std::bad_alloc&) {
        return {{"refused", "there is not enough memory"}};
    } catch (const std::exception& failure) {
        return {{"refused", failure.what()}};
    }
}

ChildReport report_of(const Bytes& bytes) {
    ChildReport report;
    nlohmann::json answer = nlohmann::json::from_cbor(bytes, true, false);
    if (answer.is_object() && answer.contains("result")) {
        report.status = ChildReport::Status::kFinished;
        report.result = std::move(answer["result"]);
    } else if (answer.is_object() && answer.contains("refused")) {
        report.message = answer["refused"].get<std::string>();
    } else {
        report.message = "the child's answer makes no sense";
    }
    return report;
}

}  // namespace

Dialogue::Dialogue(const ChildRequest& request)
    : m_timeout(request.timeout), m_output(std::make_unique<MemoryFile>("terrazzo-output")) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return;
    m_pid = spawn_child(request, ends[1], m_output->descriptor());
    close(ends[1]);
    if (m_pid < 0)
        close(ends[0]);
    else
        m_socket = ends[0];
}

Dialogue::~Dialogue() {
    finish();
}

std::string Dialogue::finish() {
    if (!is_open()) return "";
    shutdown(m_socket, SHUT_WR);
    return end(wait_within(m_pid, kFarewell)).output;
}

ChildReport Dialogue::ask(const nlohmann::json& question) {
    if (!is_open()) {
        ChildReport report;
        report.message = "there is no child to ask";
        return report;
    }
    bool in_time = true;
    Bytes bytes;
    const long long end_of_wait =
        monotonic_nanoseconds() + std::chrono::duration_cast<std::chrono::nanoseconds>(m_timeout).count();
    if (send_message(m_socket, question) && receive_message(m_socket, bytes, end_of_wait, in_time))
        return report_of(bytes);
    // A child that closed its end is about to end.
    const bool ended = in_time && wait_within(m_pid, kFarewell);
    if (!in_time) kill(m_pid, SIGKILL);
    return end(ended);
}

ChildReport Dialogue::end(bool in_time) {
    ChildReport report;
    int status = 0;
    while (waitpid(m_pid, &status, 0) < 0 && errno == EINTR) {
    }
    close(m_socket);
    m_socket = -1;
    const Bytes printed = m_output->contents();
    report.output.assign(printed.begin(), printed.end());
    if (!in_time) {
        report.status = ChildReport::Status::kTimedOut;
        report.message = "the child did not answer in time";
        return report;
    }
    report.status = ChildReport::Status::kCrashed;
    report.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    report.message = WIFSIGNALED(status) ? std::string("the child was ended by ") + strsignal(report.code)
                                         : "the child exited with status " + std::to_string(report.code);
    return report;
}

void answer_questions(const ChildTask& answer) {
    Bytes question;
    bool in_time = true;
    while (receive_message(kResultDescriptor, question, std::numeric_limits<long long>::max(), in_time))
        if (!send_message(kResultDescriptor, answer_to(answer, question))) return;
}

}  // namespace terrazzo::kit
