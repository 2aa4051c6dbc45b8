// Each test breaks a sound tree in one way and expects an error.
#include "judge/validate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders/builders.h"
#include "judge/separation.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

class Validate : public testing::Test {
  protected:
    void SetUp() override {
        std::vector<Triangle> world = test::soup(7, 60, 0.2f);
        world.push_back({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});  // number 60 is left out
        set = makeTriangleSet(world);
        tree = buildExact(set, {});
        limit = depthLimit(BuildSettings{}, set.included.size());
        ASSERT_TRUE(validate(tree, set, limit).ok());
        while (!isLeaf(tree.nodes[leaf]) || leafCount(tree.nodes[leaf]) < 2) ++leaf;
    }
    void expectRefused(const std::string& words) const {
        const ValidationReport report = validate(tree, set, limit);
        ASSERT_FALSE(report.ok());
        EXPECT_NE(report.errors[0].find(words), std::string::npos) << report.errors[0];
    }
    uint32_t& listed(uint32_t i) { return tree.leafTriangles[leafFirst(tree.nodes[leaf]) + i]; }

    TriangleSet set;
    KdTree tree;
    uint32_t limit = 0, leaf = 0;  // a leaf with two triangles or more
};

// No reference is surplus in this tree, so each is needed: dropping any single one must be seen.
TEST_F(Validate, SeesEveryDroppedReference) {
    ASSERT_EQ(validate(tree, set, limit).surplusReferences, 0u);
    const KdTree sound = tree;
    uint32_t dropped = 0;
    for (KdNode& node : tree.nodes) {
        if (!isLeaf(node) || leafCount(node) == 0) continue;
        node = leafNode(leafFirst(node), leafCount(node) - 1);
        expectRefused("does not list");
        tree = sound;
        ++dropped;
    }
    EXPECT_GT(dropped, 20u);
}
// By an ulp, either way, above two leaves. A plane in empty space may move; most touch a triangle.
TEST_F(Validate, ShiftedPlane) {
    const KdTree sound = tree;
    uint32_t tried = 0, refused = 0;
    for (KdNode& node : tree.nodes) {
        if (isLeaf(node)) continue;
        const KdNode left = tree.nodes[nodeChild(node)], right = tree.nodes[nodeChild(node) + 1];
        if (!isLeaf(left) || !isLeaf(right) || leafCount(left) + leafCount(right) == 0) continue;
        bool seen = false;
        for (const bool up : {false, true}) {
            node.plane = floatBitsToUint(nextFloat(nodePosition(node), up));
            seen = seen || !validate(tree, set, limit).ok();
            node = sound.nodes[static_cast<size_t>(&node - tree.nodes.data())];
        }
        ++tried;
        refused += seen ? 1 : 0;
    }
    EXPECT_GT(tried, 20u);
    EXPECT_GT(refused * 2, tried) << "of " << tried;
}
TEST_F(Validate, SwappedChildren) {
    std::swap(tree.nodes[nodeChild(tree.nodes[0])], tree.nodes[nodeChild(tree.nodes[0]) + 1]);
    EXPECT_FALSE(validate(tree, set, limit).ok());
}
TEST_F(Validate, NoNodes) {
    tree.nodes.clear();
    expectRefused("no nodes");
}
TEST_F(Validate, ChildOutOfRange) {
    tree.nodes[0] = innerNode(0, nodePosition(tree.nodes[0]), static_cast<uint32_t>(tree.nodes.size()) - 1);
    expectRefused("out of range");
}
TEST_F(Validate, Cycle) {
    const uint32_t child = nodeChild(tree.nodes[0]);
    tree.nodes[child] = innerNode(0, nodePosition(tree.nodes[0]), 0);
    expectRefused("reached before");
}
TEST_F(Validate, UnreachableNode) {
    tree.nodes.push_back(leafNode(0, 0));
    expectRefused("cannot be reached");
}
TEST_F(Validate, PlaneOnTheFaceOfItsCell) {
    const KdNode root = tree.nodes[0];
    const int axis = static_cast<int>(nodeAxis(root));
    for (const float plane : {tree.bounds.lo[axis], tree.bounds.hi[axis], std::nanf("")}) {
        tree.nodes[0] = innerNode(nodeAxis(root), plane, nodeChild(root));
        expectRefused("strictly inside");
    }
}
TEST_F(Validate, LeafListOutOfRange) {
    tree.nodes[leaf] = leafNode(static_cast<uint32_t>(tree.leafTriangles.size()), 1);
    expectRefused("leaf list out of range");
}
TEST_F(Validate, SharedLeafList) {
    tree.nodes[leaf] = leafNode(0, static_cast<uint32_t>(tree.leafTriangles.size()));
    EXPECT_FALSE(validate(tree, set, limit).ok());
}
TEST_F(Validate, NumberOutOfRange) {
    listed(0) = 61;
    expectRefused("does not exist");
}
TEST_F(Validate, LeftOutTriangleListed) {
    listed(0) = 60;
    expectRefused("left out");
}
TEST_F(Validate, ListedTwice) {
    listed(0) = listed(1);
    expectRefused("twice");
}
TEST_F(Validate, TooDeep) {
    limit = 3;
    expectRefused("at depth");
}
TEST_F(Validate, BoundsTooSmall) {
    tree.bounds.hi.y = std::nextafter(tree.bounds.hi.y, -1.0f);
    expectRefused("root bounds");
}
TEST_F(Validate, WrongExponent) {
    ++tree.exponent;
    expectRefused("exponent");
}
TEST_F(Validate, SurplusIsCountedOnly) {
    const KdTree brute = buildBrute(set);
    tree.leafTriangles = brute.leafTriangles;
    tree.leafTriangles.insert(tree.leafTriangles.end(), brute.leafTriangles.begin(), brute.leafTriangles.end());
    tree.nodes = {innerNode(0, 0.5f * (tree.bounds.lo.x + tree.bounds.hi.x), 1), leafNode(0, 60), leafNode(60, 60)};
    const ValidationReport report = validate(tree, set, limit);
    EXPECT_TRUE(report.ok());
    EXPECT_GT(report.surplusReferences, 10u);
}

