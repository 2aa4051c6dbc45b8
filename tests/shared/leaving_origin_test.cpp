// Rays that leave a surface, at every scale, against exact arithmetic.
#include <gtest/gtest.h>

#include <cstdio>

#include "judge/oracle.h"
#include "shared/shade.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

using Wide = __float128;

// The height of a point above the triangle's plane, times the length of its normal: differences of floats and their
// products are exact or nearly so in 113 bits.
Wide heightAbove(const Triangle& t, const vec3& p) {
    Wide e1[3], e2[3], d[3];
    for (int k = 0; k < 3; ++k) {
        e1[k] = Wide(t.b[k]) - Wide(t.a[k]);
        e2[k] = Wide(t.c[k]) - Wide(t.a[k]);
        d[k] = Wide(p[k]) - Wide(t.a[k]);
    }
    Wide sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum += (e1[i] * e2[j] - e1[j] * e2[i]) * d[k];
    }
    return sum;
}

struct Case {
    Triangle triangle;
    Hit hit;
    vec3 direction;
};

bool isSliver(uint32_t seed) { return seed / 45 % 3 == 1; }

// Triangles of any shape, some of them slivers or far from the origin, at scales from 1e-7 to 1e7.
Case caseOf(uint32_t seed) {
    test::Random random(seed);
    const float scale = std::pow(10.0f, static_cast<float>(seed % 15) - 7.0f);
    const vec3 offset = (seed / 15 % 3 == 0   ? 0.0f
                         : seed / 15 % 3 == 1 ? 1.0f
                                              : 1000.0f) *
                        vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const auto point = [&] { return vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)); };
    Triangle t{point(), point(), point()};
    if (isSliver(seed)) t.c = t.a + 0.5f * (t.b - t.a) + 1e-4f * point();  // a sliver
    if (seed / 45 % 3 == 2) t.a.z = t.b.z = t.c.z = 0.0f;                  // in a plane through the origin
    for (vec3* v : {&t.a, &t.b, &t.c}) *v = (*v + (seed / 45 % 3 == 2 ? vec3(offset.x, offset.y, 0) : offset)) * scale;
    const float u = random.unit(), v = (1.0f - u) * random.unit();
    return {t, {1.0f, 0, u, v}, point()};
}

constexpr uint32_t kCases = 20000;

TEST(LeavingOrigin, IsStrictlyOnTheSideThatIsSeen) {
    uint32_t judged = 0;
    for (uint32_t seed = 0; seed < kCases; ++seed) {
        const Case c = caseOf(seed);
        const Wide side = heightAbove(c.triangle, c.triangle.a + c.direction * 1e9f);
        if (heightAbove(c.triangle, c.triangle.a - c.direction * 1e9f) * side >= 0) continue;  // along the plane
        ++judged;
        const Wide height = heightAbove(c.triangle, leavingOrigin(c.triangle, c.hit, c.direction));
        EXPECT_LT((height > 0 ? 1 : -1) * (side > 0 ? 1 : -1), 0) << "seed " << seed;
        EXPECT_NE(static_cast<double>(height), 0.0) << "seed " << seed;
    }
    EXPECT_GT(judged, kCases * 9 / 10);
    std::printf("seeds 0 to %u: %u judged\n", kCases - 1, judged);
}

TEST(LeavingOrigin, StaysWithinAMillionthOfItsCoordinates) {
    for (uint32_t seed = 0; seed < kCases; ++seed) {
        const Case c = caseOf(seed);
        if (makeTriangleSet(std::span(&c.triangle, 1)).included.empty()) continue;  // no area, no ray hits it
        const vec3 origin = leavingOrigin(c.triangle, c.hit, c.direction);
        const dvec3 a(c.triangle.a);
        const dvec3 point =
            a + double{c.hit.u} * (dvec3(c.triangle.b) - a) + double{c.hit.v} * (dvec3(c.triangle.c) - a);
        const double largest = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
        const double farthest =
            std::max({glm::length(a), glm::length(dvec3(c.triangle.b)), glm::length(dvec3(c.triangle.c))});
        EXPECT_LT(glm::distance(dvec3(origin), point), 1e-6 * largest + 1e-14 * farthest) << "seed " << seed;
    }
}

// A ray that leaves does not meet its own triangle, and one that goes back does, but for slivers, which are thinner
// than a rounding of their coordinates.
TEST(LeavingOrigin, MeetsItsTriangleOnlyOnTheWayBack) {
    for (uint32_t seed = 0; seed < kCases; seed += 7) {
        Case c = caseOf(seed);
        c.hit.u = 0.25f + 0.25f * c.hit.u;  // away from the edges
        c.hit.v = 0.25f + 0.2f * c.hit.v;
        const TriangleSet set = makeTriangleSet(std::span(&c.triangle, 1));
        if (set.included.empty()) continue;
        const dvec3 a(c.triangle.a);
        dvec3 normal = glm::normalize(glm::cross(dvec3(c.triangle.b) - a, dvec3(c.triangle.c) - a));
        if (glm::dot(normal, dvec3(c.direction)) > 0.0) normal = -normal;
        Ray ray{leavingOrigin(c.triangle, c.hit, c.direction), 0.0f, vec3(normal), infinity()};
        EXPECT_EQ(bruteForce(set, ray, Query::closest).prim, kNone) << "seed " << seed;
        if (isSliver(seed)) continue;
        ray.direction = -ray.direction;
        const Hit back = bruteForce(set, ray, Query::closest);
        EXPECT_EQ(back.prim, 0u) << "seed " << seed;
        EXPECT_GT(back.t, 0.0f) << "seed " << seed;
    }
}

}  // namespace
}  // namespace cleave
