// Parallel for; iterations may run in any order.
#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace cleave {

// Calls body(worker, i) for each i in [0, count) on max(1, threads) workers. Worker w takes every threads-th i from w
// on, ascending, so that neighbours, which cost about the same, are spread over all workers.
template <class Body>
void forEachStrided(size_t count, size_t threads, const Body& body) {
    const size_t workers = threads > 1 ? threads : 1;
    const auto work = [&](size_t worker) {
        for (size_t i = worker; i < count; i += workers) body(worker, i);
    };
    std::vector<std::jthread> pool;  // joined at the end
    for (size_t worker = 1; worker < workers; ++worker) pool.emplace_back(work, worker);
    work(0);
}

}  // namespace cleave
