// The threads of a build: how many, and work for several at once.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/fork_order.h"

namespace cleave {

// Runs body() in an arena of its own, so that TBB's parallel functions, nested ones too, use at most `threads` threads
// and those of other callers are left alone. A machine with fewer cores uses fewer threads.
template <class Body>
void withThreads(uint32_t threads, const Body& body) {
    tbb::task_arena(static_cast<int>(std::max(threads, 1u))).execute(body);
}

// Calls body(i) for each i in [0, count), each call a task of its own, and waits for all.
template <class Body>
void forEachAtOnce(size_t count, const Body& body) {
    ForkOrder order;
    order.fork();
    tbb::parallel_for(size_t{0}, count, ForkOrder::Task<Body>{&order, &body}, tbb::simple_partitioner());
    order.join();
}

// Calls both and waits for both.
template <class First, class Second>
void bothAtOnce(const First& first, const Second& second) {
    forEachAtOnce(2, [&](size_t i) { i == 0 ? first() : second(); });
}

}  // namespace cleave
