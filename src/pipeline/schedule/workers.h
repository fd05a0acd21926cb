// Threads that draw bins. One pool serves the process; its threads sleep while there is nothing to draw.
//
// TERRAZZO_THREADS says how many threads draw a frame, the calling one among them: by default one per core, 0
// or 1 for the calling thread alone. A pool that cannot start a thread makes do with those it has.
#pragma once

#include <functional>

namespace terrazzo::pipeline {

// How many threads draw a frame, at least 1.
int thread_count();

// Calls `work(i, thread)` once for each i in [0, count), on any of the threads, and returns when all calls
// have. `thread` numbers those that work, from 0 to thread_count() - 1, each in one call at a time. Several
// threads may call this at a time: one gets the pool, the others do their own work. `work` must not throw.
void run_parallel(int count, const std::function<void(int, int)>& work);

}  // namespace terrazzo::pipeline
