#include <algorithm>

#include "builders/binning.h"
#include "builders/builders.h"
#include "builders/decomposition.h"
#include "builders/face_scan.h"
#include "builders/faces_along.h"
#include "builders/threads.h"
#include "builders/top_down.h"

namespace cleave {
namespace {

class BinnedChooser {
  public:
    BinnedChooser(const BuildSettings& settings, uint32_t maxDepth)
        : bins_(settings.bins), subsample_(settings.subsample), snap_(settings.snap), maxDepth_(maxDepth) {}

    Split operator()(const NodeToSplit& node) {
        const auto n = static_cast<uint32_t>(node.refs.size());
        // With no more references than bins, counting at each face is exact and costs less.
        const Split best = n <= std::min<size_t>(bins_, kMostScanned) ? bestFace(node, kAllAxes) : binned(node, n);
        return isWorthwhile(node.costs, best, node.cell, n, node.depth, maxDepth_) ? best : noSplit();
    }

  private:
    Split binned(const NodeToSplit& node, uint32_t n) {
        const uint32_t step = sampleStep(n, subsample_);
        fillBins(counted_, node.refs, boundsOf(node.refs), bins_, step);
        const Split best = bestBoundary(counted_, node, step);
        if (best.axis == kLeafAxis || !snap_) return best;
        gatherFaces(faces_, node, best.axis);
        return bestNear(faces_, node, best.position);
    }

    const uint32_t bins_;
    const bool subsample_;
    const bool snap_;
    const uint32_t maxDepth_;
    Bins counted_;
    FacesAlong faces_;
};

}  // namespace

KdTree buildShevtsov(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    const BinnedChooser chooser(settings, depthLimit(settings, set.included.size()));
    ByteCount bytes;
    KdTree tree;
    tree.nodes.resize(1);
    uint64_t partBytes = 0;
    withThreads(settings.threads, [&] {
        std::vector<Part> parts = decompose(tree, set, settings, bytes);
        // The first part continues the tree itself; the others are subtrees that are grafted when all are done.
        std::vector<KdTree> subtrees(parts.size());
        const auto buildPart = [&](size_t i) {
            Part& part = parts[i];
            KdTree begun;
            if (i == 0)
                begun = std::move(tree);
            else
                begun.nodes.resize(1);
            const size_t capacity = part.capacity();
            subtrees[i] = TopDownBuilder<BinnedChooser>(set, settings, chooser, bytes)
                              .build(std::move(begun), i == 0 ? part.node : 0, part.cell, part.depth,
                                     std::move(part.refs), part.count, capacity);
        };
        forEachAtOnce(parts.size(), buildPart);
        tree = std::move(subtrees[0]);
        for (size_t i = 1; i < parts.size(); ++i) {
            partBytes += growthBytes(subtrees[i]);
            graft(tree, parts[i].node, subtrees[i]);
        }
    });
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    if (report != nullptr) *report = {bytes.peak() + partBytes + growthBytes(tree)};
    return tree;
}

}  // namespace cleave
