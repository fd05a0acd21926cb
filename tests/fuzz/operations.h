// What one index of an episode stands for: a call of any command, or a few that make sense together.
// Invariant: an operation's choices come from its random numbers alone.
#pragma once

#include "fuzz/session.h"
#include "fuzz/window_system.h"

namespace terrazzo::fuzz {

void run_operation(Session& session, WindowSystem& windows, Random& random);

}  // namespace terrazzo::fuzz
