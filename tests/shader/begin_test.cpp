#include <gtest/gtest.h>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

TEST(Begin, EqualsTwinAtEverySize) {
    for (uint32_t n : kSizes) {
        SCOPED_TRACE("triangles " + std::to_string(n));
        const TriangleSet set = mixedSet(n, n);
        BuildPair pair(set, BuildSettings{});
        twin::makeRefs(pair.arrays);
        auto onDevice = [&](Recorder& r) { pair.passes.begin(r, pair.buffers); };
        EXPECT_EQ(pair.differenceAfter(onDevice, [&] { twin::begin(pair.arrays); }), "");
    }
}

}  // namespace cleave::test
