#include "tree/triangle_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/small_scenes.h"

namespace cleave {
namespace {

const Triangle kRight{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

std::vector<Triangle> timesTwoTo(std::vector<Triangle> triangles, int n) {
    for (Triangle& t : triangles)
        for (vec3* v : {&t.a, &t.b, &t.c})
            for (int axis = 0; axis < 3; ++axis) (*v)[axis] = std::ldexp((*v)[axis], n);
    return triangles;
}

TEST(TriangleSet, OfNothingIsEmpty) {
    const TriangleSet set = makeTriangleSet({});
    EXPECT_TRUE(set.triangles.empty());
    EXPECT_TRUE(set.included.empty());
    EXPECT_TRUE(isEmpty(set.bounds));
    EXPECT_EQ(set.exponent, 0);
}

TEST(TriangleSet, ScalesTheLargestCoordinateBelowOne) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{{{-4, 1, 0}, {2, 3, 0}, {0, 0, 1}}});
    EXPECT_EQ(set.exponent, 3);
    EXPECT_EQ(set.triangles[0].a, vec3(-0.5f, 0.125f, 0.0f));
    EXPECT_EQ(set.bounds.lo, vec3(-0.5f, 0.0f, 0.0f));
    EXPECT_EQ(set.bounds.hi, vec3(0.25f, 0.375f, 0.125f));
}

TEST(TriangleSet, LeavesOutWhatCannotBeBuiltAndKeepsNumbers) {
    const float nan = std::nanf("");
    const std::vector<Triangle> world{{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, kRight,
                                      {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},   {{0, 0, 0}, {infinity(), 0, 0}, {0, 1, 0}},
                                      {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}},   kRight};
    const TriangleSet set = makeTriangleSet(world);
    EXPECT_EQ(set.included, (std::vector<uint32_t>{1, 5}));
    EXPECT_EQ(set.nonFinite, 2u);
    EXPECT_EQ(set.noArea, 2u);
    EXPECT_EQ(set.triangles.size(), world.size());
    EXPECT_EQ(set.exponent, 3) << "every finite vertex counts, also of what is left out";
    EXPECT_EQ(set.triangles[0].b, vec3(0.0f));
}

TEST(TriangleSet, NegativeZeroBecomesZero) {
    const TriangleSet set = makeTriangleSet(std::vector<Triangle>{{{-0.0f, 0, 0}, {1, -0.0f, 0}, {0, 1, -0.0f}}});
    for (const float x : {set.triangles[0].a.x, set.triangles[0].b.y, set.triangles[0].c.z, set.bounds.lo.x})
        EXPECT_FALSE(std::signbit(x));
}

// Products of these differences vanish in float and, squared, in double.
TEST(TriangleSet, AreaIsDecidedExactlyAtEveryScale) {
    for (const int n : {-148, -126, -100, 0, 100, 125}) {
        SCOPED_TRACE(n);
        const std::vector<Triangle> world =
            timesTwoTo({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}, n - (n > 100 ? 2 : 0));
        const TriangleSet set = makeTriangleSet(world);
        EXPECT_EQ(set.included, std::vector<uint32_t>{0});
        EXPECT_EQ(set.noArea, 1u);
        EXPECT_EQ(set.nonFinite, 0u);
    }
}

// The third vertex is a unit in the last place off the line: double cannot see it at first, the exact sum does.
TEST(TriangleSet, SeesAnAreaOfOneUlp) {
    const float x = 16777215.0f;
    const std::vector<Triangle> world{{{0, 0, 0}, {x, x, 0}, {0x1p-100f, 0x1p-100f, 0}},
                                      {{0, 0, 0}, {x, x, 0}, {0x1p-100f, std::nextafter(0x1p-100f, 1.0f), 0}},
                                      {{1, 1, 0}, {x, x, 0}, {0x1p-80f, 0x1p-80f, 0}},
                                      {{1, 1, 0}, {x, x, 0}, {0x1p-80f, 0x1.000002p-80f, 0}}};
    EXPECT_EQ(makeTriangleSet(world).included, (std::vector<uint32_t>{1, 3}));
}

// 1e-20 beside 1e30: scaled, the small triangle is flushed to a point.
TEST(TriangleSet, LeavesOutWhatScalingFlattens) {
    std::vector<Triangle> world = test::transformed({kRight}, 1e-20f, vec3(0.0f));
    EXPECT_EQ(makeTriangleSet(world).included.size(), 1u);
    world.push_back(test::transformed({kRight}, 1e30f, vec3(0.0f))[0]);
    const TriangleSet set = makeTriangleSet(world);
    EXPECT_EQ(set.included, std::vector<uint32_t>{1});
    EXPECT_EQ(set.noArea, 1u);
}

// The scale is found once: scaling flattens the triangle that set it, and it stays as it is.
TEST(TriangleSet, ScaleStaysWhenItsTriangleIsFlattened) {
    const std::vector<Triangle> world{{{1e30f, 0, 0}, {-1e30f, 1e-20f, 0}, {1e30f, 2e-20f, 0}}, kRight};
    const TriangleSet set = makeTriangleSet(world);
    EXPECT_EQ(set.included, std::vector<uint32_t>{1});
    EXPECT_EQ(set.exponent, 100);  // 2^99 < 1e30 < 2^100
    EXPECT_EQ(set.noArea, 1u);
}

TEST(TriangleSet, MayBeOverAListOfTriangles) {
    std::vector<Triangle> world(6, kRight);
    world[1] = test::transformed({kRight}, 100.0f, vec3(0.0f))[0];
    world[4].a.x = std::nanf("");
    const std::vector<uint32_t> list{0, 2, 4, 5};
    const TriangleSet set = makeTriangleSet(world, list);
    EXPECT_EQ(set.included, (std::vector<uint32_t>{0, 2, 5})) << "numbers are those of the scene";
    EXPECT_EQ(set.nonFinite, 1u);
    EXPECT_EQ(set.exponent, makeTriangleSet(std::vector<Triangle>{kRight}).exponent) << "others do not set the scale";
    EXPECT_EQ(set.triangles.size(), world.size());
}

}  // namespace
}  // namespace cleave
