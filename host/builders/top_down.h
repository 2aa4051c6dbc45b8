// The loop of every top-down builder on the CPU, depth first. Builders differ in how they choose a split.
#pragma once

#include <algorithm>

#include "builders/builders.h"
#include "builders/counted_array.h"
#include "builders/graft.h"
#include "tree/clipped_ref.h"

namespace cleave {

// `ChooseSplit` is a callable, Split(const NodeToSplit&); an answer with axis == kLeafAxis makes a leaf. It is asked
// only where a split is possible at all: a reference, depth to spare, and at most one collapsed axis.
//
// All references of a build lie in one pool, as a stack: nothing is allocated per node.
template <class ChooseSplit>
class TopDownBuilder {
  public:
    TopDownBuilder(const TriangleSet& set, const BuildSettings& settings, ChooseSplit chooseSplit, ByteCount& bytes)
        : set_(set),
          bytes_(bytes),
          costs_(splitCosts(settings)),
          clip_(settings.clip),
          maxDepth_(depthLimit(settings, set.included.size())),
          chooseSplit_(std::move(chooseSplit)) {}

    // The tree over the whole set.
    KdTree build() {
        const size_t count = set_.included.size();
        enlargePool(0, 2 * count);
        for (size_t i = 0; i < count; ++i) pool_[i] = wholeTriangle(set_, set_.included[i]);
        tree_.nodes.resize(1);
        buildNode(0, set_.bounds, 0, 0, count);
        tree_.bounds = set_.bounds;
        tree_.exponent = set_.exponent;
        return std::move(tree_);
    }

    // Continues a partial tree: builds the subtree at `node` from the first `count` references of a pool that holds
    // `capacity`.
    KdTree build(KdTree tree, uint32_t node, const Box& cell, uint32_t depth, CountedArray<ClippedRef> pool,
                 size_t count, size_t capacity) {
        tree_ = std::move(tree);
        pool_ = std::move(pool);
        capacity_ = capacity;
        buildNode(node, cell, depth, 0, count);
        return std::move(tree_);
    }

    // Builds the subtree of a node as a tree of its own, whose node 0 is that node. The result is valid until the next
    // call.
    const KdTree& buildSubtree(const NodeToSplit& node) {
        tree_.nodes.resize(1);
        tree_.leafTriangles.clear();
        if (capacity_ < 2 * node.refs.size()) enlargePool(0, 2 * node.refs.size());
        std::copy(node.refs.begin(), node.refs.end(), pool_.data());
        buildNode(0, node.cell, node.depth, 0, node.refs.size());
        return tree_;
    }

  private:
    // The node's references are pool_[begin, end). Those of pending right children come before them; the rest of the
    // pool is free.
    void buildNode(uint32_t index, const Box& cell, uint32_t depth, size_t begin, size_t end) {
        Split split = noSplit();
        if (end > begin && depth < maxDepth_ && collapsedAxes(cell) < 2)
            split = chooseSplit_(NodeToSplit{{pool_.data() + begin, end - begin}, cell, depth, costs_});
        if (split.axis == kLeafAxis) return makeLeaf(index, begin, end);

        const uint32_t child = appendChildren(tree_);
        tree_.nodes[index] = innerNode(split.axis, split.position, child);
        if (capacity_ < 2 * end - begin) enlargePool(end, std::max(2 * end - begin, capacity_ + capacity_ / 2));
        // The left child's references are appended after the node's; the right child's overwrite the node's own.
        ClippedRef* const pool = pool_.data();
        const ChildEnds ends = partition(set_, {pool + begin, end - begin}, split, clip_, {pool + end, pool + begin});
        const auto leftEnd = static_cast<size_t>(ends.left - pool), rightEnd = static_cast<size_t>(ends.right - pool);
        buildNode(child, leftOf(cell, split.axis, split.position), depth + 1, end, leftEnd);
        buildNode(child + 1, rightOf(cell, split.axis, split.position), depth + 1, begin, rightEnd);
    }

    void makeLeaf(uint32_t index, size_t begin, size_t end) {
        beginLeaf(tree_, index, end - begin);
        for (size_t i = begin; i < end; ++i) tree_.leafTriangles.push_back(pool_[i].prim);
    }

    // Enlarges the pool to `capacity` references; the first `kept` stay.
    void enlargePool(size_t kept, size_t capacity) {
        CountedArray<ClippedRef> pool(capacity, bytes_);
        std::copy(pool_.data(), pool_.data() + kept, pool.data());
        pool_ = std::move(pool);
        capacity_ = capacity;
    }

    const TriangleSet& set_;
    ByteCount& bytes_;
    const SahCosts costs_;
    const bool clip_;
    const uint32_t maxDepth_;
    ChooseSplit chooseSplit_;
    KdTree tree_;
    CountedArray<ClippedRef> pool_;
    size_t capacity_ = 0;
};

template <class ChooseSplit>
KdTree buildTopDown(const TriangleSet& set, const BuildSettings& settings, ChooseSplit chooseSplit,
                    BuildReport* report) {
    ByteCount bytes;
    KdTree tree = TopDownBuilder<ChooseSplit>(set, settings, std::move(chooseSplit), bytes).build();
    if (report != nullptr) *report = {bytes.peak() + growthBytes(tree)};
    return tree;
}

}  // namespace cleave
