#include "builders/exact_chooser.h"

namespace cleave {
namespace {

uint64_t eventCount(std::span<const ClippedRef> refs) {
    uint64_t flat = 0;
    for (const ClippedRef& ref : refs)
        for (int axis = 0; axis < 3; ++axis) flat += ref.box.lo[axis] == ref.box.hi[axis] ? 1 : 0;
    return 6 * refs.size() - flat;
}

}  // namespace

Split ExactChooser::operator()(const NodeToSplit& node) {
    const auto references = static_cast<uint32_t>(node.refs.size());
    const Split best = isCounted(settings_, references) ? count(node) : sweep(node);
    return isWorthwhile(node.costs, best, node.cell, references, node.depth, maxDepth_) ? best : noSplit();
}

Split ExactChooser::count(const NodeToSplit& node) {
    report_.eventsSwept += eventCount(node.refs);
    return bestFace(node, kAllAxes);
}

Split ExactChooser::sweep(const NodeToSplit& node) {
    const auto references = static_cast<uint32_t>(node.refs.size());
    if (events_.size() < 2 * node.refs.size()) {
        events_.resize(2 * node.refs.size());
        scratch_.resize(2 * node.refs.size());
    }
    Split best = noSplit();
    for (uint32_t axis = 0; axis < 3; ++axis) {
        Event* end = events_.data();
        for (uint32_t i = 0; i < references; ++i) end = writeEvents(end, node.refs[i].box, static_cast<int>(axis), i);
        const std::span<Event> events(events_.data(), end);
        sortEvents(events, scratch_.data());
        report_.eventsSwept += events.size();
        report_.sortSteps += sortSteps(events.size());
        best = sweepEvents(best, node.costs, events, node.cell, axis, references);
    }
    return best;
}

}  // namespace cleave
