// Families of rays do what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "builders/builders.h"
#include "judge/oracle.h"
#include "stability/cases.h"
#include "stability/ray_families.h"
#include "stability/shapes.h"

namespace cleave {
namespace {

class Families : public testing::Test {
  protected:
    Families() {
        Random random(1);
        world = looseTriangles(random, 150, 0.2);
        set = makeTriangleSet(world);
        tree = buildExact(set, {});
    }
    std::vector<Ray> rays(std::string_view name, uint64_t seed = 1) const {
        for (const RayFamily& family : rayFamilies())
            if (family.name == name)
                return family.make({world, set, &tree, 300, seed, [this](std::span<const Ray> asked) {
                                        std::vector<Hit> hits;
                                        for (const Ray& r : asked) hits.push_back(bruteForce(set, r, Query::closest));
                                        return hits;
                                    }});
        ADD_FAILURE() << "no family " << name;
        return {};
    }
    std::set<float> coordinates(int axis) const {
        std::set<float> all;
        for (const Triangle& t : world)
            for (const vec3& v : {t.a, t.b, t.c}) all.insert(v[axis]);
        return all;
    }
    // World positions of the planes across an axis.
    std::set<float> planes(int axis) const {
        std::set<float> all;
        for (const KdNode& node : tree.nodes)
            if (!isLeaf(node) && nodeAxis(node) == static_cast<uint>(axis))
                all.insert(timesPowerOfTwo(nodePosition(node), tree.exponent));
        return all;
    }
    // Planes and the sides of the root.
    std::set<float> faces(int axis) const {
        std::set<float> all = planes(axis);
        all.insert(timesPowerOfTwo(tree.bounds.lo[axis], tree.exponent));
        all.insert(timesPowerOfTwo(tree.bounds.hi[axis], tree.exponent));
        return all;
    }
    // Aiming rounds the way, so that a ray ends a rounding beside what it is aimed at.
    static bool isNear(const std::set<float>& values, float x) {
        const auto at = values.lower_bound(x - 1e-6f);
        return at != values.end() && *at <= x + 1e-6f;
    }
    std::vector<Triangle> world;
    TriangleSet set;
    KdTree tree;
};

TEST_F(Families, GiveValidRaysFromSeeds) {
    for (const RayFamily& family : rayFamilies()) {
        SCOPED_TRACE(family.name);
        const std::vector<Ray> some = rays(family.name), same = rays(family.name), other = rays(family.name, 2);
        EXPECT_GT(some.size(), 100u);
        EXPECT_LE(some.size(), 300u);
        EXPECT_TRUE(std::all_of(some.begin(), some.end(), [](const Ray& r) { return isValidRay(r); }));
        ASSERT_EQ(some.size(), same.size());
        EXPECT_EQ(std::memcmp(some.data(), same.data(), some.size() * sizeof(Ray)), 0);
        EXPECT_NE(std::memcmp(some.data(), other.data(), std::min(some.size(), other.size()) * sizeof(Ray)), 0);
    }
}

TEST_F(Families, SurviveScenesOfNothing) {
    world.clear();
    set = makeTriangleSet(world);
    tree = buildExact(set, {});
    size_t families = 0;
    for (const RayFamily& family : rayFamilies()) families += rays(family.name).empty() ? 0 : 1;
    EXPECT_EQ(families, 5u) << "random, far, zeros, lengths and grid need no triangle";
}

TEST_F(Families, ZerosHaveBothSigns) {
    size_t positive = 0, negative = 0;
    for (const Ray& r : rays("zeros"))
        for (int axis = 0; axis < 3; ++axis) {
            if (r.direction[axis] != 0.0f) continue;
            (std::signbit(r.direction[axis]) ? negative : positive)++;
        }
    EXPECT_GT(positive, 50u);
    EXPECT_GT(negative, 50u);
}

// Of loose triangles hardly any has a float in its plane, but double cannot tell.
TEST_F(Families, PlaneStartsHitAtZeroOrJustBefore) {
    size_t close = 0;
    for (const Ray& r : rays("plane-starts")) {
        const Hit hit = bruteForce(set, r, Query::closest);
        close += hit.prim != kNone && hit.t < 1e-10f ? 1 : 0;
    }
    EXPECT_GT(close, 40u);
}

TEST_F(Families, LengthsGoFromDenormalToHuge) {
    size_t denormal = 0, huge = 0;
    for (const Ray& r : rays("lengths")) {
        denormal += largestComponent(r.direction) < kSmallestNormal ? 1 : 0;
        huge += largestComponent(r.direction) > 1e38f ? 1 : 0;
    }
    EXPECT_GT(denormal, 50u);
    EXPECT_GT(huge, 20u);
}

TEST_F(Families, AxisRaysKeepTwoCoordinatesOfAVertex) {
    for (const Ray& r : rays("axis-vertices"))
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(r.direction[axis] != 0.0f || coordinates(axis).contains(r.origin[axis]));
}

TEST_F(Families, KdPlaneRaysLieInASplitPlane) {
    for (const Ray& r : rays("kd-planes")) {
        bool lies = false;
        for (int axis = 0; axis < 3; ++axis)
            lies = lies || (r.direction[axis] == 0.0f && planes(axis).contains(r.origin[axis]));
        EXPECT_TRUE(lies);
    }
}
TEST_F(Families, KdEdgeRaysLieInTwoFaces) {
    for (const Ray& r : rays("kd-edges")) {
        int lies = 0;
        for (int axis = 0; axis < 3; ++axis)
            lies += r.direction[axis] == 0.0f && faces(axis).contains(r.origin[axis]) ? 1 : 0;
        EXPECT_EQ(lies, 2);
    }
}
TEST_F(Families, KdCornerRaysStartAtCornersOrAimAtThem) {
    size_t start = 0, end = 0;
    for (const Ray& r : rays("kd-corners")) {
        const vec3 &from = r.origin, to = r.origin + r.direction;
        start += faces(0).contains(from.x) && faces(1).contains(from.y) && faces(2).contains(from.z) ? 1 : 0;
        end += isNear(faces(0), to.x) && isNear(faces(1), to.y) && isNear(faces(2), to.z) ? 1 : 0;
    }
    EXPECT_EQ(start, 75u);
    EXPECT_GE(end, 75u);
}

TEST_F(Families, VerticesAndGridPointsAreMet) {
    size_t met = 0;
    for (const Ray& r : rays("vertices")) {
        const vec3 end = r.origin + r.direction;
        met += isNear(coordinates(0), end.x) && isNear(coordinates(1), end.y) && isNear(coordinates(2), end.z);
    }
    EXPECT_EQ(met, 300u);
    const auto isWhole = [](float x) { return x == std::round(x * 32.0f) / 32.0f; };
    for (const Ray& r : rays("grid"))
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(r.direction[axis] != 0.0f || isWhole(r.origin[axis])) << r.origin[axis];
}

TEST_F(Families, EndsLieAtTheHitAndBesideIt) {
    size_t at = 0, beside = 0;
    for (Ray r : rays("ends")) {
        const float lo = r.tMin, hi = r.tMax;
        r.tMin = 0.0f;
        r.tMax = infinity();
        const Hit hit = bruteForce(set, r, Query::closest);
        const auto isNear = [&](float t) { return t == nextFloat(hit.t, true) || t == nextFloat(hit.t, false); };
        at += lo == hit.t || hi == hit.t ? 1 : 0;
        beside += isNear(lo) || isNear(hi) ? 1 : 0;
    }
    EXPECT_GT(at, 20u);
    EXPECT_GT(beside, 40u);
}

TEST_F(Families, GrazingRaysLieCloseToAPlane) {
    size_t close = 0, hits = 0;
    for (const Ray& r : rays("grazing")) {
        const Hit hit = bruteForce(set, r, Query::closest);
        if (hit.prim == kNone) continue;
        ++hits;
        const Triangle& t = world[hit.prim];
        const dvec3 n = glm::normalize(glm::cross(dvec3(t.b) - dvec3(t.a), dvec3(t.c) - dvec3(t.a)));
        close += std::fabs(glm::dot(n, glm::normalize(dvec3(r.direction)))) < 0.01 ? 1 : 0;
    }
    EXPECT_GT(hits, 200u);
    EXPECT_GT(close, 60u);
}

}  // namespace
}  // namespace cleave
