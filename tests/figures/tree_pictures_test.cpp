#include "figures/tree_pictures.h"

#include <gtest/gtest.h>

#include "shared/shade.h"

namespace cleave::test {
namespace {

constexpr uint32_t kNearlyWhite = 0xFFF4F4F4u;

uint32_t colourOf(float x) { return packedColour(scaleColour(x)); }
uint32_t at(const Picture& picture, uint32_t x, uint32_t y) { return picture.pixels[size_t{y} * picture.width + x]; }

// 4 x 2 x 1: cut at x = 1; the right part at y = 0.5. Leaves list 4, 0 and 8 triangles.
KdTree threeCells() {
    KdTree tree;
    tree.bounds = {vec3(0), vec3(4, 2, 1)};
    tree.nodes = {innerNode(0, 1.0f, 1), leafNode(0, 4), innerNode(1, 0.5f, 3), leafNode(4, 0), leafNode(4, 8)};
    tree.leafTriangles.resize(12);
    return tree;
}

TEST(CutPicture, GoesAcrossTheShortestSide) {
    const KdTree tree = threeCells();
    const Cut cut = cutOf(tree);
    EXPECT_EQ(cut.across, 2);
    EXPECT_EQ(cut.right, 0);
    EXPECT_EQ(cut.up, 1);
    KdTree flat = tree;
    flat.bounds.hi = vec3(4, 0, 1);
    EXPECT_EQ(cutOf(flat).across, 1);
}

// 400 x 200 pixels, 100 per unit; rows count from the top, cells' edges are at their left and below.
TEST(CutPicture, ColoursCellsByTheirTriangles) {
    const KdTree tree = threeCells();
    const Picture picture = cutPicture(tree, cutOf(tree), 400, 8.0f);
    ASSERT_EQ(picture.width, 400u);
    ASSERT_EQ(picture.height, 200u);
    EXPECT_EQ(at(picture, 50, 100), colourOf(0.5f));
    EXPECT_EQ(at(picture, 250, 190), kNearlyWhite) << "an empty leaf, below";
    EXPECT_EQ(at(picture, 250, 50), colourOf(1.0f));
    EXPECT_EQ(at(picture, 99, 20), colourOf(0.5f));
    EXPECT_NE(at(picture, 100, 20), colourOf(1.0f)) << "an edge";
    EXPECT_EQ(at(picture, 101, 20), colourOf(1.0f));
    EXPECT_EQ(at(picture, 250, 151), kNearlyWhite);
    EXPECT_NE(at(picture, 250, 149), colourOf(1.0f)) << "an edge";
    EXPECT_EQ(at(picture, 250, 148), colourOf(1.0f));
}

TEST(CutPicture, FollowsThePlaneWhereASplitIsAcross) {
    KdTree tree;
    tree.bounds = {vec3(0), vec3(4, 2, 1)};
    tree.nodes = {innerNode(2, 0.25f, 1), leafNode(0, 8), leafNode(8, 4)};
    tree.leafTriangles.resize(12);
    EXPECT_EQ(at(cutPicture(tree, cutOf(tree), 400, 8.0f), 200, 100), colourOf(0.5f)) << "the upper: 0.5 is the middle";
}

TEST(CutPicture, OfATreeWithoutTriangles) {
    KdTree tree;
    tree.nodes = {leafNode(0, 0)};
    const Picture picture = cutPicture(tree, cutOf(tree), 64, 8.0f);
    EXPECT_EQ(picture.pixels.size(), size_t{picture.width} * picture.height);
}

// Rays go through tiles of 8 x 8: ray 64 is the first of the second tile.
TEST(StepsPicture, PutsRaysWhereTheirPixelsAre) {
    std::vector<StepCount> steps(256 * 256, noSteps());
    steps[0].inner = 3;
    steps[0].leaves = 1;
    steps[8].inner = 8;
    steps[64].inner = 2;
    const Picture picture = stepsPicture(steps, 256, 8.0f);
    EXPECT_EQ(at(picture, 0, 0), colourOf(0.5f));
    EXPECT_EQ(at(picture, 0, 1), colourOf(1.0f));
    EXPECT_EQ(at(picture, 8, 0), colourOf(0.25f));
    EXPECT_EQ(at(picture, 1, 0), colourOf(0.0f));
}

TEST(LeavesPicture, LeavesMissesNearlyWhite) {
    std::vector<StepCount> steps(64, noSteps());
    std::vector<Hit> hits(64, missedHit());
    steps[1].hitLeaf = steps[2].hitLeaf = 4;
    hits[2].prim = 7;
    const Picture picture = leavesPicture(steps, hits, 8, 8.0f);
    EXPECT_EQ(at(picture, 1, 0), kNearlyWhite);
    EXPECT_EQ(at(picture, 2, 0), colourOf(0.5f));
}

}  // namespace
}  // namespace cleave::test
