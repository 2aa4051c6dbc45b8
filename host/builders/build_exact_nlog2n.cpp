#include "builders/build_exact_nlog2n.h"

namespace cleave {

Split SweepChooser::operator()(const NodeToSplit& node) {
    const auto count = static_cast<uint32_t>(node.refs.size());
    if (events_.size() < 2 * node.refs.size()) {
        events_.resize(2 * node.refs.size());
        scratch_.resize(2 * node.refs.size());
    }
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; ++axis) {
        Event* end = events_.data();
        for (uint32_t i = 0; i < count; ++i) end = writeEvents(end, node.refs[i].box, static_cast<int>(axis), i);
        const std::span<Event> events(events_.data(), end);
        sortEvents(events, scratch_.data());
        report_.eventsSwept += events.size();
        report_.sortSteps += sortSteps(events.size());
        best = sweepEvents(best, node.costs, events, node.cell, axis, count);
    }
    return isWorthwhile(node.costs, best, node.cell, count, node.depth, maxDepth_) ? best : noSplit();
}

KdTree buildExactNLog2N(const TriangleSet& set, const BuildSettings& settings, BuildReport* report) {
    BuildReport work;
    const SweepChooser chooser(depthLimit(settings, set.included.size()), work);
    KdTree tree = buildTopDown(set, settings, chooser, report);
    if (report != nullptr) *report = {report->peakBytes, work.eventsSwept, work.sortSteps};
    return tree;
}

}  // namespace cleave
