#include "builders/events.h"

#include <algorithm>
#include <array>

namespace cleave {
namespace {

// One stable counting pass over kBits of the events.
constexpr uint32_t kBits = 12;
void countingPass(std::span<const Event> from, Event* to, uint32_t shift) {
    constexpr uint32_t kDigits = 1u << kBits;
    const auto digit = [&](Event e) { return static_cast<uint32_t>(e >> shift) & (kDigits - 1); };
    std::array<uint32_t, kDigits> next{};
    for (const Event e : from) ++next[digit(e)];
    uint32_t sum = 0;
    for (uint32_t& n : next) {
        const uint32_t count = n;
        n = sum;
        sum += count;
    }
    for (const Event e : from) to[next[digit(e)]++] = e;
}

// The axis as a constant lets the compiler keep what does not change along it in registers.
template <uint32_t axis>
Split sweepAlong(Split best, SahCosts costs, std::span<const Event> events, const Box& cell, uint32_t count) {
    // Numbers of references that begin below the current position, begin at most there, end above it, and lie in it.
    uint32_t left = 0, begun = 0, right = count, lying = 0;
    for (size_t i = 0; i < events.size(); ++i) {
        const EventKind kind = eventKind(events[i]);
        right -= kind != EventKind::start ? 1u : 0u;
        begun += kind != EventKind::end ? 1u : 0u;
        lying += kind == EventKind::planar ? 1u : 0u;
        const uint32_t key = eventKey(events[i]);
        if (i + 1 < events.size() && eventKey(events[i + 1]) == key) continue;
        best = betterOfBothSides(best, costs, cell, axis, fromOrderedBits(key), left, right, lying);
        left = begun;
        lying = 0;
    }
    return best;
}

}  // namespace

// References ascend and a reference has one event of a kind, so a stable sort by position and kind is the full order:
// 34 bits, in three counting passes; by comparison where clearing the tables would cost more.
void sortEvents(std::span<Event> events, Event* scratch) {
    if (events.size() < kScratchFrom) {
        std::sort(events.begin(), events.end());
        return;
    }
    const std::span<const Event> moved(scratch, events.size());
    countingPass(events, scratch, kEventRefBits);
    countingPass(moved, events.data(), kEventRefBits + kBits);
    countingPass(events, scratch, kEventRefBits + 2 * kBits);
    std::copy(moved.begin(), moved.end(), events.begin());
}

Split sweepEvents(Split best, SahCosts costs, std::span<const Event> events, const Box& cell, uint32_t axis,
                  uint32_t count) {
    if (axis == 0) return sweepAlong<0>(best, costs, events, cell, count);
    if (axis == 1) return sweepAlong<1>(best, costs, events, cell, count);
    return sweepAlong<2>(best, costs, events, cell, count);
}

}  // namespace cleave
