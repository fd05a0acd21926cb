// See refresh.h.
#include "frontends/window/refresh.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace terrazzo::window {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr std::int64_t kMicroseconds = 1'000'000;

}  // namespace

std::int64_t current_ust() {
    return std::chrono::duration_cast<microseconds>(Clock::now().time_since_epoch()).count();
}

std::int64_t msc_at(std::int64_t ust) {
    return ust / kMicroseconds * kRefreshRate + ust % kMicroseconds * kRefreshRate / kMicroseconds;
}

std::int64_t wait_for_msc(std::int64_t target, std::int64_t divisor, std::int64_t remainder) {
    const std::int64_t now = msc_at(current_ust());
    if (now >= target) {
        if (divisor <= 0) return now;
        target = now - now % divisor + remainder;
        if (target < now) target += divisor;
    }
    target = std::min(target, std::numeric_limits<std::int64_t>::max() / kMicroseconds);
    if (target > now) {
        // The first microsecond of that refresh.
        const std::int64_t ust = target / kRefreshRate * kMicroseconds +
                                 (target % kRefreshRate * kMicroseconds + kRefreshRate - 1) / kRefreshRate;
        std::this_thread::sleep_until(Clock::time_point(microseconds(ust)));
    }
    return target;
}

}  // namespace terrazzo::window
