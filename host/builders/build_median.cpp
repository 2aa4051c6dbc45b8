#include <algorithm>
#include <array>

#include "builders/builders.h"
#include "builders/top_down.h"

namespace cleave {
namespace {

// Chooses the position of a node's plane along an axis. Only planes strictly inside the cell are used.
class SpatialMedian {
  public:
    float operator()(const NodeToSplit& node, int axis) const {
        return 0.5f * (node.cell.lo[axis] + node.cell.hi[axis]);
    }
};

class ObjectMedian {
  public:
    float operator()(const NodeToSplit& node, int axis) {
        centres_.clear();
        for (const ClippedRef& ref : node.refs) centres_.push_back(0.5f * (ref.box.lo[axis] + ref.box.hi[axis]));
        const auto middle = centres_.begin() + static_cast<std::ptrdiff_t>(centres_.size() / 2);
        std::nth_element(centres_.begin(), middle, centres_.end());
        return *middle;
    }

  private:
    std::vector<float> centres_;
};

// The plane through `position`, planar references on the side where that costs less; no split if it cannot be.
Split splitAt(const NodeToSplit& node, uint32_t axis, float position) {
    const int a = static_cast<int>(axis);
    uint32_t left = 0, right = 0, planar = 0;
    for (const ClippedRef& ref : node.refs) {
        const float lo = ref.box.lo[a], hi = ref.box.hi[a];
        left += lo < position ? 1u : 0u;
        right += hi > position ? 1u : 0u;
        planar += lo == position && hi == position ? 1u : 0u;
    }
    return betterOfBothSides(noSplit(), node.costs, node.cell, axis, position, left, right, planar);
}

template <class Median>
class MedianChooser {
  public:
    explicit MedianChooser(const BuildSettings& settings) : axes_(settings.axes), leafSize_(settings.leafSize) {}

    Split operator()(const NodeToSplit& node) {
        if (node.refs.size() <= leafSize_) return noSplit();
        Split best = noSplit();
        for (const uint32_t axis : axesToTry(node)) {
            if (node.cell.hi[static_cast<int>(axis)] - node.cell.lo[static_cast<int>(axis)] < kSmallestNormal) continue;
            const Split split = splitAt(node, axis, flushed(median_(node, static_cast<int>(axis))));
            if (isBetter(split, best)) best = split;
            if (axes_ != AxisChoice::all && best.axis != kLeafAxis) break;
        }
        return best.axis != kLeafAxis && mayGrow(node, best) ? best : noSplit();
    }

  private:
    // All axes: where only one is wanted, the others follow in case it cannot be split.
    std::array<uint32_t, 3> axesToTry(const NodeToSplit& node) const {
        if (axes_ == AxisChoice::cycle) return {node.depth % 3, (node.depth + 1) % 3, (node.depth + 2) % 3};
        std::array<uint32_t, 3> axes{0, 1, 2};
        const vec3 extent = node.cell.hi - node.cell.lo;
        if (axes_ == AxisChoice::widest)
            std::stable_sort(axes.begin(), axes.end(), [&](uint32_t a, uint32_t b) {
                return extent[static_cast<int>(a)] > extent[static_cast<int>(b)];
            });
        return axes;
    }

    // Without costs, nothing else ends the splitting of triangles that all reach through the cell: each split would
    // copy them all. A path from the root may multiply its references by at most kMaxGrowth; then so may the tree.
    // Nodes come in depth first, so the entry of a node's depth is its parent's.
    bool mayGrow(const NodeToSplit& node, const Split& split) {
        size_t children = 0;
        for (const ClippedRef& ref : node.refs) {
            const int axis = static_cast<int>(split.axis);
            const uint32_t sides = sideOf(ref.box.lo[axis], ref.box.hi[axis], split.position, split.planarLeft);
            children += sides == (kLeft | kRight) ? 2u : 1u;
        }
        if (node.depth == 0) growth_[0] = 1.0;
        growth_[node.depth + 1] =
            growth_[node.depth] * static_cast<double>(children) / static_cast<double>(node.refs.size());
        return growth_[node.depth + 1] <= kMaxGrowth;
    }

    static constexpr double kMaxGrowth = 16.0;
    const AxisChoice axes_;
    const uint32_t leafSize_;
    Median median_;
    std::array<double, kMaxDepth + 1> growth_{};
};

template <class Median>
KdTree buildMedian(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildTopDown(set, settings, MedianChooser<Median>(settings), report);
}

}  // namespace

KdTree buildSpatialMedian(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildMedian<SpatialMedian>(set, settings, report);
}

KdTree buildObjectMedian(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildMedian<ObjectMedian>(set, settings, report);
}

}  // namespace cleave
