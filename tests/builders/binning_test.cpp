// The vectorised counting of CPU builders, against plain loops.
#include "builders/binning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders/face_scan.h"
#include "builders/faces_along.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

enum class Family { random, integer, tiny, kCount };

// Boxes of which some are flat, some share faces; tiny: a few neighbouring floats hold them all.
std::vector<ClippedRef> boxes(Family family, uint32_t seed, uint32_t count) {
    test::Random random(seed);
    const auto coordinate = [&] {
        if (family == Family::integer) return static_cast<float>(random.below(12)) / 16.0f;
        if (family == Family::tiny) return uintBitsToFloat(floatBitsToUint(0.7f) + random.below(60));
        return random.between(-0.9f, 0.9f);
    };
    std::vector<ClippedRef> refs(count);
    for (uint32_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const float a = coordinate(), b = random.below(4) == 0 ? a : coordinate();
            refs[i].box.lo[axis] = std::min(a, b);
            refs[i].box.hi[axis] = std::max(a, b);
        }
        refs[i].prim = i;
    }
    return refs;
}

Box unionOf(const std::vector<ClippedRef>& refs) {
    Box all = emptyBox();
    for (const ClippedRef& ref : refs) all = including(including(all, ref.box.lo), ref.box.hi);
    return all;
}

void expectSame(const Split& a, const Split& b) {
    EXPECT_EQ(a.cost, b.cost);
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.planarLeft, b.planarLeft);
}

template <class Body>
void forEachCase(uint32_t most, const Body& body) {
    for (uint32_t family = 0; family < static_cast<uint32_t>(Family::kCount); ++family)
        for (uint32_t seed = 0; seed < 150; ++seed) {
            SCOPED_TRACE(testing::Message() << "family " << family << " seed " << seed);
            body(boxes(static_cast<Family>(family), seed, 1 + seed * 7 % most), seed);
        }
}

TEST(Binning, CountsEveryIntervalOnItsSides) {
    forEachCase(400, [](const std::vector<ClippedRef>& refs, uint32_t seed) {
        const uint32_t bins = seed % 4 == 0 ? kMostBins - seed % 7 : 2 + seed % 31, step = 1 + seed % 3;
        const Box bounds = boundsOf(refs);
        const Box expected = unionOf(refs);
        EXPECT_EQ(bounds.lo, expected.lo);
        EXPECT_EQ(bounds.hi, expected.hi);
        Bins counted;
        fillBins(counted, refs, bounds, bins, step);
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const BinRange& range = counted.range[axis];
            if (!isResolved(range)) continue;
            const int a = static_cast<int>(axis);
            for (uint32_t b = 1; b < bins; ++b) {
                const float plane = binPlane(range, b);
                uint32_t left = 0, right = 0, isLeft = 0, isRight = 0;
                for (uint32_t k = 0; k < b; ++k) left += counted.starts(axis)[k];
                for (uint32_t k = b; k < bins; ++k) right += counted.ends(axis)[k];
                for (size_t i = 0; i < refs.size(); i += step) {
                    const float lo = refs[i].box.lo[a], hi = refs[i].box.hi[a];
                    isLeft += lo < plane || (lo == plane && hi == plane);
                    isRight += hi > plane;
                }
                ASSERT_EQ(left, isLeft) << "axis " << axis << " boundary " << b;
                ASSERT_EQ(right, isRight) << "axis " << axis << " boundary " << b;
            }
        }
    });
}

TEST(Binning, FindsTheBestBoundary) {
    forEachCase(400, [](const std::vector<ClippedRef>& refs, uint32_t seed) {
        const uint32_t bins = seed % 4 == 0 ? kMostBins - seed % 7 : 2 + seed % 31, step = 1 + seed % 3;
        const auto n = static_cast<uint32_t>(refs.size());
        const NodeToSplit node{refs, {vec3(-0.8f), vec3(0.95f, 0.85f, 0.9f)}, 0};
        Bins counted;
        fillBins(counted, refs, unionOf(refs), bins, step);
        Split expected = noSplit();
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const BinRange& range = counted.range[axis];
            expected = betterOf(expected, kDefaultCosts, node.cell, axis, range.lo, 0, n, 0);
            expected = betterOf(expected, kDefaultCosts, node.cell, axis, range.hi, n, 0, 1);
            for (uint32_t b = 1; b < bins && isResolved(range); ++b) {
                uint32_t left = 0, right = 0;
                for (uint32_t k = 0; k < b; ++k) left += counted.starts(axis)[k];
                for (uint32_t k = b; k < bins; ++k) right += counted.ends(axis)[k];
                expected = betterOf(expected, kDefaultCosts, node.cell, axis, binPlane(range, b),
                                    estimatedCount(left, step, n), estimatedCount(right, step, n), 1);
            }
        }
        expectSame(bestBoundary(counted, node, step), expected);
    });
}

// The better of `best` and the plane, with its boxes counted one by one.
Split betterAt(const Split& best, const NodeToSplit& node, uint32_t axis, float plane) {
    const int a = static_cast<int>(axis);
    uint32_t left = 0, right = 0, planar = 0;
    for (const ClippedRef& ref : node.refs) {
        left += ref.box.lo[a] < plane;
        right += ref.box.hi[a] > plane;
        planar += ref.box.lo[a] == plane && ref.box.hi[a] == plane;
    }
    return betterOfBothSides(best, kDefaultCosts, node.cell, axis, plane, left, right, planar);
}

TEST(FacesAlong, MovesAPlaneToTheBetterFaceBesideIt) {
    forEachCase(100, [](const std::vector<ClippedRef>& refs, uint32_t seed) {
        const NodeToSplit node{refs, {vec3(-1), vec3(1)}, 0};
        const uint32_t axis = seed % 3;
        const int a = static_cast<int>(axis);
        const float position = seed % 2 == 0 ? test::Random(seed).between(-0.5f, 0.7f) : refs[0].box.hi[a];
        float below = -2, above = 2;
        for (const ClippedRef& ref : refs)
            for (const float face : {ref.box.lo[a], ref.box.hi[a]}) {
                if (face <= position) below = std::max(below, face);
                if (face >= position) above = std::min(above, face);
            }
        Split expected = noSplit();
        for (const float plane : {below, position, above}) {
            expected = betterAt(expected, node, axis, plane);
        }
        FacesAlong faces;
        gatherFaces(faces, node, axis);
        EXPECT_EQ(faces.from, unionOf(refs).lo[a]);
        EXPECT_EQ(faces.to, unionOf(refs).hi[a]);
        expectSame(bestNear(faces, node, position), expected);
    });
}

TEST(FaceScan, FindsTheBestOfAllFaces) {
    forEachCase(kMostScanned, [](const std::vector<ClippedRef>& refs, uint32_t) {
        const NodeToSplit node{refs, {vec3(-0.8f), vec3(0.95f, 0.85f, 0.9f)}, 0};
        for (uint32_t axes = 1; axes <= kAllAxes; ++axes) {
            Split expected = noSplit();
            for (uint32_t axis = 0; axis < 3; ++axis)
                for (size_t i = 0; i < 2 * refs.size() && (axes & onlyAxis(axis)) != 0; ++i) {
                    const int a = static_cast<int>(axis);
                    const float plane = i % 2 == 0 ? refs[i / 2].box.lo[a] : refs[i / 2].box.hi[a];
                    expected = betterAt(expected, node, axis, plane);
                }
            expectSame(bestFace(node, axes), expected);
        }
    });
}

}  // namespace
}  // namespace cleave
