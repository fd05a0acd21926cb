// The beat that swaps can be bound to, for displays that show what they get at once.
//
// Counts as OML_sync_control has them: UST is microseconds of the monotonic clock, MSC the refreshes since
// its beginning. Every thread of every process sees the same counts.
#pragma once

#include <cstdint>

namespace terrazzo::window {

inline constexpr int kRefreshRate = 60;  // a second

std::int64_t current_ust();
std::int64_t msc_at(std::int64_t ust);

// Sleeps until the counter has reached `target`, or, if it has already, until it is `remainder` modulo
// `divisor` (GLX_OML_sync_control: glXWaitForMscOML). 0 stands for no divisor. Returns the count at the end.
std::int64_t wait_for_msc(std::int64_t target, std::int64_t divisor, std::int64_t remainder);

}  // namespace terrazzo::window
