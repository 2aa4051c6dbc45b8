#include <gtest/gtest.h>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

TEST(MakeRefs, EqualsTwinAtEverySize) {
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("triangles " + std::to_string(n));
        const TriangleSet set = mixedSet(n, n);
        BuildPair pair(set, BuildSettings{});
        auto onDevice = [&](Recorder& r) {
            pair.passes.makeRefs(r, pair.buffers, static_cast<uint32_t>(set.included.size()));
        };
        EXPECT_EQ(pair.differenceAfter(onDevice, [&] { twin::makeRefs(pair.arrays); }), "");
    }
}

}  // namespace cleave::test
