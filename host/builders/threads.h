// The number of threads of a build.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>

namespace cleave {

// Runs body() in an arena of its own, so that TBB's parallel functions, nested ones too, use at most `threads` threads
// and those of other callers are left alone. A machine with fewer cores uses fewer threads.
template <class Body>
void withThreads(uint32_t threads, const Body& body) {
    tbb::task_arena(static_cast<int>(std::max(threads, 1u))).execute(body);
}

}  // namespace cleave
