#include <algorithm>
#include <array>
#include <utility>

#include "builders/adaptive_samples.h"
#include "builders/builders.h"
#include "builders/face_scan.h"
#include "builders/faces_along.h"
#include "builders/top_down.h"

namespace cleave {
namespace {

// Figures of the paper (Hunt, Mark and Stoll 2006).
constexpr uint32_t kSamples = 8;        // uniform ones; as many are placed adaptively
constexpr size_t kExactBoxes = 36;      // at most so many boxes: their cost is too rough to be sampled
constexpr size_t kOneAxisAbove = 1024;  // hybrid: large nodes are sampled along one axis only

// Ours: where the longest axis has no split worth its cost, larger nodes are tried along the others. (Sponza's tree
// costs 54 % more than the exact one without that, 12 % with it; in smaller nodes it does not pay.)
constexpr size_t kOtherAxesAbove = 4;

enum class SampledAxes { all, hybrid, one };

class SampleChooser {
  public:
    SampleChooser(SampledAxes axes, const BuildSettings& settings, uint32_t maxDepth)
        : axes_(axes), snap_(settings.snap), otherAxes_(settings.otherAxes), maxDepth_(maxDepth) {}

    Split operator()(const NodeToSplit& node) {
        const size_t n = node.refs.size();
        const bool oneAxis = axes_ == SampledAxes::one || (axes_ == SampledAxes::hybrid && n > kOneAxisAbove);
        Split best = noSplit();
        if (n <= kExactBoxes && !oneAxis) {
            best = bestFace(node, kAllAxes);
        } else {
            for (const uint32_t axis : longestFirst(node.cell)) {
                const Split split = n <= kExactBoxes ? bestFace(node, onlyAxis(axis))
                                    : snap_          ? search(node, axis)
                                                     : sample(node, axis);
                if (isBetter(split, best)) best = split;
                const bool triesOthers = otherAxes_ && n > kOtherAxesAbove && !isWorthwhile(node, best);
                if (oneAxis && !triesOthers) break;
            }
        }
        return isWorthwhile(node, best) ? best : noSplit();
    }

  private:
    bool isWorthwhile(const NodeToSplit& node, const Split& split) const {
        return cleave::isWorthwhile(node.costs, split, node.cell, static_cast<uint32_t>(node.refs.size()), node.depth,
                                    maxDepth_);
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

    // The position of least interpolated cost over [from, to], which holds all boxes.
    float deepestValley(const NodeToSplit& node, uint32_t axis, float from, float to) {
        takeAdaptiveSamples(faces_.extents(node), from, to, kSamples, samples_);
        Valley deepest{from, infinity()};
        for (size_t i = 1; i < samples_.size(); ++i) {
            const Valley valley = valleyBetween(samples_[i - 1], samples_[i], node.cell, axis);
            if (valley.cost < deepest.cost) deepest = valley;
        }
        return deepest.position;
    }

    // The paper's plane: where the interpolated cost is least. Whether it pays is seen by true counts.
    Split sample(const NodeToSplit& node, uint32_t axis) {
        const float from = node.cell.lo[static_cast<int>(axis)], to = node.cell.hi[static_cast<int>(axis)];
        if (!(from < to)) return noSplit();
        gatherFaces(faces_, node, axis);
        return bestAt(faces_, node, deepestValley(node, axis, from, to));
    }

    // Ours: samples what the boxes span, and tries the ends of that, the position of least interpolated cost and the
    // faces around it; between these the cost is affine.
    Split search(const NodeToSplit& node, uint32_t axis) {
        gatherFaces(faces_, node, axis);
        const auto n = static_cast<uint32_t>(node.refs.size());
        Split best = noSplit();
        best = betterOf(best, node.costs, node.cell, axis, faces_.from, 0, n,
                        0);  // empty space below the boxes or above them
        best = betterOf(best, node.costs, node.cell, axis, faces_.to, n, 0, 1);
        if (!(faces_.from < faces_.to)) return best;
        const Split near = bestNear(faces_, node, deepestValley(node, axis, faces_.from, faces_.to));
        return isBetter(near, best) ? near : best;
    }

    const SampledAxes axes_;
    const bool snap_;
    const bool otherAxes_;
    const uint32_t maxDepth_;
    FacesAlong faces_;
    std::vector<CostSample> samples_;
};

KdTree buildHunt(const TriangleSet& set, const BuildSettings& settings, SampledAxes axes, BuildReport* report) {
    return buildTopDown(set, settings, SampleChooser(axes, settings, depthLimit(settings, set.included.size())),
                        report);
}

}  // namespace

KdTree buildHuntAll(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildHunt(set, settings, SampledAxes::all, report);
}

KdTree buildHuntHybrid(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildHunt(set, settings, SampledAxes::hybrid, report);
}

KdTree buildHuntOne(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    return buildHunt(set, settings, SampledAxes::one, report);
}

}  // namespace cleave
