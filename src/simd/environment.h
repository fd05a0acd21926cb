// The one door to the environment: settings that users give by variables, TERRAZZO_THREADS and its like.
//
// A program that runs with rights its caller does not have (set-user-ID, set-group-ID, file capabilities)
// takes none: its caller must not choose what it connects to, writes or uses. The test `rooms` sees that
// nothing else asks the environment.
#pragma once

namespace terrazzo {

// The variable's value; null where it is not set and in programs with others' rights.
const char* setting(const char* name);

// What TERRAZZO_DEBUG asks to be told on standard error: words between commas. "stages" is one of them; any
// other but "0" means errors.
struct DebugWishes {
    bool errors = false;
    bool stages = false;
};
DebugWishes parse_debug_wishes(const char* text);  // null: none
// Those of this process, asked for once.
const DebugWishes& debug_wishes();

}  // namespace terrazzo
