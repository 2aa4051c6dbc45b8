// Parallel work on rays of peers that run on the CPU.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "builders/threads.h"

namespace cleave {

// Calls body(i) for each i in [0, count), in chunks that threads take as they become free.
template <class Body>
void forEachRay(size_t count, uint32_t threads, const Body& body) {
    constexpr size_t kChunkOfRays = 1024;
    withThreads(threads, [&] {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, count, kChunkOfRays),
                          [&](const tbb::blocked_range<size_t>& chunk) {
                              for (size_t i = chunk.begin(); i < chunk.end(); ++i) body(i);
                          });
    });
}

}  // namespace cleave
