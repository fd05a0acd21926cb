// Memory that runs out. The program's malloc, its siblings and mmap, which are everybody's in the process,
// let allocations of one library fail when a test says so; all others, of the C++ runtime, Xlib or the test,
// succeed.
#pragma once

namespace terrazzo::test {

// Chooses the library, which is loaded, by a part of its file's real path. False if there is none of it.
bool watch_library(const char* path_part);

inline constexpr long kAllBehind = -1;

// From now on the library's allocations count, from 0; number `first` fails and, of those behind it, so many
// that `count` fail altogether.
void fail_allocations(long first, long count);

// Like memory that never runs out.
inline void count_allocations() {
    fail_allocations(0, 0);
}

struct Allocations {
    long asked = 0, failed = 0;
};

// What has happened since.
Allocations allocations();

// From now on all succeed, and none count; returns what has happened.
Allocations stop_failing();

}  // namespace terrazzo::test
