#include "shared/box.h"

#include <gtest/gtest.h>

namespace cleave {
namespace {

void expectBox(const Box& b, const vec3& lo, const vec3& hi) {
    EXPECT_EQ(b.lo, lo);
    EXPECT_EQ(b.hi, hi);
}

TEST(Box, isEmptyIfItEndsBeforeItBeginsOnAnyAxis) {
    EXPECT_TRUE(isEmpty(emptyBox()));
    EXPECT_FALSE(isEmpty({vec3(2), vec3(2)})) << "a point is not empty";
    for (int axis = 0; axis < 3; axis++) {
        Box b{vec3(0), vec3(1)};
        b.hi[axis] = nextFloat(0.0f, false);
        EXPECT_TRUE(isEmpty(b)) << axis;
    }
}

TEST(Box, growsFromEmptyByPoints) {
    Box b = including(emptyBox(), {1, -2, 3});
    expectBox(b, {1, -2, 3}, {1, -2, 3});
    b = including(b, {0, 5, 3});
    expectBox(b, {0, -2, 3}, {1, 5, 3});
    b = including(b, {0.5f, 0, 3});  // is inside
    expectBox(b, {0, -2, 3}, {1, 5, 3});
}

TEST(Box, intersectsAxisByAxis) {
    const Box a{{0, 0, 0}, {4, 5, 6}};
    const Box b{{1, -1, 2}, {9, 3, 4}};
    expectBox(intersection(a, b), {1, 0, 2}, {4, 3, 4});
    expectBox(intersection(b, a), {1, 0, 2}, {4, 3, 4});
    EXPECT_FALSE(isEmpty(intersection(a, {{4, 0, 0}, {5, 1, 1}}))) << "boxes that touch share a face";
    EXPECT_TRUE(isEmpty(intersection(a, {{4.5f, 0, 0}, {5, 1, 1}})));
    EXPECT_TRUE(isEmpty(intersection(a, emptyBox())));
}

TEST(Box, isCutInTwoAtAPlane) {
    const Box cell{{0, 1, 2}, {10, 11, 12}};
    for (uint axis = 0; axis < 3; axis++) {
        const int k = static_cast<int>(axis);
        vec3 hi = cell.hi;
        vec3 lo = cell.lo;
        hi[k] = 7;
        lo[k] = 7;
        expectBox(leftOf(cell, axis, 7), cell.lo, hi);
        expectBox(rightOf(cell, axis, 7), lo, cell.hi);
    }
}

TEST(Box, countsAxesWithoutANormalExtent) {
    const Box b{vec3(0), vec3(1)};
    EXPECT_EQ(collapsedAxes(b), 0u);
    EXPECT_EQ(collapsedAxes({vec3(3), vec3(3)}), 3u);
    for (int axis = 0; axis < 3; axis++) {
        Box flat = b;
        flat.hi[axis] = kSmallestNormal;
        EXPECT_EQ(collapsedAxes(flat), 0u) << axis;
        flat.hi[axis] = 0.5f * kSmallestNormal;
        EXPECT_EQ(collapsedAxes(flat), 1u) << axis;
        flat.hi[(axis + 1) % 3] = 0.0f;
        EXPECT_EQ(collapsedAxes(flat), 2u) << axis;
    }
}

}  // namespace
}  // namespace cleave
