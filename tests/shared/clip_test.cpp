#include "shared/clip.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace cleave {
namespace {

// The independent answer: Sutherland and Hodgman's clipping in double.
using Polygon = std::vector<dvec3>;

struct DoubleBox {
    dvec3 lo{INFINITY};
    dvec3 hi{-INFINITY};
    bool isEmpty() const { return lo.x > hi.x; }
};

Polygon clipped(const Polygon& polygon, int axis, double plane, double sign) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); i++) {
        const dvec3& p = polygon[i];
        const dvec3& q = polygon[(i + 1) % polygon.size()];
        const double dp = sign * (plane - p[axis]), dq = sign * (plane - q[axis]);
        if (dp >= 0.0) kept.push_back(p);
        if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) kept.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    return kept;
}

DoubleBox boxOfPart(const Triangle& t, const Box& cell, double widening) {
    Polygon polygon = {dvec3(t.a), dvec3(t.b), dvec3(t.c)};
    for (int axis = 0; axis < 3; axis++) {
        polygon = clipped(polygon, axis, cell.hi[axis] + widening, 1.0);
        polygon = clipped(polygon, axis, cell.lo[axis] - widening, -1.0);
    }
    DoubleBox b;
    for (const dvec3& p : polygon) {
        b.lo = glm::min(b.lo, p);
        b.hi = glm::max(b.hi, p);
    }
    return b;
}

double extentOf(const Triangle& t) { return max(largestComponent(t.b - t.a), largestComponent(t.c - t.a)); }

// A place of float at the coordinate.
double ulp(double x) { return std::ldexp(1.0, std::ilogb(std::fabs(x) + 1e-30) - 23); }

// `side` is the result for `cell`. It holds the exact part (up to what double rounds). It is empty, or tight, by the
// part in a cell that is widened by the margin: where an edge runs along a plane, a little more cell is much more
// triangle, so the part in the cell itself is no bound.
void expectBetween(const Triangle& t, const Box& cell, const Box& side) {
    const double margin = 0x1p-16 * extentOf(t);
    const Box limit = intersection(cell, triangleBox(t));
    const DoubleBox exact = boxOfPart(t, cell, 0.0);
    const DoubleBox widened = boxOfPart(t, cell, margin);
    ASSERT_TRUE(!widened.isEmpty() || isEmpty(side)) << "must be empty";
    for (int k = 0; k < 3; k++) {
        if (!exact.isEmpty()) {
            const double slack = 1e-14 * (std::fabs(t.a[k]) + extentOf(t));
            ASSERT_LE(side.lo[k], exact.lo[k] + slack) << "loses a part, axis " << k;
            ASSERT_GE(side.hi[k], exact.hi[k] - slack) << "loses a part, axis " << k;
        }
        if (isEmpty(side)) continue;
        ASSERT_GE(side.lo[k], limit.lo[k]) << "leaves the cell or the triangle's box, axis " << k;
        ASSERT_LE(side.hi[k], limit.hi[k]) << "leaves the cell or the triangle's box, axis " << k;
        ASSERT_GE(side.lo[k], widened.lo[k] - margin - 2.0 * ulp(widened.lo[k])) << "is loose, axis " << k;
        ASSERT_LE(side.hi[k], widened.hi[k] + margin + 2.0 * ulp(widened.hi[k])) << "is loose, axis " << k;
    }
}

bool holds(const Box& b, const dvec3& p) { return glm::max(dvec3(b.lo), p) == p && glm::min(dvec3(b.hi), p) == p; }

// Points with weights of sixteenths: exact in double, as the coordinates of a triangle are near each other.
int expectHolds(const Triangle& t, const Box& cell, const Box& side) {
    int held = 0;
    for (int i = 0; i <= 16; i++) {
        for (int j = 0; i + j <= 16; j++) {
            const dvec3 p = (dvec3(t.a) * double(16 - i - j) + dvec3(t.b) * double(i) + dvec3(t.c) * double(j)) / 16.0;
            if (!holds(cell, p)) continue;
            EXPECT_TRUE(holds(side, p)) << "point " << i << " " << j << " is lost";
            held++;
        }
    }
    return held;
}

enum Kind { kAny, kNeedle, kSteep, kFlat, kFar, kGrid, kKinds };  // steep: an edge almost in a plane

Triangle anyTriangle(Kind kind, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    vec3 v[3];
    for (vec3& p : v) p = vec3(unit(random), unit(random), unit(random));
    if (kind == kNeedle) v[2] = v[1] + std::ldexp(1.0f, -static_cast<int>(random() % 24)) * v[2];
    const int flat = static_cast<int>(random() % 3);
    if (kind == kSteep) v[2][flat] = v[1][flat] + 0x1p-20f * v[2][flat];
    for (vec3& p : v) {
        if (kind == kFlat) p[flat] = v[0][flat];
        if (kind == kFar) p += vec3(1e5f, -1e5f, 1e5f);
        if (kind == kGrid) p = glm::round(p * 4.0f);
    }
    return {v[0], v[1], v[2]};
}

// The triangle's box, or a part of it, and a plane strictly inside; false if there is none.
bool anyCell(const Triangle& t, std::mt19937& random, Box& cell, uint& axis, float& split) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    cell = triangleBox(t);
    for (int k = 0; k < 3; k++) {
        const float lo = cell.lo[k], size = cell.hi[k] - lo;
        const float x = lo + unit(random) * size, y = lo + unit(random) * size;
        if (random() % 3 != 0) cell.lo[k] = max(lo, min(x, y));
        if (random() % 3 != 0) cell.hi[k] = min(cell.hi[k], max(x, y));
    }
    axis = static_cast<uint>(random() % 3);
    const int k = static_cast<int>(axis);
    split = cell.lo[k] + unit(random) * (cell.hi[k] - cell.lo[k]);
    if (random() % 3 == 0) split = std::round(split);
    if (random() % 3 == 0) split = t.b[k] + unit(random) * (t.c[k] - t.b[k]);
    return !isEmpty(cell) && cell.lo[k] < split && split < cell.hi[k];
}

