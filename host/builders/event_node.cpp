#include "builders/event_node.h"

#include "base/error.h"
#include "builders/threads.h"

namespace cleave {
namespace {

constexpr uint32_t kShareAxesFrom = 8192;

// Target of the events of a reference: its number in the child, and which child. A straddling reference has none, since
// its two parts get new events.
constexpr uint32_t kToRight = 1u << 31;
constexpr uint32_t kToNone = 1u << 30;
static_assert(kEventRefMask < kToNone);

// A child under construction.
struct Side {
    EventNode node;
    CountedArray<uint32_t> parts;  // the references that are parts of straddling ones, ascending
    uint32_t partCount = 0;

    void add(const ClippedRef& ref) { node.refs[node.count++] = ref; }
};

size_t capacityAlongAxis(const EventNode& node) { return 2 * size_t{node.count} + 1; }

Side emptySide(EventBuild& build, const EventNode& parent, const Box& cell) {
    Side side;
    side.node.cell = cell;
    side.node.depth = parent.depth + 1;
    side.node.refs = CountedArray<ClippedRef>(parent.count, build.bytes);
    side.parts = CountedArray<uint32_t>(parent.count, build.bytes);
    return side;
}

void addPart(Side& side, const Box& part, uint32_t prim) {
    if (isEmpty(part)) return;
    side.parts[side.partCount++] = side.node.count;
    side.add({part, prim});
}

// Step 1: which side each reference goes to, and the parts of those that straddle.
CountedArray<uint32_t> classify(EventBuild& build, const EventNode& node, const Split& split, Side& left, Side& right) {
    CountedArray<uint32_t> targets(node.count, build.bytes);
    const int axis = static_cast<int>(split.axis);
    for (uint32_t i = 0; i < node.count; ++i) {
        const ClippedRef& ref = node.refs[i];
        const uint32_t sides = sideOf(ref.box.lo[axis], ref.box.hi[axis], split.position, split.planarLeft);
        if (sides == kLeft) {
            targets[i] = left.node.count;
            left.add(ref);
        } else if (sides == kRight) {
            targets[i] = right.node.count | kToRight;
            right.add(ref);
        } else {
            targets[i] = kToNone;
            const SplitBoxes parts = splitReference(build.set, ref, split, build.clip);
            addPart(left, parts.left, ref.prim);
            addPart(right, parts.right, ref.prim);
        }
    }
    return targets;
}

// Step 3: the events of the parts along an axis, sorted, with an end mark; nothing if there are no parts.
CountedArray<Event> partEvents(EventBuild& build, const Side& side, int axis) {
    if (side.partCount == 0) return {};
    CountedArray<Event> events(2 * size_t{side.partCount} + 1, build.bytes);
    Event* end = events.data();
    for (uint32_t i = 0; i < side.partCount; ++i)
        end = writeEvents(end, side.node.refs[side.parts[i]].box, axis, side.parts[i]);
    const std::span<Event> sorted(events.data(), end);
    CountedArray<Event> scratch;
    if (sorted.size() >= kScratchFrom) scratch = CountedArray<Event>(sorted.size(), build.bytes);
    sortEvents(sorted, scratch.data());
    *end = kAfterAllEvents;
    return events;
}

// Where the merged events of a child are written, and the parts' events that wait to be merged.
struct Stream {
    Event* out = nullptr;
    const Event* waiting;

    explicit Stream(const CountedArray<Event>& parts)
        : waiting(parts.data() != nullptr ? parts.data() : &kAfterAllEvents) {}
    void mergeBelow(Event limit) {
        while (*waiting < limit) *out++ = *waiting++;
    }
};

// Steps 2 and 4 in one pass: new numbers ascend with the old ones, so each child's events stay in order. Every event is
// written; an unwanted one is overwritten by the next.
void splice(EventBuild& build, const EventNode& node, const CountedArray<uint32_t>& targets, Side (&sides)[2],
            int axis) {
    const CountedArray<Event> leftParts = partEvents(build, sides[0], axis);
    const CountedArray<Event> rightParts = partEvents(build, sides[1], axis);
    Stream streams[2] = {Stream(leftParts), Stream(rightParts)};
    Event* begins[2];
    for (int i = 0; i < 2; ++i)
        streams[i].out = begins[i] =
            sides[i].node.events.data() + static_cast<size_t>(axis) * capacityAlongAxis(sides[i].node);
    for (const Event e : node.alongAxis[axis]) {
        const uint32_t target = targets[eventRef(e)];
        const Event moved = withRef(e, target & static_cast<uint32_t>(kEventRefMask));
        Stream& stream = streams[target >> 31];
        stream.mergeBelow(moved);
        *stream.out = moved;
        stream.out += (target & kToNone) == 0 ? 1 : 0;
    }
    for (int i = 0; i < 2; ++i) {
        streams[i].mergeBelow(kAfterAllEvents);
        sides[i].node.alongAxis[axis] = {begins[i], streams[i].out};
    }
}

uint64_t sortStepsOfParts(const Side& side) { return 3 * sortSteps(2 * size_t{side.partCount}); }

}  // namespace

void forEachAxis(const EventBuild& build, uint32_t count, const std::function<void(int)>& body) {
    if (build.parallel && count >= kShareAxesFrom)
        forEachAtOnce(3, [&](size_t axis) { body(static_cast<int>(axis)); });
    else
        for (int axis = 0; axis < 3; ++axis) body(axis);
}

EventNode rootNode(EventBuild& build, BuildReport& report) {
    const std::vector<uint32_t>& included = build.set.included;
    if (included.size() > kEventRefMask) throw Error("cannot build over more than 2^30 triangles; use another builder");
    EventNode root;
    root.cell = build.set.bounds;
    root.count = static_cast<uint32_t>(included.size());
    root.refs = CountedArray<ClippedRef>(included.size(), build.bytes);
    for (size_t i = 0; i < included.size(); ++i) root.refs[i] = wholeTriangle(build.set, included[i]);
    root.events = CountedArray<Event>(3 * capacityAlongAxis(root), build.bytes);
    forEachAxis(build, root.count, [&](int axis) {
        Event* const begin = root.events.data() + static_cast<size_t>(axis) * capacityAlongAxis(root);
        Event* end = begin;
        for (uint32_t i = 0; i < root.count; ++i) end = writeEvents(end, root.refs[i].box, axis, i);
        root.alongAxis[axis] = {begin, end};
        CountedArray<Event> scratch(root.alongAxis[axis].size(), build.bytes);
        sortEvents(root.alongAxis[axis], scratch.data());
    });
    for (const std::span<Event>& events : root.alongAxis) report.sortSteps += sortSteps(events.size());
    return root;
}

Children divide(EventBuild& build, EventNode node, const Split& split, BuildReport& report) {
    Side sides[2] = {emptySide(build, node, leftOf(node.cell, split.axis, split.position)),
                     emptySide(build, node, rightOf(node.cell, split.axis, split.position))};
    const CountedArray<uint32_t> targets = classify(build, node, split, sides[0], sides[1]);
    for (Side& side : sides) {
        side.node.events = CountedArray<Event>(3 * capacityAlongAxis(side.node), build.bytes);
        report.sortSteps += sortStepsOfParts(side);
    }
    forEachAxis(build, node.count, [&](int axis) { splice(build, node, targets, sides, axis); });
    return {std::move(sides[0].node), std::move(sides[1].node)};
}

}  // namespace cleave
