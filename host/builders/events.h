// Events of the sweep: where the boxes of references begin, end or lie flat along an axis (Wald and Havran 2006; survey
// section 5). One order and one sweep for both exact builders.
#pragma once

#include <cstdint>
#include <span>

#include "shared/sah.h"

namespace cleave {

// Ordered bits of the position << 32 | kind << 30 | reference: the order of the numbers is the order of events, by
// position, then end < planar < start, then reference. It is total, so that equal inputs sort equally.
using Event = uint64_t;

enum class EventKind : uint32_t { end, planar, start };

constexpr uint32_t kEventRefBits = 30;
constexpr Event kEventRefMask = (Event{1} << kEventRefBits) - 1;
constexpr Event kAfterAllEvents = ~Event{0};

inline Event makeEvent(float position, EventKind kind, uint32_t ref) {
    return Event{orderedBits(position)} << 32 | Event{static_cast<uint32_t>(kind)} << kEventRefBits | ref;
}
inline uint32_t eventKey(Event e) { return static_cast<uint32_t>(e >> 32); }
inline EventKind eventKind(Event e) { return static_cast<EventKind>(static_cast<uint32_t>(e) >> kEventRefBits); }
inline uint32_t eventRef(Event e) { return static_cast<uint32_t>(e & kEventRefMask); }
inline Event withRef(Event e, uint32_t ref) { return (e & ~kEventRefMask) | ref; }

// Writes the one or two events of a box along an axis; returns where the next one goes.
inline Event* writeEvents(Event* out, const Box& box, int axis, uint32_t ref) {
    const float lo = box.lo[axis], hi = box.hi[axis];
    if (lo == hi) {
        *out++ = makeEvent(lo, EventKind::planar, ref);
    } else {
        *out++ = makeEvent(lo, EventKind::start, ref);
        *out++ = makeEvent(hi, EventKind::end, ref);
    }
    return out;
}

// From so many events on, sorting them takes as much memory again.
constexpr size_t kScratchFrom = 3000;

// For events in the order that writeEvents gave for ascending references. `scratch` holds as many, or may be null below
// kScratchFrom.
void sortEvents(std::span<Event> events, Event* scratch);

// n log2 n, the logarithm rounded up: what a sort of n events is counted as.
inline uint64_t sortSteps(size_t n) { return n * static_cast<uint64_t>(std::bit_width(n)); }

// The better of `best` and the planes at the events of one axis, for a node of `count` references.
Split sweepEvents(Split best, SahCosts costs, std::span<const Event> events, const Box& cell, uint32_t axis,
                  uint32_t count);

}  // namespace cleave
