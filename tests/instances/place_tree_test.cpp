#include "instances/place_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cleave::test {
namespace {

std::vector<Box> anyBoxes(size_t n, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::vector<Box> boxes;
    for (size_t i = 0; i < n; ++i) {
        const vec3 lo(unit(random), i % 3 == 0 ? 0.0f : unit(random), unit(random));
        boxes.push_back({lo, lo + vec3(0.1f, 0.0f, 0.2f)});
    }
    return boxes;
}

bool isWithin(const Box& a, const Box& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.lo[axis] < b.lo[axis] || a.hi[axis] > b.hi[axis]) return false;
    return true;
}

TEST(PlaceTree, HoldsEveryBoxOnceWithinAllAboveIt) {
    for (size_t n = 0; n < 70; ++n) {
        const std::vector<Box> boxes = anyBoxes(n, uint32_t(n));
        const PlaceTree tree = placeTreeOf(boxes);
        ASSERT_EQ(tree.nodes.size(), n == 0 ? 0 : 2 * n - 1);
        std::vector<uint32_t> order = tree.order;
        std::sort(order.begin(), order.end());
        for (uint32_t i = 0; i < n; ++i) {
            ASSERT_EQ(order[i], i);
            const size_t leaf = n + i;
            ASSERT_EQ(tree.nodes[leaf - 1].box.lo, boxes[tree.order[i]].lo);
            ASSERT_EQ(tree.nodes[leaf - 1].box.hi, boxes[tree.order[i]].hi);
            for (size_t node = leaf; node > 1; node /= 2)
                ASSERT_TRUE(isWithin(tree.nodes[node - 1].box, tree.nodes[node / 2 - 1].box));
        }
    }
}

// A ray that goes up an axis meets the first child first.
TEST(PlaceTree, PutsTheLowerHalfFirst) {
    const size_t n = 37;
    const PlaceTree tree = placeTreeOf(anyBoxes(n, 5));
    for (size_t node = 1; node < n; ++node) {
        const uint32_t axis = tree.nodes[node - 1].axis;
        float centre[2][2] = {{1e9f, -1e9f}, {1e9f, -1e9f}};
        for (size_t leaf = n; leaf < 2 * n; ++leaf) {
            size_t above = leaf;
            while (above / 2 > node) above /= 2;
            if (above / 2 != node) continue;
            const Box& box = tree.nodes[leaf - 1].box;
            const float c = 0.5f * (box.lo[axis] + box.hi[axis]);
            centre[above & 1][0] = std::min(centre[above & 1][0], c);
            centre[above & 1][1] = std::max(centre[above & 1][1], c);
        }
        ASSERT_LE(centre[0][1], centre[1][0]) << "node " << node;
    }
}

TEST(PlaceTree, TakesBoxesInOnePlace) {
    const PlaceTree tree = placeTreeOf(std::vector<Box>(1000, {vec3(0.5f), vec3(0.5f)}));
    EXPECT_EQ(tree.nodes.size(), 1999u);
}

}  // namespace
}  // namespace cleave::test
