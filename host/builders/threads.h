// How many threads a build has.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdint>

namespace cleave {

// Runs body() where TBB's parallel functions use `threads` threads, whatever the machine has.
template <class Body>
void withThreads(uint32_t threads, const Body& body) {
    if (threads <= 1) return body();
    // The one allows more threads than the machine has, the other keeps to fewer.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena(static_cast<int>(threads)).execute(body);
}

}  // namespace cleave
