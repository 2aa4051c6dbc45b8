// Random scenes with coincidences: what build/bin/query_fuzz does for longer.
#include <gtest/gtest.h>

#include "support/device.h"
#include "support/query_check.h"

namespace cleave::test {

TEST(QueryFuzz, FiftyThousandPairsAreAnsweredRight) {
    constexpr uint32_t kSeed = 20261;
    constexpr size_t kRays = 100;
    constexpr uint64_t kScenes = 500;
    QueryCheck check(device());
    for (uint64_t scene = 0; scene < kScenes; ++scene) {
        const QueryCase c = queryCase(kSeed, scene, kRays);
        const std::optional<QueryFailure> failure = check.firstFailure(c);
        ASSERT_FALSE(failure) << failure->what << "\nray " << codeOf(c.rays[failure->ray]) << "\nquery_fuzz --seed "
                              << kSeed << " --scene " << scene << " --rays " << kRays;
    }
    const QueryCheck::Counts& n = check.counts();
    EXPECT_EQ(n.pairs, kScenes * kRays);
    EXPECT_GT(n.hits, n.pairs / 4);
    EXPECT_LE(n.undecided, n.pairs / 1000);  // near coincidences at edges and at ends of intervals
}

}  // namespace cleave::test
