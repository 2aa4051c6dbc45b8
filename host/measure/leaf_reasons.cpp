#include "measure/leaf_reasons.h"

#include <algorithm>
#include <span>
#include <vector>

#include "shared/sah.h"
#include "tree/clipped_ref.h"
#include "tree/walk.h"

namespace cleave {
namespace {

using Refs = std::vector<ClippedRef>;

// The faces of boxes along an axis, ascending.
struct Faces {
    std::vector<float> los, his, planes;  // `planes` of the boxes that are flat

    Faces(std::span<const ClippedRef> refs, int axis) {
        for (const ClippedRef& ref : refs) {
            los.push_back(ref.box.lo[axis]);
            his.push_back(ref.box.hi[axis]);
            if (los.back() == his.back()) planes.push_back(los.back());
        }
        for (std::vector<float>* faces : {&los, &his, &planes}) std::sort(faces->begin(), faces->end());
    }
};

// Number of the ascending values that lie in [lo, hi].
uint32_t countWithin(const std::vector<float>& values, float lo, float hi) {
    const auto first = std::lower_bound(values.begin(), values.end(), lo);
    return static_cast<uint32_t>(std::upper_bound(first, values.end(), hi) - first);
}

// The best of all faces; kLeafAxis if none lies strictly inside the cell.
Split bestSplit(SahCosts costs, const Box& cell, std::span<const ClippedRef> refs) {
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const Faces faces(refs, static_cast<int>(axis));
        const auto count = static_cast<uint32_t>(refs.size());
        const auto consider = [&](float position) {
            const uint32_t planar = countWithin(faces.planes, position, position);
            const uint32_t left = count - countWithin(faces.los, position, infinity());
            const uint32_t right = count - countWithin(faces.his, -infinity(), position);
            best = betterOfBothSides(best, costs, cell, axis, position, left, right, planar);
        };
        for (const float face : faces.los) consider(face);
        for (const float face : faces.his) consider(face);
    }
    return best;
}

bool areIdentical(std::span<const ClippedRef> refs) {
    const auto isFirst = [&](const ClippedRef& r) { return r.box.lo == refs[0].box.lo && r.box.hi == refs[0].box.hi; };
    return refs.size() > 1 && std::all_of(refs.begin(), refs.end(), isFirst);
}

// Descends the tree with the references of each cell, clipped as builders clip them.
class Walk {
  public:
    Walk(const KdTree& tree, const TriangleSet& set, const BuildSettings& settings)
        : tree_(tree),
          set_(set),
          costs_(splitCosts(settings)),
          clip_(settings.clip),
          maxDepth_(depthLimit(settings, set.included.size())) {}

    LeafReasons count() {
        Refs refs;
        for (const uint32_t prim : set_.included) refs.push_back(wholeTriangle(set_, prim));
        visit(rootVisit(tree_), refs);
        return reasons_;
    }

  private:
    void visit(const NodeVisit& at, const Refs& refs) {
        const KdNode node = tree_.nodes[at.node];
        if (isLeaf(node)) {
            ++reasonOf(listed(node, refs), at.cell, at.depth);
            return;
        }
        const Split split{0.0f, nodeAxis(node), nodePosition(node), 1u};
        const std::array<NodeVisit, 2> children = childVisits(tree_, at);
        visit(children[0], onSide(refs, split, kLeft));
        visit(children[1], onSide(refs, split, kRight));
    }

    // The tree does not say to which side planar references went: both sides keep them, and leaf lists decide.
    Refs onSide(const Refs& refs, const Split& split, uint32_t side) const {
        Refs kept;
        const int axis = static_cast<int>(split.axis);
        for (ClippedRef ref : refs) {
            const float lo = ref.box.lo[axis], hi = ref.box.hi[axis];
            const bool isPlanar = lo == hi && lo == split.position;
            const uint32_t sides = sideOf(lo, hi, split.position, split.planarLeft);
            if (!isPlanar && (sides & side) == 0) continue;
            if (sides == (kLeft | kRight)) {
                const SplitBoxes parts = splitReference(set_, ref, split, clip_);
                ref.box = side == kLeft ? parts.left : parts.right;
                if (isEmpty(ref.box)) continue;
            }
            kept.push_back(ref);
        }
        return kept;
    }

    Refs listed(KdNode leaf, const Refs& refs) const {
        const auto first = tree_.leafTriangles.begin() + leafFirst(leaf);
        std::vector<uint32_t> list(first, first + leafCount(leaf));
        std::sort(list.begin(), list.end());
        Refs kept;
        for (const ClippedRef& ref : refs)
            if (std::binary_search(list.begin(), list.end(), ref.prim)) kept.push_back(ref);
        return kept;
    }

    uint64_t& reasonOf(const Refs& refs, const Box& cell, uint32_t depth) {
        if (refs.empty()) return reasons_.empty;
        if (depth >= maxDepth_) return reasons_.depthLimit;
        if (collapsedAxes(cell) > 1) return reasons_.collapsedAxes;
        const Split best = bestSplit(costs_, cell, refs);
        if (best.axis == kLeafAxis) return areIdentical(refs) ? reasons_.identicalBoxes : reasons_.noPlane;
        const auto count = static_cast<uint32_t>(refs.size());
        return isWorthwhile(costs_, best, cell, count, depth, maxDepth_) ? reasons_.wouldPay : reasons_.cost;
    }

    const KdTree& tree_;
    const TriangleSet& set_;
    const SahCosts costs_;
    const bool clip_;
    const uint32_t maxDepth_;
    LeafReasons reasons_;
};

}  // namespace

LeafReasons countLeafReasons(const KdTree& tree, const TriangleSet& set, const BuildSettings& settings) {
    return Walk(tree, set, settings).count();
}

}  // namespace cleave
