// Stage: child side of `terrazzo bench small`: draws small frames with one library.
// Input: JSON {library}, then questions: {open: a frame's name}, {measure: seconds}. Output: to open
// {renderer, errors, steady, picture (the bytes that were read)}, to measure {frames, wall_seconds,
// cpu_seconds} of all frames, which take at least as much processor time as asked for. Invariant: each frame
// has a context of its own and was drawn twice before it is measured.
#pragma once

#include <nlohmann/json.hpp>

namespace terrazzo::small_frames {

nlohmann::json small_task(const nlohmann::json& arguments);

}  // namespace terrazzo::small_frames
