#include "kdtree/builders.h"
#include "kdtree/sort_keys.h"
#include "kdtree/top_down.h"

namespace cleave {
namespace {

// The best of all planes through a face of a box, by a sweep along each axis (Wald and Havran 2006, algorithm 4; survey
// section 5). Only counts matter, so the three kinds of events are three sorted lists of positions, walked together:
// at equal positions ends come before planar ones, and these before starts.
class SweepChooser {
  public:
    explicit SweepChooser(uint32_t maxDepth) : maxDepth_(maxDepth) {}

    Split operator()(const NodeToSplit& node) {
        Split best = noSplit();
        for (uint32_t axis = 0; axis < 3; ++axis) {
            gatherEvents(node, static_cast<int>(axis));
            best = sweep(best, node, axis);
        }
        const auto count = static_cast<uint32_t>(node.refs.size());
        return isWorthwhile(best, node.cell, count, node.depth, maxDepth_) ? best : noSplit();
    }

  private:
    using Keys = std::vector<uint32_t>;

    // Ordered bits keep the order of floats; boxes hold no -0.
    void gatherEvents(const NodeToSplit& node, int axis) {
        starts_.clear();
        ends_.clear();
        planars_.clear();
        for (const ClippedRef& ref : node.refs) {
            const float lo = ref.box.lo[axis], hi = ref.box.hi[axis];
            if (lo == hi) {
                planars_.push_back(orderedBits(lo));
            } else {
                starts_.push_back(orderedBits(lo));
                ends_.push_back(orderedBits(hi));
            }
        }
        for (Keys* keys : {&starts_, &ends_, &planars_}) sortKeys(*keys, scratch_);
    }

    // How many keys equal `key`, from keys[next] on; `next` moves behind them.
    static uint32_t take(const Keys& keys, size_t& next, uint32_t key) {
        const size_t first = next;
        while (next < keys.size() && keys[next] == key) ++next;
        return static_cast<uint32_t>(next - first);
    }

    Split sweep(Split best, const NodeToSplit& node, uint32_t axis) const {
        size_t start = 0, end = 0, planar = 0;
        uint32_t left = 0, right = static_cast<uint32_t>(node.refs.size());
        while (end < ends_.size() || planar < planars_.size()) {
            uint32_t key = end < ends_.size() ? ends_[end] : kNone;
            if (planar < planars_.size()) key = min(key, planars_[planar]);
            if (start < starts_.size()) key = min(key, starts_[start]);
            const uint32_t ending = take(ends_, end, key);
            const uint32_t lying = take(planars_, planar, key);
            right -= ending + lying;
            best = betterOfBothSides(best, node.cell, axis, fromOrderedBits(key), left, right, lying);
            left += take(starts_, start, key) + lying;
        }
        return best;
    }

    const uint32_t maxDepth_;
    Keys starts_, ends_, planars_, scratch_;
};

}  // namespace

KdTree buildExact(const TriangleSet& set, const BuildSettings& settings) {
    const SweepChooser chooser(depthLimit(settings, set.included.size()));
    return TopDownBuilder<SweepChooser>(set, settings, chooser).build();
}

}  // namespace cleave
