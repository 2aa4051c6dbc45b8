#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "support/picture.h"

namespace cleave::test {

TEST(SelectCount, EqualsTwinAtEverySizeInEveryRound) {
    uint32_t seed = 1;
    for (const PictureSize& size : kPictureSizes) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        PicturePair pair(size.width, size.height, View::steps, seed++);
        for (uint32_t round = 0; round < 4; round++) {
            pair.onTwin(PictureKernels::count_histogram, {round, 0});
            const PictureArrays device = pair.onDevice(PictureKernels::select_count, {round, 0});
            pair.onTwin(PictureKernels::select_count, {round, 0});
            ASSERT_EQ(std::memcmp(&device.state, &pair.arrays.state, sizeof(PictureState)), 0) << "round " << round;
        }
    }
}

// Four rounds select what sorting finds: the count that all but 1 in 200 stay below.
TEST(SelectCount, FindsTheNthOfTheSortedCounts) {
    uint32_t seed = 20;
    for (const PictureSize& size : kPictureSizes)
        for (const View view : {View::steps, View::leaves}) {
            PicturePair pair(size.width, size.height, view, seed++);
            std::vector<uint32_t> counts;
            for (size_t i = 0; i < pair.arrays.rays.size(); i++) {
                const StepCount& s = pair.arrays.steps[i];
                if (view == View::steps)
                    counts.push_back(s.inner + s.leaves);
                else if (pair.arrays.hits[i].prim != kNone)
                    counts.push_back(s.hitLeaf);
            }
            std::sort(counts.begin(), counts.end());
            for (uint32_t round = 0; round < 4; round++) {
                pair.onTwin(PictureKernels::count_histogram, {round, 0});
                pair.onTwin(PictureKernels::select_count, {round, 0});
            }
            const PictureState& state = pair.arrays.state;
            const float high = viewScale(state.lowBits, state.highBits).high;
            const float want = counts.empty() ? 0.0f : static_cast<float>(counts[(counts.size() - 1) * 199 / 200]);
            EXPECT_EQ(high, want) << size.width << " x " << size.height;
        }
}

TEST(SelectCount, RanksExactlyAlsoWhereAProductWouldOverflow) {
    for (uint64_t total : {uint64_t{1}, uint64_t{2}, uint64_t{199}, uint64_t{200}, uint64_t{201}, uint64_t{921600},
                           uint64_t{4000000000}})
        EXPECT_EQ(scaleRank(static_cast<uint32_t>(total)), (total - 1) * 199 / 200) << total;
    EXPECT_EQ(scaleRank(0), 0u);
}

}  // namespace cleave::test