TEST(Clip, partsAreHeldAndTight) {
    for (const Kind kind : {kAny, kNeedle, kSteep, kFlat, kFar, kGrid}) {
        int tried = 0, empty = 0, held = 0;
        for (uint seed = 0; seed < 3000; seed++) {
            SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
            std::mt19937 random(seed * kKinds + kind);
            const Triangle t = anyTriangle(kind, random);
            Box cell;
            uint axis;
            float split;
            if (!anyCell(t, random, cell, axis, split)) continue;
            const SplitBoxes s = splitBoxes(t, cell, axis, split);
            const Box left = leftOf(cell, axis, split), right = rightOf(cell, axis, split);
            expectBetween(t, left, s.left);
            expectBetween(t, right, s.right);
            held += expectHolds(t, left, s.left) + expectHolds(t, right, s.right);
            if (HasFailure()) return;
            tried++;
            empty += (isEmpty(s.left) ? 1 : 0) + (isEmpty(s.right) ? 1 : 0);
        }
        EXPECT_GT(tried, 800) << kind;
        EXPECT_GT(empty, 100) << kind;
        EXPECT_GT(held, 10 * tried) << kind;
    }
}

// The exact box, or one larger by the two margins (of the plane and of the result) and two roundings.
void expectNear(const Box& b, const vec3& lo, const vec3& hi, float extent) {
    const float margin = 0x1.02p-16f * extent;
    for (int k = 0; k < 3; k++) {
        EXPECT_LE(b.lo[k], lo[k]) << k;
        EXPECT_GE(b.hi[k], hi[k]) << k;
        EXPECT_GE(b.lo[k], lo[k] - margin) << k;
        EXPECT_LE(b.hi[k], hi[k] + margin) << k;
    }
}

TEST(Clip, cutsARightTriangle) {
    const Triangle t{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}};
    SplitBoxes s = splitBoxes(t, triangleBox(t), 0u, 2.0f);
    EXPECT_EQ(s.left.lo, vec3(0, 0, 1));
    EXPECT_EQ(s.left.hi, vec3(2, 8, 1));
    EXPECT_EQ(s.right.lo, vec3(2, 0, 1));
    expectNear(s.right, {2, 0, 1}, {8, 6, 1}, 8.0f);
    // In the cell x, y >= 1: behind x = 3 what is left has y <= 5 and x <= 7.
    s = splitBoxes(t, {{1, 1, 1}, {8, 8, 1}}, 0u, 3.0f);
    expectNear(s.left, {1, 1, 1}, {3, 7, 1}, 8.0f);
    expectNear(s.right, {3, 1, 1}, {7, 5, 1}, 8.0f);
    EXPECT_EQ(s.left.hi.x, 3.0f) << "no part leaves the cell";
    EXPECT_EQ(s.right.lo.y, 1.0f);
}

TEST(Clip, cutsATiltedTriangle) {
    const Triangle t{{0, 0, 0}, {4, 0, 4}, {0, 4, 4}};  // z = x + y
    const SplitBoxes s = splitBoxes(t, triangleBox(t), 2u, 1.0f);
    expectNear(s.left, {0, 0, 0}, {1, 1, 1}, 4.0f);
    expectNear(s.right, {0, 0, 1}, {4, 4, 4}, 4.0f);
}

TEST(Clip, seesThatATriangleMissesACellThatItsBoxMeets) {
    const Triangle t{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}};
    SplitBoxes s = splitBoxes(t, {{5, 5, 1}, {8, 8, 1}}, 1u, 6.0f);
    EXPECT_TRUE(isEmpty(s.left));
    EXPECT_TRUE(isEmpty(s.right));
    s = splitBoxes(t, {{3, 2, 1}, {8, 8, 1}}, 0u, 6.5f);  // x + y <= 8 and y >= 2: x <= 6
    expectNear(s.left, {3, 2, 1}, {6, 5, 1}, 8.0f);
    EXPECT_TRUE(isEmpty(s.right));
}

// Of Sponza: seen from x = a.x, the part behind z = c.z is thinner than a place of double, and still not flat.
TEST(Clip, keepsSliversThatAreThinnerThanAPlaceOfDouble) {
    const Triangle t{{0.506788731f, 0.217290968f, 0.0290699378f},
                     {0.506788731f, 0.150728464f, 0.0290699694f},
                     {0.506813765f, 0.150728494f, 0.070840314f}};
    const Box cell{{0.506788731f, 0.150728464f, 0.0290699378f}, {0.506813765f, 0.150728479f, 0.0290699694f}};
    const float middle = nextFloat(0.0290699378f, true);
    ASSERT_LT(middle, cell.hi.z);
    const SplitBoxes s = splitBoxes(t, cell, 2u, middle);
    EXPECT_FALSE(isEmpty(s.right));
    EXPECT_GT(s.right.hi.x, t.a.x);
}

TEST(Clip, cutsAnEdgeAtThePlane) {
    EXPECT_EQ(cutEdge({1, 2, 3}, {5, 10, -1}, 0u, 2.0f), vec3(2, 4, 2));
    EXPECT_EQ(cutEdge({0, 0, 0}, {3, 1, 1}, 0u, 1.0f).x, 1.0f) << "set, not computed";
}

}  // namespace
}  // namespace cleave
