// A tree that is kept comes back as it was; whatever else the bytes may be is refused in a sentence, never a crash.
#include "tree/tree_bytes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "base/error.h"
#include "base/hash.h"
#include "support/small_scenes.h"

namespace cleave {
namespace {

constexpr size_t kNodesAt = 14 * 4;

// Three levels by hand; what matters is the shape.
struct Kept {
    std::vector<Triangle> world = test::soup(3, 4, 0.5f);
    TriangleSet set = makeTriangleSet(world);
    KdTree tree;
    std::vector<std::byte> bytes;

    Kept() {
        tree.bounds = set.bounds;
        tree.exponent = set.exponent;
        tree.nodes = {innerNode(0, 0.25f, 1), leafNode(0, 2), innerNode(1, 0.5f, 3), leafNode(2, 3), leafNode(5, 0)};
        tree.leafTriangles = {0, 3, 1, 2, 3};
        bytes = bytesOfTree(tree, world);
    }
    KdTree load() const { return treeOfBytes(bytes, world, set); }
    std::string failure() const {
        try {
            load();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    // As a forger would: the checksum fits again.
    void sign() {
        Hash hash;
        const size_t words = bytes.size() / 4 - 2;
        for (size_t i = 0; i < words; ++i) {
            uint32_t word;
            std::memcpy(&word, &bytes[4 * i], 4);
            hash.add(word);
        }
        const uint64_t value = hash.value();
        std::memcpy(&bytes[4 * words], &value, 8);
    }
    std::string failureWith(const std::function<void(KdTree&)>& change) {
        KdTree changed = tree;
        change(changed);
        Kept other = *this;
        other.bytes = bytesOfTree(changed, world);
        return other.failure();
    }
};

TEST(TreeBytes, ComeBackAsTheTree) {
    const Kept kept;
    const KdTree loaded = kept.load();
    EXPECT_EQ(treeHash(loaded), treeHash(kept.tree));
    EXPECT_EQ(loaded.exponent, kept.tree.exponent);
    EXPECT_EQ(std::memcmp(&loaded.bounds, &kept.tree.bounds, sizeof(Box)), 0);
    EXPECT_EQ(loaded.leafTriangles, kept.tree.leafTriangles);
}

TEST(TreeBytes, ComeBackForAnEmptyScene) {
    const std::vector<Triangle> none;
    const TriangleSet set = makeTriangleSet(none);
    KdTree tree;
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    tree.nodes = {leafNode(0, 0)};
    EXPECT_EQ(treeOfBytes(bytesOfTree(tree, none), none, set).nodes.size(), 1u);
}

TEST(TreeBytes, AreRefusedAtEachShorterSize) {
    const Kept kept;
    for (size_t size = 0; size < kept.bytes.size(); ++size) {
        Kept cut = kept;
        cut.bytes.resize(size);
        EXPECT_NE(cut.failure(), "") << size << " bytes";
    }
    Kept longer = kept;
    longer.bytes.resize(kept.bytes.size() + 4);
    EXPECT_NE(longer.failure(), "");
}

TEST(TreeBytes, AreRefusedWhereAnyBitDiffers) {
    const Kept kept;
    for (size_t at = 0; at < kept.bytes.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            Kept flipped = kept;
            flipped.bytes[at] ^= std::byte(1 << bit);
            EXPECT_NE(flipped.failure(), "") << "byte " << at << ", bit " << bit;
        }
}

// Whatever a forger writes is a tree that can be walked, or is refused.
TEST(TreeBytes, ThatAreForgedAreWalkableOrRefused) {
    const Kept kept;
    int loaded = 0;
    for (size_t at = 0; at + 8 < kept.bytes.size(); ++at)
        for (const int value : {0, 1, 2, 3, 4, 7, 64, 127, 128, 255}) {
            Kept forged = kept;
            forged.bytes[at] = std::byte(value);
            forged.sign();
            if (forged.failure() != "") continue;
            ++loaded;
            const KdTree tree = forged.load();
            for (const KdNode& node : tree.nodes) {
                ASSERT_TRUE(isLeaf(node) || nodeChild(node) + 1 < tree.nodes.size());
                ASSERT_TRUE(!isLeaf(node) || leafFirst(node) + leafCount(node) <= tree.leafTriangles.size());
            }
            for (const uint32_t number : tree.leafTriangles) ASSERT_LT(number, 4u);
        }
    EXPECT_GT(loaded, 100) << "planes may be anywhere";
}

TEST(TreeBytes, SayWhatIsWrong) {
    Kept kept;
    const auto fails = [&](const char* with, const std::function<void(KdTree&)>& change) {
        EXPECT_NE(kept.failureWith(change).find(with), std::string::npos) << kept.failureWith(change);
    };
    fails("node 8 is not there", [](KdTree& t) { t.nodes[2] = innerNode(1, 0.5f, 8); });
    fails("node 1 is reached twice", [](KdTree& t) { t.nodes[2] = innerNode(1, 0.5f, 1); });
    fails("never reached", [](KdTree& t) { t.nodes[2] = leafNode(0, 1); });
    fails("more references than there are", [](KdTree& t) { t.nodes[4] = leafNode(5, 1); });
    fails("more references than there are", [](KdTree& t) { t.nodes[4] = leafNode(0xFFFFFFFFu, 2); });
    fails("plane that is not finite", [](KdTree& t) { t.nodes[0] = innerNode(0, infinity(), 1); });
    fails("lists triangle 4 of 4", [](KdTree& t) { t.leafTriangles[4] = 4; });
    fails("is too deep", [](KdTree& t) {
        t.nodes.clear();
        for (uint32_t i = 0; i < 70; ++i) {
            t.nodes.push_back(innerNode(0, 0.5f, 2 * i + 1));
            if (i > 0) t.nodes.push_back(leafNode(0, 0));
        }
        t.nodes.push_back(leafNode(0, 0));
        t.nodes.push_back(leafNode(0, 0));
    });
    fails("bounds are not those", [](KdTree& t) { t.bounds.hi.x += 1.0f; });
    fails("bounds are not those", [](KdTree& t) { t.exponent += 1; });
    Kept other = kept;
    other.world[0].a.x += 1.0f;
    EXPECT_NE(other.failure().find("other triangles"), std::string::npos);
    other = kept;
    other.bytes[4] = std::byte(9);
    EXPECT_NE(other.failure().find("its format is 9"), std::string::npos);
    other = kept;
    other.bytes[kNodesAt] ^= std::byte(1);
    EXPECT_NE(other.failure().find("checksum"), std::string::npos);
}

}  // namespace
}  // namespace cleave
