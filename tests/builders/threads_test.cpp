#include "builders/threads.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

namespace cleave {
namespace {

// The threads that run a loop within a loop, each iteration long enough for other threads to take a share.
std::set<std::thread::id> threadsOfNestedLoops(uint32_t threads) {
    std::mutex mutex;
    std::set<std::thread::id> used;
    withThreads(threads, [&] {
        tbb::parallel_for(0, 16, [&](int) {
            tbb::parallel_for(0, 16, [&](int) {
                std::this_thread::sleep_for(std::chrono::microseconds(200));
                const std::lock_guard lock(mutex);
                used.insert(std::this_thread::get_id());
            });
        });
    });
    return used;
}

TEST(Threads, BoundNestedLoops) {
    for (const uint32_t threads : {0u, 1u, 2u, 3u})
        EXPECT_LE(threadsOfNestedLoops(threads).size(), std::max(threads, 1u)) << threads << " threads";
}

TEST(Threads, LeaveTheProcessAlone) {
    constexpr auto kLimit = tbb::global_control::max_allowed_parallelism;
    const size_t before = tbb::global_control::active_value(kLimit);
    for (const uint32_t threads : {1u, 2u, 7u})
        withThreads(threads, [&] { EXPECT_EQ(tbb::global_control::active_value(kLimit), before) << threads; });
}

// Two builds at once, as two users of the library may run them, each with its own number of threads.
TEST(Threads, OfSeveralCallersDoNotMix) {
    std::atomic<int> first = 0, second = 0;
    std::thread other([&] { withThreads(3, [&] { second = tbb::this_task_arena::max_concurrency(); }); });
    withThreads(2, [&] { first = tbb::this_task_arena::max_concurrency(); });
    other.join();
    EXPECT_EQ(first, 2);
    EXPECT_EQ(second, 3);
}

}  // namespace
}  // namespace cleave
