// The kernel query_nearest against its twin, with ==, and against the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "builders/builders.h"
#include "judge/nearest.h"
#include "run/searcher.h"
#include "support/closed_surfaces.h"
#include "support/device.h"
#include "support/runners.h"
#include "support/scenes.h"
#include "support/small_points.h"

namespace cleave::test {
namespace {

std::vector<Triangle> included(const TriangleSet& set) {
    std::vector<Triangle> triangles;
    for (const uint32_t i : set.included) triangles.push_back(set.triangles[i]);
    return triangles;
}

void expectNearest(const TriangleSet& set, const KdTree& tree, const std::vector<vec3>& points, float within) {
    Searcher& searcher = sharedSearcher();
    const auto onDevice = uploadTree(device(), set, tree);
    const Searcher::Nearest found = searcher.nearest(*onDevice, points, within);
    ASSERT_EQ(found.hits.size(), points.size());
    uint64_t invalid = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const Hit want = bruteNearest(set, points[i], within);
        ASSERT_EQ(std::memcmp(&found.hits[i], &want, sizeof want), 0)
            << "point " << i << ": triangle " << found.hits[i].prim << " at " << found.hits[i].t << ", want "
            << want.prim << " at " << want.t;
        invalid += isFinite3(points[i]) ? 0 : 1;
    }
    EXPECT_EQ(found.invalid, invalid);
}

TEST(QueryNearest, EqualsBruteForceOverEveryTree) {
    for (uint32_t n : {0u, 1u, 2u, 33u, 500u}) {
        for (uint32_t seed = 1; seed <= 3; seed++) {
            SCOPED_TRACE("triangles " + std::to_string(n) + ", seed " + std::to_string(seed));
            const TriangleSet set = mixedSet(n, seed);
            std::vector<Triangle> world = included(set);
            const float scale = std::ldexp(1.0f, set.exponent);
            for (Triangle& t : world) t = {t.a * scale, t.b * scale, t.c * scale};
            const std::vector<vec3> points = pointsAt(world, seed, 1000, scale);
            for (const float within : {infinity(), 0.1f * scale, 0.0f}) {
                expectNearest(set, buildExact(set, BuildSettings{}), points, within);
                expectNearest(set, buildBrute(set), points, within);
                if (HasFatalFailure()) return;
            }
        }
    }
}

// Within 8 units in the last place of the largest coordinate, of slivers, too, far from the origin and at every scale.
TEST(QueryNearest, EqualsTheReference) {
    double worst = 0.0;
    for (uint32_t seed = 0; seed < 48; ++seed) {
        SCOPED_TRACE(seed);
        std::vector<Triangle> world = seed % 3 == 0   ? sliverStar(seed, 4)
                                      : seed % 3 == 1 ? latticeBlob(seed, 4, 6)
                                                      : soup(seed, 200, 0.3f);
        const float scale = seed % 4 == 1 ? 1e-30f : seed % 4 == 2 ? 1e18f : 1.0f;
        const float shift = seed % 4 == 3 ? 1000.0f : 0.0f;
        world = transformed(world, scale, vec3(shift));
        float largest = 0.0f;
        for (const Triangle& t : world)
            for (const vec3& v : {t.a, t.b, t.c}) largest = max(largest, largestComponent(v));
        const TriangleSet set = makeTriangleSet(world);
        std::vector<vec3> points = pointsAt(world, seed, 400, largest);
        Searcher& searcher = sharedSearcher();
        const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
        const Searcher::Nearest found = searcher.nearest(*tree, points, infinity());
        for (size_t i = 0; i < points.size(); ++i) {
            if (!isFinite3(points[i])) continue;
            double want = infinity();
            for (const uint32_t prim : set.included) want = std::min(want, referenceDistance(world[prim], points[i]));
            const Hit& hit = found.hits[i];
            ASSERT_NE(hit.prim, kNone);
            // The distance itself is rounded, which is more for points farther away than the scene reaches.
            const double ulp = std::ldexp(1.0, std::ilogb(std::max<double>(largest, want)) - 23);
            const double error =
                std::max(std::fabs(hit.t - want), referenceDistance(world[hit.prim], points[i]) - want);
            worst = std::max(worst, error / ulp);
            ASSERT_LE(error, 8.0 * ulp) << "point " << i << ": " << hit.t << ", want " << want;
            // u and v are of a point that is so far away.
            const Triangle& t = world[hit.prim];
            const dvec3 near =
                dvec3(t.a) + double{hit.u} * (dvec3(t.b) - dvec3(t.a)) + double{hit.v} * (dvec3(t.c) - dvec3(t.a));
            ASSERT_NEAR(glm::length(near - dvec3(points[i])), want, 8.0 * ulp) << "point " << i;
        }
    }
    EXPECT_LT(worst, 1.0);
    RecordProperty("worst", std::to_string(worst) + " units in the last place");
}

TEST(QueryNearest, GivesTiesToTheLowestNumber) {
    const Triangle one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, other{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    const std::vector<Triangle> world{other, one, one, other};
    const TriangleSet set = makeTriangleSet(world);
    Searcher searcher(device());
    const auto tree = uploadTree(device(), set, buildExact(set, BuildSettings{}));
    const std::vector<vec3> points{{0.2f, 0.2f, 1.0f}, {-0.2f, 0.2f, -1.0f}, {0.0f, 0.5f, 2.0f}, {0, 0, 0}};
    const Searcher::Nearest found = searcher.nearest(*tree, points, infinity());
    EXPECT_EQ(found.hits[0].prim, 1u);
    EXPECT_EQ(found.hits[1].prim, 0u);
    EXPECT_EQ(found.hits[2].prim, 0u) << "at the edge of all";
    EXPECT_EQ(found.hits[3].prim, 0u) << "at a vertex of all";
    EXPECT_EQ(found.hits[3].t, 0.0f);
    // Closed: a triangle exactly that far away counts.
    EXPECT_EQ(searcher.nearest(*tree, points, 2.0f).hits[2].prim, 0u);
    EXPECT_EQ(searcher.nearest(*tree, points, nextFloat(2.0f, false)).hits[2].prim, kNone);
    EXPECT_EQ(searcher.nearest(*tree, points, nextFloat(2.0f, false)).hits[2].t, infinity());
}

}  // namespace
}  // namespace cleave::test
