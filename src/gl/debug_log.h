// The debug log: TERRAZZO_DEBUG=1 writes to stderr which command broke which rule. Off, a call costs one
// test.
#pragma once

namespace terrazzo::gl {

bool debug_enabled();

// Writes "terrazzo: glFoo: message" when the log is on.
void debug_log(const char* command, const char* message);

}  // namespace terrazzo::gl
