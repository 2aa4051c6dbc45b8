#include "builders/graft.h"

#include "base/error.h"

namespace cleave {
namespace {

void requireNodes(size_t count) {
    if (count > kMaxLink) throw Error("the tree outgrew 2^30 nodes while it was built; allow less depth");
}
void requireReferences(size_t count) {
    if (count > kNone) throw Error("the tree outgrew 2^32 references while it was built; allow less depth");
}

}  // namespace

void graft(KdTree& tree, uint32_t at, const KdTree& subtree) {
    requireNodes(tree.nodes.size() + subtree.nodes.size());
    requireReferences(tree.leafTriangles.size() + subtree.leafTriangles.size());
    const auto base = static_cast<uint32_t>(tree.nodes.size() - 1);  // the subtree's node 1 follows the last one
    const auto firstReference = static_cast<uint32_t>(tree.leafTriangles.size());
    const auto moved = [&](const KdNode& node) {
        if (isLeaf(node)) return leafNode(leafFirst(node) + firstReference, leafCount(node));
        return innerNode(nodeAxis(node), nodePosition(node), nodeChild(node) + base);
    };
    tree.nodes[at] = moved(subtree.nodes[0]);
    for (size_t i = 1; i < subtree.nodes.size(); ++i) tree.nodes.push_back(moved(subtree.nodes[i]));
    tree.leafTriangles.insert(tree.leafTriangles.end(), subtree.leafTriangles.begin(), subtree.leafTriangles.end());
}

uint32_t appendChildren(KdTree& tree) {
    const size_t child = tree.nodes.size();
    requireNodes(child + 2);
    tree.nodes.resize(child + 2);
    return static_cast<uint32_t>(child);
}

void beginLeaf(KdTree& tree, uint32_t at, size_t count) {
    requireReferences(tree.leafTriangles.size() + count);
    tree.nodes[at] = leafNode(static_cast<uint32_t>(tree.leafTriangles.size()), static_cast<uint32_t>(count));
}

uint64_t growthBytes(const KdTree& tree) {
    const uint64_t held = tree.nodes.capacity() * sizeof(KdNode) + tree.leafTriangles.capacity() * sizeof(uint32_t);
    return held + held / 2;
}

}  // namespace cleave
