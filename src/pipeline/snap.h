// Window coordinates of points and lines in 8-bit sub-pixels: halves go away from zero, and the sum that
// rounds is itself rounded to float, unlike the snapping of triangles (doc/reference.md §3.2, "Lines").
#pragma once

#include <cmath>
#include <cstdint>

namespace terrazzo::pipeline {

// Window coordinates reach 2^16 at most: a viewport of 2^14 pixels whose origin is within 2^15.
inline bool is_window_coordinate(float v) {
    return std::fabs(v) <= 65536.0f;
}  // false for NaN

// For a window coordinate, or a size, in pixels.
inline int32_t snap_away(float v) {
    const float scaled = 256.0f * v;
    return static_cast<int32_t>(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
}

}  // namespace terrazzo::pipeline