// A sheet at x = 0.5 of the unit cube, between two triangles that span it; all cells meet at the sheet.
class Sheet : public testing::Test {
  protected:
    Sheet() {
        tree.bounds = {{0, 0, 0}, {1, 1, 1}};
        set.bounds = tree.bounds;
        set.triangles = {{{0.5f, 0, 0}, {0.5f, 1, 0}, {0.5f, 0, 1}}};
        set.included = {0};
        tree.leafTriangles = {0, 0};
    }
    bool isSound() const { return validate(tree, set, 63).ok(); }
    TriangleSet set;
    KdTree tree;
};

TEST_F(Sheet, MayBeListedOnEitherSideOfItsPlane) {
    for (uint32_t lists = 0; lists < 4; ++lists) {
        SCOPED_TRACE(lists);
        tree.nodes = {innerNode(0, 0.5f, 1), leafNode(0, lists & 1), leafNode(1, lists >> 1)};
        EXPECT_EQ(isSound(), lists != 0);
    }
}
// Below the sheet y is cut, above it z; the leaf y < 0.5 below and the leaf z > 0.5 above leave a gap at y > 0.5,
// z < 0.5, where the sheet still is.
TEST_F(Sheet, MayBeSharedBetweenSidesWithoutAGap) {
    const auto build = [&](uint32_t behindLow, uint32_t behindHigh, uint32_t beforeLow, uint32_t beforeHigh) {
        tree.leafTriangles = {0, 0, 0, 0};
        tree.nodes = {innerNode(0, 0.5f, 1),   innerNode(1, 0.5f, 3),  innerNode(2, 0.5f, 5),  leafNode(0, behindLow),
                      leafNode(1, behindHigh), leafNode(2, beforeLow), leafNode(3, beforeHigh)};
    };
    build(1, 0, 1, 0);  // the gap is y > 0.5, z > 0.5: beyond the hypotenuse
    EXPECT_TRUE(isSound());
    build(1, 0, 0, 1);
    EXPECT_FALSE(isSound());
    build(0, 1, 1, 0);
    EXPECT_FALSE(isSound());
    build(1, 1, 0, 0);
    EXPECT_TRUE(isSound());
}
// Both sides are cut at y = 0.5; each lists the sheet in another half. No pair of leaves overlaps in the cut itself.
TEST_F(Sheet, MayChangeSidesAtACut) {
    tree.nodes = {innerNode(0, 0.5f, 1), innerNode(1, 0.5f, 3), innerNode(1, 0.5f, 5), leafNode(0, 1),
                  leafNode(1, 0),        leafNode(1, 0),        leafNode(1, 1)};
    EXPECT_TRUE(isSound());
    tree.nodes[6] = leafNode(1, 0);
    EXPECT_FALSE(isSound());
}
TEST_F(Sheet, OnTheBoundsOrInsideACellMustBeListed) {
    for (const float x : {0.0f, 0.5f, 1.0f})
        for (const bool listed : {false, true}) {
            set.triangles[0] = {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}};
            tree.nodes = {leafNode(0, listed ? 1 : 0)};
            tree.leafTriangles.resize(1);
            EXPECT_EQ(isSound(), listed) << x;
        }
}
TEST_F(Sheet, OfAFlatSceneMustBeListedWhereItIs) {
    tree.bounds = {{0.5f, 0, 0}, {0.5f, 1, 1}};
    tree.nodes = {innerNode(1, 0.5f, 1), leafNode(0, 1), leafNode(1, 0)};
    EXPECT_FALSE(isSound());
    tree.nodes[2] = leafNode(1, 1);
    EXPECT_TRUE(isSound());
}

// The corner is 2^-103 off the edge's line x = y, while the edge is 2 long: only the exact sum can tell the side.
TEST(Separation, DecidesWhatDoubleCannot) {
    const Triangle t{{-1, -1, 0}, {1, 1, 0}, {1, -1, 1}};
    const float x = 0x1p-80f, above = 0x1.000002p-80f, below = 0x1.fffffep-81f;
    EXPECT_TRUE(meets(t, {{-1, below, -1}, {x, 1, 2}}, Contact::interior));
    EXPECT_FALSE(meets(t, {{-1, x, -1}, {x, 1, 2}}, Contact::interior));
    EXPECT_TRUE(meets(t, {{-1, x, -1}, {x, 1, 2}}, Contact::closed));
    EXPECT_FALSE(meets(t, {{-1, above, -1}, {x, 1, 2}}, Contact::closed));
}
TEST(Separation, TouchingIsNoContactWithTheInterior) {
    const Triangle corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // x + y + z = 1
    const float below = std::nextafter(0.5f, 0.0f);
    EXPECT_FALSE(meets(corner, {{0.5f, 0.5f, 0}, {1, 1, 1}}, Contact::interior));
    EXPECT_TRUE(meets(corner, {{0.5f, 0.5f, 0}, {1, 1, 1}}, Contact::closed));
    EXPECT_TRUE(meets(corner, {{below, 0.5f, 0}, {1, 1, 1}}, Contact::interior));
    EXPECT_FALSE(meets(corner, {{0.6f, 0.6f, 0}, {1, 1, 1}}, Contact::closed));
    EXPECT_FALSE(meets(corner, {{0, 0, 0}, {0.25f, 0.25f, 0.5f}}, Contact::interior));
}

}  // namespace
}  // namespace cleave
