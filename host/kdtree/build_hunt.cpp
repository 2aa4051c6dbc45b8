#include <algorithm>
#include <array>
#include <utility>

#include "kdtree/adaptive_samples.h"
#include "kdtree/builders.h"
#include "kdtree/top_down.h"

namespace cleave {
namespace {

// Figures of the paper (Hunt, Mark and Stoll 2006).
constexpr uint32_t kSamples = 8;        // uniform ones; as many are placed adaptively
constexpr size_t kExactBoxes = 36;      // at so many and fewer the cost is too rough to be sampled
constexpr size_t kOneAxisAbove = 1024;  // hybrid: large nodes are sampled along one axis only

// Ours: where the longest axis has no split worth its cost, larger nodes are tried along the others. (Sponza's tree
// costs 54 % more than the exact one without that, 12 % with it; in smaller nodes it does not pay.)
constexpr size_t kOtherAxesAbove = 4;

enum class SampledAxes { all, hybrid, one };

class SampleChooser {
  public:
    SampleChooser(SampledAxes axes, uint32_t maxDepth) : axes_(axes), maxDepth_(maxDepth) {}

    Split operator()(const NodeToSplit& node) {
        const size_t n = node.refs.size();
        const bool oneAxis = axes_ == SampledAxes::one || (axes_ == SampledAxes::hybrid && n > kOneAxisAbove);
        Split best = noSplit();
        for (const uint32_t axis : longestFirst(node.cell)) {
            gather(node, static_cast<int>(axis));
            best = n <= kExactBoxes ? scanFaces(best, node, axis) : search(best, node, axis);
            if (oneAxis && (n <= kOtherAxesAbove || isWorthwhile(node, best))) break;
        }
        return isWorthwhile(node, best) ? best : noSplit();
    }

  private:
    bool isWorthwhile(const NodeToSplit& node, const Split& split) const {
        return cleave::isWorthwhile(split, node.cell, static_cast<uint32_t>(node.refs.size()), node.depth, maxDepth_);
    }

    static std::array<uint32_t, 3> longestFirst(const Box& cell) {
        const vec3 extent = cell.hi - cell.lo;
        std::array<uint32_t, 3> axes{0, 1, 2};
        const auto order = [&](size_t a, size_t b) {
            if (extent[static_cast<int>(axes[a])] < extent[static_cast<int>(axes[b])]) std::swap(axes[a], axes[b]);
        };
        order(0, 1);
        order(1, 2);
        order(0, 1);
        return axes;
    }

    void gather(const NodeToSplit& node, int axis) {
        lo_.resize(node.refs.size());
        hi_.resize(node.refs.size());
        flat_.clear();
        float from = infinity(), to = -infinity();
        for (size_t i = 0; i < lo_.size(); ++i) {
            const float lo = node.refs[i].box.lo[axis], hi = node.refs[i].box.hi[axis];
            lo_[i] = lo;
            hi_[i] = hi;
            from = min(from, lo);
            to = max(to, hi);
            if (lo == hi) flat_.push_back(lo);
        }
        from_ = from;
        to_ = to;
    }

    uint32_t planarAt(float position) const {
        uint32_t planar = 0;
        for (const float flat : flat_) planar += flat == position ? 1u : 0u;
        return planar;
    }

    // The best of the candidates in samples_, of which only the positions are known.
    Split bestCandidate(Split best, const NodeToSplit& node, uint32_t axis) {
        countSides({lo_, hi_}, samples_);
        for (const CostSample& s : samples_)
            best = betterOfBothSides(best, node.cell, axis, s.position, s.left, s.right, planarAt(s.position));
        return best;
    }

    // Every face of every box. Quadratic, and for so few boxes faster than sorting them.
    Split scanFaces(Split best, const NodeToSplit& node, uint32_t axis) {
        const float from = node.cell.lo[static_cast<int>(axis)], to = node.cell.hi[static_cast<int>(axis)];
        samples_.resize(2 * lo_.size());
        size_t inside = 0;
        for (const auto* faces : {&lo_, &hi_})
            for (const float position : *faces) {
                samples_[inside].position = position;
                inside += (from < position) & (position < to) ? 1u : 0u;  // without a branch: no telling which it is
            }
        samples_.resize(inside);
        return bestCandidate(best, node, axis);
    }

    Split search(Split best, const NodeToSplit& node, uint32_t axis) {
        const auto n = static_cast<uint32_t>(lo_.size());
        best = betterOf(best, node.cell, axis, from_, 0, n, 0);  // what is empty before the boxes or behind them
        best = betterOf(best, node.cell, axis, to_, n, 0, 1);
        if (!(from_ < to_)) return best;
        takeAdaptiveSamples({lo_, hi_}, from_, to_, kSamples, samples_);
        Valley deepest{from_, infinity()};
        for (size_t i = 1; i < samples_.size(); ++i) {
            const Valley valley = valleyBetween(samples_[i - 1], samples_[i], node.cell, axis);
            if (valley.cost < deepest.cost) deepest = valley;
        }
        samples_.clear();
        for (const float face : facesAround(deepest.position)) samples_.push_back({face, 0, 0});
        return bestCandidate(best, node, axis);
    }

    // The nearest faces before and behind a position. Between them the cost is affine: it is least at one of them.
    std::array<float, 2> facesAround(float position) const {
        const float none = infinity();
        float loBefore = -none, hiBefore = -none, loBehind = none, hiBehind = none;  // four, to wait less for each
        for (size_t i = 0; i < lo_.size(); ++i) {
            const float lo = lo_[i], hi = hi_[i];
            loBefore = max(loBefore, lo <= position ? lo : -none);
            hiBefore = max(hiBefore, hi <= position ? hi : -none);
            loBehind = min(loBehind, lo >= position ? lo : none);
            hiBehind = min(hiBehind, hi >= position ? hi : none);
        }
        return {max(loBefore, hiBefore), min(loBehind, hiBehind)};
    }

    const SampledAxes axes_;
    const uint32_t maxDepth_;
    std::vector<float> lo_, hi_;     // of the node's boxes, along one axis
    std::vector<float> flat_;        // where boxes without extent lie
    float from_ = 0.0f, to_ = 0.0f;  // of all the boxes
    std::vector<CostSample> samples_;
};

KdTree buildHunt(const TriangleSet& set, const BuildSettings& settings, SampledAxes axes) {
    const SampleChooser chooser(axes, depthLimit(settings, set.included.size()));
    return TopDownBuilder<SampleChooser>(set, settings, chooser).build();
}

}  // namespace

KdTree buildHuntAll(const TriangleSet& set, const BuildSettings& settings) {
    return buildHunt(set, settings, SampledAxes::all);
}

KdTree buildHuntHybrid(const TriangleSet& set, const BuildSettings& settings) {
    return buildHunt(set, settings, SampledAxes::hybrid);
}

KdTree buildHuntOne(const TriangleSet& set, const BuildSettings& settings) {
    return buildHunt(set, settings, SampledAxes::one);
}

}  // namespace cleave
