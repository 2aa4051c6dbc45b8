#include "shared/kd_node.h"

#include <gtest/gtest.h>

namespace cleave {
namespace {

constexpr uint kLinks[] = {0u, 1u, 2u, 3u, 4u, 0x12345678u, kMaxLink - 1u, kMaxLink};

TEST(KdNode, innerKeepsAxisPositionAndChild) {
    const float positions[] = {0.0f, -0.0f, 1.5f, -7.25e-30f, kSmallestNormal, std::numeric_limits<float>::max()};
    for (const uint child : kLinks) {
        for (uint axis = 0; axis < 3; axis++) {
            for (const float position : positions) {
                const KdNode n = innerNode(axis, position, child);
                EXPECT_FALSE(isLeaf(n));
                EXPECT_EQ(nodeAxis(n), axis);
                EXPECT_EQ(nodeChild(n), child);
                EXPECT_EQ(floatBitsToUint(nodePosition(n)), floatBitsToUint(position));
            }
        }
    }
}

TEST(KdNode, leafKeepsFirstAndCount) {
    for (const uint count : kLinks) {
        for (const uint first : {0u, 1u, 0x7F800001u, 0x80000000u, 0xFFFFFFFFu}) {
            const KdNode n = leafNode(first, count);
            EXPECT_TRUE(isLeaf(n));
            EXPECT_EQ(nodeAxis(n), kLeafAxis);
            EXPECT_EQ(leafFirst(n), first);
            EXPECT_EQ(leafCount(n), count);
        }
    }
}

// Files and shaders read these words.
TEST(KdNode, hasTheDocumentedBits) {
    const KdNode inner = innerNode(2u, 1.0f, 5u);
    EXPECT_EQ(inner.plane, 0x3F800000u);
    EXPECT_EQ(inner.link, 5u << 2 | 2u);
    const KdNode leaf = leafNode(9u, 4u);
    EXPECT_EQ(leaf.plane, 9u);
    EXPECT_EQ(leaf.link, 4u << 2 | 3u);
    EXPECT_EQ(leafNode(0u, kMaxLink).link, 0xFFFFFFFFu);
}

}  // namespace
}  // namespace cleave
