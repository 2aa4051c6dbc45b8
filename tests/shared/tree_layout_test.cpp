#include "shared/tree_layout.h"

#include <gtest/gtest.h>

namespace cleave {
namespace {

uint64_t bytesOf(uvec2 words) { return uint64_t{words.y} << 32 | words.x; }

// No part overlaps the next, and no part is more than 15 bytes away from it.
TEST(TreeLayout, PartsFollowEachOther) {
    for (const uint n : {0u, 1u, 2u, 3u, 4u, 5u, 1000u, 12'700'002u, kMaxLink}) {
        const TreeLayout l = treeLayout(n, n, n);
        const auto expectPart = [](uint from, uint to, uint64_t bytes) {
            EXPECT_GE(uint64_t{16} * to, uint64_t{16} * from + bytes);
            EXPECT_LT(uint64_t{16} * to, uint64_t{16} * from + bytes + 16);
        };
        expectPart(0, l.triangles, sizeof(TreeData));
        expectPart(l.triangles, l.nodes, uint64_t{n} * sizeof(TreeTriangle));
        expectPart(l.nodes, l.leafRefs, uint64_t{n} * sizeof(KdNode));
        expectPart(l.leafRefs, l.end, uint64_t{n} * 4);
        EXPECT_EQ(bytesOf(treeBytes(n, n, n)), uint64_t{16} * l.end);
    }
}

TEST(TreeLayout, BytesHaveMoreThan32Bits) { EXPECT_EQ(bytesOf(bytesOfBlocks(0x30000001u)), 0x300000010u); }

}  // namespace
}  // namespace cleave
