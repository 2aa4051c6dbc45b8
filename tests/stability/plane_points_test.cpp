// Points at planes are where they say, by whole numbers.
#include "stability/plane_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stability/shapes.h"

namespace cleave {
namespace {

constexpr uint64_t kSeed = 5;
constexpr float kUnit = 0x1p-24f;  // of coordinates up to 1

__extension__ typedef __int128 Whole;

Whole inUnits(float x) {
    const double units = double{x} / double{kUnit};
    EXPECT_EQ(units, std::round(units));
    return static_cast<Whole>(units);
}

// det(b - a, c - a, p - a), in units.
Whole heightOf(const Triangle& t, const vec3& p) {
    const auto from = [&](const vec3& v, int axis) { return inUnits(v[axis]) - inUnits(t.a[axis]); };
    const auto minor = [&](int i, int k) { return from(t.b, i) * from(t.c, k) - from(t.b, k) * from(t.c, i); };
    return minor(1, 2) * from(p, 0) + minor(2, 0) * from(p, 1) + minor(0, 1) * from(p, 2);
}

double inDouble(const Triangle& t, const vec3& p) {
    const dvec3 n = glm::cross(dvec3(t.b) - dvec3(t.a), dvec3(t.c) - dvec3(t.a));
    return glm::dot(n, dvec3(p) - dvec3(t.a));
}

// Coordinates from 1/2 to 1, so that a step is 2^-24 everywhere.
Triangle anyTriangle(Random& random) {
    const auto corner = [&] { return vec3(random.inBox(dvec3(0.5), dvec3(1.0))); };
    const vec3 a = corner(), b = corner();
    return {a, b, corner()};
}

TEST(PlanePoints, LieInThePlaneExactly) {
    Random random(kSeed);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        Triangle t = anyTriangle(random);
        // Towards (1, 1, 1), (1, 1, 0) or an axis, or in general, where floats hardly ever lie in the plane.
        if (i % 4 == 0) t = {t.a, {t.a.y, t.a.z, t.a.x}, {t.a.z, t.a.x, t.a.y}};
        if (i % 4 == 1) t.b.x = t.c.x = t.a.x;
        if (i % 4 == 2) t = {t.a, {t.a.y, t.a.x, t.b.z}, {t.a.x, t.a.y, t.c.z}};
        for (int k = 0; k < 10; ++k) {
            const std::optional<vec3> p = pointInPlane(t, random);
            if (!p) continue;
            ++found;
            EXPECT_TRUE(heightOf(t, *p) == 0) << i;
            EXPECT_TRUE(*p != t.a && *p != t.b && *p != t.c);
        }
    }
    EXPECT_GE(found, 1400) << "seed " << kSeed;
}

TEST(PlanePoints, LieBesideThePlaneWhereDoubleIsInDoubt) {
    Random random(kSeed);
    int found = 0, misjudged = 0;
    for (int i = 0; i < 1000; ++i) {
        const Triangle t = anyTriangle(random);
        const std::optional<vec3> p = pointBesidePlane(t, random);
        if (!p) continue;
        ++found;
        const Whole height = heightOf(t, *p);
        EXPECT_TRUE(height != 0);
        misjudged += (height > 0) == (inDouble(t, *p) > 0.0) ? 0 : 1;
    }
    EXPECT_GE(found, 900) << "seed " << kSeed;
    EXPECT_GE(misjudged, 200);
}

// Nothing to find, and nothing that hangs.
TEST(PlanePoints, AreNotFoundWhereThereAreNone) {
    Random random(kSeed);
    EXPECT_FALSE(pointInPlane({{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, random)) << "a line";
    EXPECT_FALSE(pointBesidePlane({vec3(0), vec3(0), vec3(0)}, random)) << "a point";
    EXPECT_FALSE(pointBesidePlane({{1e-20f, 0, 1}, {1, 1e-20f, 0}, {0, 1, 1e-20f}}, random)) << "of all sizes";
    for (const float size : {1e-44f, 1e-38f, 1e-30f, 1e30f, 3e38f})
        for (int i = 0; i < 100; ++i) {
            const Triangle t = anyTriangle(random);
            for (const auto& find : {pointInPlane, pointBesidePlane}) {
                const std::optional<vec3> p = find({t.a * size, t.b * size, t.c * size}, random);
                EXPECT_TRUE(!p || largestComponent(*p) <= size) << size;
            }
        }
}

}  // namespace
}  // namespace cleave
