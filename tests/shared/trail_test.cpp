#include "shared/trail.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "shared/config.h"

namespace cleave {
namespace {

// The model: a bit per depth, done by loops.
using Bits = std::vector<bool>;

Trail trailOf(const Bits& bits) {
    Trail t = emptyTrail();
    for (uint d = 0; d < bits.size(); d++)
        if (bits[d]) t = withBit(t, d);
    return t;
}

void expectBits(const Trail& t, const Bits& bits) {
    for (uint d = 0; d < bits.size(); d++) ASSERT_EQ(trailBit(t, d), bits[d]) << "depth " << d;
}

bool hasOpen(const Bits& bits, uint depth) {
    for (uint d = 0; d < depth; d++)
        if (!bits[d]) return true;
    return false;
}

Bits advancedModel(Bits bits, uint depth) {
    uint d = depth - 1;
    while (bits[d]) d--;
    bits[d] = true;
    for (d++; d < bits.size(); d++) bits[d] = false;
    return bits;
}

TEST(Trail, holdsABitPerDepth) {
    for (uint depth = 0; depth < 64; depth++) {
        const Trail t = withBit(emptyTrail(), depth);
        for (uint d = 0; d < 64; d++) EXPECT_EQ(trailBit(t, d), d == depth) << depth << " " << d;
    }
    EXPECT_EQ(trailOf(Bits(64, true)).upper, 0xFFFFFFFFu);
    EXPECT_EQ(trailOf(Bits(64, true)).lower, 0xFFFFFFFFu);
}

TEST(Trail, masksWhatIsAboveADepth) {
    EXPECT_EQ(bitsBelow(0u), 0u);
    EXPECT_EQ(bitsBelow(1u), 1u);
    EXPECT_EQ(bitsBelow(31u), 0x7FFFFFFFu);
    EXPECT_EQ(bitsBelow(32u), 0xFFFFFFFFu);
}

TEST(Trail, advancesAsTheModelDoes) {
    std::mt19937 random(1);
    for (const uint depth : {1u, 2u, 12u, 30u, 31u, 32u, 33u, 34u, 61u, 62u, kMaxDepth}) {
        uint tried = 0;
        while (tried < 2000) {
            // Mostly ones, so that the search runs far and crosses from one word into the other.
            const uint zeros = static_cast<uint>(random() % 4);
            Bits bits(kMaxDepth, true);
            for (uint i = 0; i < zeros; i++) bits[random() % depth] = false;
            for (uint d = depth; d < kMaxDepth; d++) bits[d] = random() % 2 == 0;
            if (!hasOpen(bits, depth)) continue;
            tried++;
            expectBits(advanced(trailOf(bits), depth), advancedModel(bits, depth));
            if (HasFatalFailure()) FAIL() << "from depth " << depth;
        }
    }
}

// The prefix of ones stands for nodes with one child to visit; below it hangs a full binary tree.
void enumerate(uint prefix, uint height) {
    Bits bits(kMaxDepth, false);
    for (uint d = 0; d < prefix; d++) bits[d] = true;
    Trail t = trailOf(bits);
    const uint leaves = 1u << height;
    for (uint leaf = 0; leaf < leaves; leaf++) {
        uint reached = 0;
        for (uint d = prefix; d < prefix + height; d++) reached = reached << 1 | (trailBit(t, d) ? 1u : 0u);
        ASSERT_EQ(reached, leaf);
        for (uint d = 0; d < prefix; d++) ASSERT_TRUE(trailBit(t, d));
        for (uint d = prefix + height; d < kMaxDepth; d++) ASSERT_FALSE(trailBit(t, d));
        if (leaf + 1 < leaves) t = advanced(t, prefix + height);
    }
}

TEST(Trail, visitsEveryLeafOnceInOrder) {
    for (const uint prefix : {0u, 19u, 20u, 21u, 26u, 32u, 50u, 51u}) {
        enumerate(prefix, 12u);
        if (HasFatalFailure()) FAIL() << "below depth " << prefix;
    }
}

// Leaves at all depths, as real trees have them: a caterpillar whose near child is always the leaf.
TEST(Trail, climbsDownACaterpillar) {
    Trail t = emptyTrail();
    for (uint depth = 1; depth <= kMaxDepth; depth++) {
        for (uint d = 0; d < kMaxDepth; d++) ASSERT_EQ(trailBit(t, d), d + 1 < depth) << depth;
        t = advanced(t, depth);
    }
    EXPECT_EQ(t.upper, 0xFFFFFFFFu);
    EXPECT_EQ(t.lower, 0x7FFFFFFFu) << "the bit to spare stays free";
}

// And one whose near child is never the leaf: down first, then one far child per level on the way up.
TEST(Trail, climbsUpACaterpillar) {
    Trail t = emptyTrail();
    for (uint depth = kMaxDepth; depth >= 1; depth--) {
        t = advanced(t, depth);
        for (uint d = 0; d < kMaxDepth; d++) ASSERT_EQ(trailBit(t, d), d + 1 == depth) << depth;
    }
}

// What marks a finished ray is in no trail on the way, whichever bits a traversal may set.
TEST(Trail, tellsFinishedRaysFromOthers) {
    EXPECT_TRUE(isFinished(finishedTrail()));
    EXPECT_FALSE(isFinished(emptyTrail()));
    EXPECT_FALSE(isFinished(trailOf(Bits(kMaxDepth, true)))) << "one child to visit at all depths of inner nodes";
    for (uint open = 0; open < kMaxDepth; open++) {
        Bits bits(kMaxDepth, true);
        bits[open] = false;
        for (uint depth = open + 1; depth <= kMaxDepth; depth++)
            EXPECT_FALSE(isFinished(advanced(trailOf(bits), depth))) << open << " " << depth;
    }
}

}  // namespace
}  // namespace cleave
