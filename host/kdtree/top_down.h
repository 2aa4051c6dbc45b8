// The loop of every top-down builder on the CPU, depth first. Builders differ in how they choose a split.
#pragma once

#include <algorithm>
#include <span>

#include "kdtree/clipped_ref.h"
#include "kdtree/graft.h"

namespace cleave {

// `ChooseSplit` is a callable, Split(const NodeToSplit&); an answer with axis == kLeafAxis makes a leaf. It is asked
// only where a split is possible at all: a reference, depth to spare, and at most one collapsed axis.
template <class ChooseSplit>
class TopDownBuilder {
  public:
    TopDownBuilder(const TriangleSet& set, const BuildSettings& settings, ChooseSplit chooseSplit)
        : set_(set),
          clip_(settings.clip),
          maxDepth_(depthLimit(settings, set.included.size())),
          chooseSplit_(std::move(chooseSplit)) {}

    KdTree build() {
        refs_.resize(set_.included.size());
        for (size_t i = 0; i < refs_.size(); ++i) refs_[i] = wholeTriangle(set_, set_.included[i]);
        tree_.nodes.resize(1);
        buildNode(0, set_.bounds, 0, 0, refs_.size());
        tree_.bounds = set_.bounds;
        tree_.exponent = set_.exponent;
        return std::move(tree_);
    }

    // The subtree of a node that another loop came to, as a tree whose node 0 is that node; good until the next call.
    const KdTree& buildSubtree(const NodeToSplit& node) {
        tree_.nodes.resize(1);
        tree_.leafTriangles.clear();
        if (refs_.size() < node.refs.size()) refs_.resize(node.refs.size());
        std::copy(node.refs.begin(), node.refs.end(), refs_.begin());
        buildNode(0, node.cell, node.depth, 0, node.refs.size());
        return tree_;
    }

    // The room that references took, and the tree that was built; bytes.
    uint64_t bytes() const { return refs_.capacity() * sizeof(ClippedRef) + growthBytes(tree_); }

  private:
    // The node's references are refs_[begin, end). Below them lie those of right children that wait on the way up;
    // what lies behind them is free.
    void buildNode(uint32_t index, const Box& cell, uint32_t depth, size_t begin, size_t end) {
        Split split = noSplit();
        if (end > begin && depth < maxDepth_ && collapsedAxes(cell) < 2)
            split = chooseSplit_(NodeToSplit{std::span(refs_).subspan(begin, end - begin), cell, depth});
        if (split.axis == kLeafAxis) return makeLeaf(index, begin, end);

        const uint32_t child = appendChildren(tree_);
        tree_.nodes[index] = innerNode(split.axis, split.position, child);
        const SideEnds ends = partition(split, begin, end);
        buildNode(child, leftOf(cell, split.axis, split.position), depth + 1, end, ends.left);
        buildNode(child + 1, rightOf(cell, split.axis, split.position), depth + 1, begin, ends.right);
    }

    struct SideEnds {
        size_t left, right;
    };

    // In one pass, references of the left child are appended behind the node's, and those of the right child take the
    // node's own place, where reading is always ahead of writing. Every reference is written to both; where it is not
    // wanted the next one takes its place.
    SideEnds partition(const Split& split, size_t begin, size_t end) {
        const size_t needed = end + (end - begin);
        if (refs_.size() < needed) refs_.resize(std::max(needed, refs_.size() + refs_.size() / 2));
        const int axis = static_cast<int>(split.axis);
        ClippedRef* left = &refs_[end];
        ClippedRef* right = &refs_[begin];
        for (size_t i = begin; i < end; ++i) {
            ClippedRef ref = refs_[i];
            const uint32_t sides = sideOf(ref.box.lo[axis], ref.box.hi[axis], split.position, split.planarLeft);
            if (sides == (kLeft | kRight)) {
                const SplitBoxes parts = splitReference(set_, ref, split, clip_);
                *left = {parts.left, ref.prim};
                *right = {parts.right, ref.prim};
                left += isEmpty(parts.left) ? 0 : 1;
                right += isEmpty(parts.right) ? 0 : 1;
                continue;
            }
            *left = ref;
            *right = ref;
            left += sides & kLeft;
            right += sides >> 1;
        }
        return {static_cast<size_t>(left - refs_.data()), static_cast<size_t>(right - refs_.data())};
    }

    void makeLeaf(uint32_t index, size_t begin, size_t end) {
        beginLeaf(tree_, index, end - begin);
        for (size_t i = begin; i < end; ++i) tree_.leafTriangles.push_back(refs_[i].prim);
    }

    const TriangleSet& set_;
    const bool clip_;
    const uint32_t maxDepth_;
    ChooseSplit chooseSplit_;
    KdTree tree_;
    std::vector<ClippedRef> refs_;  // as large as it ever had to be
};

}  // namespace cleave
