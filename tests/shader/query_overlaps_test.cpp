// The kernel query_overlaps against its twin, the shared predicate in a loop, and against the exact one of the judges.
#include <gtest/gtest.h>

#include <algorithm>

#include "builders/builders.h"
#include "judge/separation.h"
#include "run/searcher.h"
#include "shared/overlap.h"
#include "support/closed_surfaces.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/small_points.h"

namespace cleave::test {
namespace {

using Pairs = std::vector<uvec2>;

// The boxes of a scene that is not scaled.
Pairs wantedPairs(const TriangleSet& set, const std::vector<Box>& boxes) {
    Pairs pairs;
    for (uint32_t box = 0; box < boxes.size(); ++box) {
        if (!isBox(boxes[box])) continue;
        for (const uint32_t prim : set.included)
            if (meets(set.triangles[prim], scaledBox(boxes[box], set.exponent), Contact::closed))
                pairs.push_back({box, prim});
    }
    return pairs;
}

void expectOverlaps(const TriangleSet& set, const KdTree& tree, const std::vector<Box>& boxes) {
    Searcher& searcher = sharedSearcher();
    const Searcher::Overlaps found = searcher.overlaps(*uploadTree(device(), set, tree), boxes);
    ASSERT_EQ(found.pairs, wantedPairs(set, boxes));
    EXPECT_EQ(found.invalid,
              static_cast<uint64_t>(std::count_if(boxes.begin(), boxes.end(), [](Box b) { return !isBox(b); })));
}

TEST(QueryOverlaps, EqualsTheExactPredicateOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            const float scale = std::ldexp(1.0f, set.exponent);
            std::vector<Triangle> world;
            for (const uint32_t i : set.included) {
                const Triangle& t = set.triangles[i];
                world.push_back({t.a * scale, t.b * scale, t.c * scale});
            }
            const std::vector<Box> boxes = boxesAt(world, seed, 400, scale);
            expectOverlaps(set, buildExact(set, BuildSettings{}), boxes);
            expectOverlaps(set, buildBrute(set), boxes);
            if (HasFatalFailure()) return;
        }
    }
}

// Touching counts: boxes and triangles on integer coordinates.
TEST(QueryOverlaps, CountsWhatTouches) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleSet set = makeTriangleSet(integerSoup(seed, 100, 8));
        Random random(seed);
        std::vector<Box> boxes;
        for (int i = 0; i < 300; ++i) {
            const vec3 p = glm::round(random.point(-1.0f, 9.0f)), q = glm::round(random.point(-1.0f, 9.0f));
            boxes.push_back({glm::min(p, q), i % 2 == 0 ? glm::max(p, q) : glm::min(p, q)});
        }
        expectOverlaps(set, buildExact(set, BuildSettings{}), boxes);
        if (HasFatalFailure()) return;
    }
}

// A ray can be a box that is all but flat; slivers pass between corners.
TEST(QueryOverlaps, EqualsTheExactPredicateOverSlivers) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<Triangle> world = sliverStar(seed, 4);
        const TriangleSet set = makeTriangleSet(world);
        expectOverlaps(set, buildExact(set, BuildSettings{}), boxesAt(world, seed, 400, seed % 2 == 0 ? 0.1f : 1.0f));
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace cleave::test
