// Window coordinates to 8-bit sub-pixels, the reference's two ways (doc/reference.md §3).
#pragma once

#include <cmath>
#include <cstdint>

namespace terrazzo::pipeline {

// Window coordinates reach 2^16 at most: a viewport of 2^14 pixels whose origin is within 2^15. False for
// NaN.
inline bool is_window_coordinate(float v) {
    return std::fabs(v) <= 65536.0f;
}

// Triangles: pixel centres, or corners where the origin is 0, lie at multiples of 256, halves go to even.
// Coordinates that no window has go to a far end.
inline int32_t snap_even(float window, float origin) {
    constexpr float kLimit = 16777216.0f;
    const float scaled = (window - origin) * 256.0f;
    return scaled > -kLimit ? static_cast<int32_t>(std::lrintf(scaled < kLimit ? scaled : kLimit))
                            : static_cast<int32_t>(-kLimit);
}

// Points and lines: halves go away from zero, after a sum that is rounded itself. For window coordinates and
// sizes.
inline int32_t snap_away(float pixels) {
    const float scaled = 256.0f * pixels;
    return static_cast<int32_t>(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
}

}  // namespace terrazzo::pipeline
