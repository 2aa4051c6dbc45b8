#include "measure/line_counts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cleave {
namespace {

struct Part {
    double from = 0.0, to = 0.0;
    bool isEmpty() const { return !(from <= to); }
};

// Along an axis on which the direction is 0 the line is at one place: within the box, or beside it for all t.
Part clipped(Part part, double origin, double direction, double low, double high) {
    if (direction == 0.0) return low <= origin && origin <= high ? part : Part{1.0, 0.0};
    double enters = (low - origin) / direction, leaves = (high - origin) / direction;
    if (enters > leaves) std::swap(enters, leaves);
    return {std::max(part.from, enters), std::min(part.to, leaves)};
}

class Walk {
  public:
    Walk(const KdTree& tree, const Ray& ray, LineCounts& counts)
        : tree_(tree),
          origin_(dvec3(ray.origin) * std::ldexp(1.0, -tree.exponent)),
          direction_(dvec3(ray.direction) * std::ldexp(1.0, -tree.exponent)),
          counts_(counts) {}

    void from(Part part) {
        for (int axis = 0; axis < 3; ++axis)
            part = clipped(part, origin_[axis], direction_[axis], double{tree_.bounds.lo[axis]},
                           double{tree_.bounds.hi[axis]});
        if (!part.isEmpty()) visit(0, part);
    }

  private:
    const KdTree& tree_;
    const dvec3 origin_, direction_;
    LineCounts& counts_;

    void visit(uint32_t index, Part part) {
        const KdNode node = tree_.nodes[index];
        if (isLeaf(node)) {
            ++counts_.leaves;
            counts_.triangles += leafCount(node);
            return;
        }
        ++counts_.inner;
        const int axis = static_cast<int>(nodeAxis(node));
        const double plane = nodePosition(node);
        const uint32_t below = nodeChild(node), above = below + 1;
        if (direction_[axis] == 0.0) return visit(origin_[axis] < plane ? below : above, part);
        const double at = (plane - origin_[axis]) / direction_[axis];
        const bool ascends = direction_[axis] > 0.0;
        const Part first{part.from, std::min(part.to, at)}, second{std::max(part.from, at), part.to};
        if (!first.isEmpty()) visit(ascends ? below : above, first);
        if (!second.isEmpty()) visit(ascends ? above : below, second);
    }
};

}  // namespace

double LineCounts::perLine(uint64_t count) const {
    return lines > 0 ? static_cast<double>(count) / static_cast<double>(lines) : 0.0;
}

std::optional<double> LineCounts::cost(SahCosts costs) const {
    if (lines == 0) return std::nullopt;
    return double{costs.traverse} * perLine(inner) + double{costs.leaf} * perLine(leaves) +
           double{costs.intersect} * perLine(triangles);
}

void countAlong(const KdTree& tree, const Ray& ray, double from, double to, LineCounts& counts) {
    ++counts.lines;
    Walk(tree, ray, counts).from({from, to});
}

}  // namespace cleave
