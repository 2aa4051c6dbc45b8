// The loop of every top-down builder on the CPU, depth first. Builders differ in how they choose a split.
#pragma once

#include <span>

#include "error.h"
#include "kdtree/clip_box.h"
#include "kdtree/kd_tree.h"
#include "kdtree/triangle_set.h"
#include "shared/sah.h"

namespace cleave {

// A reference: a triangle, and the box of its part in the node's cell.
struct ClippedRef {
    Box box;
    uint32_t prim;
};

// What a chooser is asked about.
struct NodeToSplit {
    std::span<const ClippedRef> refs;
    Box cell;
    uint32_t depth;
};

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
        tree_.bounds = set_.bounds;
        tree_.exponent = set_.exponent;
        tree_.nodes.resize(1);
        for (const uint32_t prim : set_.included) {
            const Triangle& t = set_.triangles[prim];
            refs_.push_back({including(including(including(emptyBox(), t.a), t.b), t.c), prim});
        }
        buildNode(0, set_.bounds, 0, 0);
        return std::move(tree_);
    }

    // The subtree of a node that another loop came to, as a tree whose node 0 is that node; good until the next call.
    const KdTree& buildSubtree(const NodeToSplit& node) {
        tree_.nodes.resize(1);
        tree_.leafTriangles.clear();
        refs_.assign(node.refs.begin(), node.refs.end());
        buildNode(0, node.cell, node.depth, 0);
        return tree_;
    }

  private:
    // The node's references are refs_[begin..], on top of those of its ancestors and of their right children.
    void buildNode(uint32_t index, const Box& cell, uint32_t depth, size_t begin) {
        const size_t end = refs_.size();
        Split split = noSplit();
        if (end > begin && depth < maxDepth_ && collapsedAxes(cell) < 2)
            split = chooseSplit_(NodeToSplit{std::span(refs_).subspan(begin), cell, depth});
        if (split.axis == kLeafAxis) return makeLeaf(index, begin);

        if (tree_.nodes.size() + 2 > kMaxLink)
            throw Error("the tree outgrew 2^30 nodes while it was built; lower --max-depth");
        const auto child = static_cast<uint32_t>(tree_.nodes.size());
        tree_.nodes.resize(tree_.nodes.size() + 2);
        tree_.nodes[index] = innerNode(split.axis, split.position, child);
        const Box left = leftOf(cell, split.axis, split.position), right = rightOf(cell, split.axis, split.position);
        addChild(split, right, kRight, begin, end);
        const size_t middle = refs_.size();
        addChild(split, left, kLeft, begin, end);
        buildNode(child, left, depth + 1, middle);
        refs_.resize(middle);
        buildNode(child + 1, right, depth + 1, end);
        refs_.resize(end);
    }

    // Appends the references that go to one side, straddling ones clipped to it from the original triangle.
    void addChild(const Split& split, const Box& cell, uint32_t side, size_t begin, size_t end) {
        const int axis = static_cast<int>(split.axis);
        for (size_t i = begin; i < end; ++i) {
            ClippedRef ref = refs_[i];
            const uint32_t sides = sideOf(ref.box.lo[axis], ref.box.hi[axis], split.position, split.planarLeft);
            if ((sides & side) == 0) continue;
            if (sides == (kLeft | kRight)) {
                ref.box = clip_ ? intersection(ref.box, clippedBox(set_.triangles[ref.prim], cell))
                                : intersection(ref.box, cell);
                if (isEmpty(ref.box)) continue;
            }
            refs_.push_back(ref);
        }
    }

    void makeLeaf(uint32_t index, size_t begin) {
        const size_t first = tree_.leafTriangles.size();
        if (first + (refs_.size() - begin) > kNone)
            throw Error("the tree outgrew 2^32 references while it was built; lower --max-depth");
        tree_.nodes[index] = leafNode(static_cast<uint32_t>(first), static_cast<uint32_t>(refs_.size() - begin));
        for (size_t i = begin; i < refs_.size(); ++i) tree_.leafTriangles.push_back(refs_[i].prim);
    }

    const TriangleSet& set_;
    const bool clip_;
    const uint32_t maxDepth_;
    ChooseSplit chooseSplit_;
    KdTree tree_;
    std::vector<ClippedRef> refs_;
};

}  // namespace cleave
