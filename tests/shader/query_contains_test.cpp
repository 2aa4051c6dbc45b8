// The kernel query_contains against the reference: exact crossings in another direction, exact contact.
#include <gtest/gtest.h>

#include "builders/builders.h"
#include "judge/crossings.h"
#include "judge/separation.h"
#include "run/searcher.h"
#include "support/closed_surfaces.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/small_points.h"
#include "tree/open_edges.h"

namespace cleave::test {
namespace {

bool isContained(const std::vector<Triangle>& world, const TriangleSet& set, const vec3& p, const vec3& direction) {
    if (!isFinite3(p)) return false;
    for (const uint32_t prim : set.included)
        if (meets(world[prim], {p, p}, Contact::closed)) return true;
    return referenceCrossings(world, {p, 0.0f, direction, infinity()}).size() % 2 == 1;
}

TEST(QueryContains, EqualsTheReferenceOverClosedSurfaces) {
    uint64_t inside = 0, outside = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const bool slivers = seed % 2 == 0;
        std::vector<Triangle> world = slivers ? sliverStar(seed, 4) : latticeBlob(seed, 4, 6);
        if (seed % 4 == 1) std::swap(world[3].a, world[3].b);  // which way triangles face does not matter
        ASSERT_EQ(openEdges(world), 0u);
        const TriangleSet set = makeTriangleSet(world);
        const std::vector<vec3> points = pointsAt(world, seed, 500, slivers ? 0.3f : 4.0f);
        Searcher& searcher = sharedSearcher();
        const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
        const Searcher::Contained found = searcher.contains(*tree, points);
        const vec3 directions[] = {{1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {-0.3f, 0.2f, 0.9f}};
        for (size_t i = 0; i < points.size(); ++i) {
            const bool want = isContained(world, set, points[i], directions[i % 4]);
            ASSERT_EQ(found.isInside[i], want ? 1 : 0) << "point " << i;
            (want ? inside : outside)++;
        }
        EXPECT_GT(found.invalid, 0u);
    }
    EXPECT_GT(inside, 4000u);
    EXPECT_GT(outside, 4000u);
}

TEST(QueryContains, FindsNothingInAnEmptyScene) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{});
    Searcher searcher(device());
    const std::vector<vec3> points(3, vec3(0.0f));
    const auto tree = uploadTree(device(), set, buildBrute(set));
    EXPECT_EQ(searcher.contains(*tree, points).isInside, std::vector<uint8_t>(3, 0));
}

}  // namespace
}  // namespace cleave::test
