// A node on the way through the O(N log N) build, and its division (Wald and Havran 2006, section 4; survey section 5).
#pragma once

#include <functional>
#include <span>

#include "builders/builders.h"
#include "builders/counted_array.h"
#include "builders/events.h"
#include "tree/clipped_ref.h"

namespace cleave {

// References, ascending by triangle, and their sorted events along each axis. A node owns what it holds and numbers its
// references from 0, so that subtrees are independent of each other and lie close in memory.
struct EventNode {
    Box cell;
    uint32_t depth = 0;
    uint32_t count = 0;
    CountedArray<ClippedRef> refs;
    CountedArray<Event> events;     // three parts of equal capacity, one event more than a node can have
    std::span<Event> alongAxis[3];  // the parts, as far as they are filled

    std::span<const ClippedRef> references() const { return {refs.data(), count}; }
    NodeToSplit toSplit(SahCosts costs) const { return {references(), cell, depth, costs}; }
};

// State that all threads of one build share.
struct EventBuild {
    const TriangleSet& set;
    const SahCosts costs;
    const bool clip;
    const uint32_t maxDepth;
    const bool parallel;
    ByteCount bytes;
};

// Calls body(axis) for each axis, concurrently where the node is large and the build parallel.
void forEachAxis(const EventBuild& build, uint32_t count, const std::function<void(int)>& body);

// The node of all triangles: the one sort of all events.
EventNode rootNode(EventBuild& build, BuildReport& report);

struct Children {
    EventNode left, right;
};

// Steps 1 to 4 of the survey; what the node held is freed.
Children divide(EventBuild& build, EventNode node, const Split& split, BuildReport& report);

}  // namespace cleave
