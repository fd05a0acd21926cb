// Stage: child side of `terrazzo bench states`: draws states one after another with one library.
// Input: JSON {library}, then questions: {open: state's text, width, height}, {measure: seconds}, {close:
// true}. Output: to open {renderer, errors, steady, colour (the client's buffer)}, to measure {frames,
// wall_seconds, cpu_seconds} of all frames, which take at least as much processor time as asked for: a busy
// machine's clock goes on while we do not. Invariant: each state has a context of its own and has drawn two
// frames before it is measured; every frame ends with glFinish.
#pragma once

#include <nlohmann/json.hpp>

namespace terrazzo::states {

nlohmann::json state_task(const nlohmann::json& arguments);

}  // namespace terrazzo::states
