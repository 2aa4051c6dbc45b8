// Cuts the scene into parts, one per thread (Shevtsov, Soupikov and Kapustin 2007, section 4.2; survey section 7).
#pragma once

#include <vector>

#include "builders/counted_array.h"
#include "tree/clipped_ref.h"

namespace cleave {

// A node whose subtree one thread builds. Its references are the first half of an array that then serves as the pool of
// that thread.
struct Part {
    uint32_t node = 0;  // of the tree
    uint32_t depth = 0;
    Box cell;
    size_t count = 0;
    CountedArray<ClippedRef> refs;

    size_t capacity() const { return 2 * count; }
    std::span<const ClippedRef> references() const { return {refs.data(), count}; }
};

// Splits the scene into settings.threads parts and appends the inner nodes that do so to `tree`, which has a root.
//
// A part that k > 1 threads own is split along the widest axis of its references' bounds, which 512 k bins span, at the
// first boundary b with left(b) : right(b) >= floor(k / 2) : ceil(k / 2), where left and right count references as they
// will be sorted, straddling ones on both sides; the halves own floor(k / 2) and ceil(k / 2) threads. For powers of two
// that is the survey's median. A part is left as it is, and threads without work, if it has no more references than
// bins, if the boundary is not strictly inside its cell, or if one side would keep all references. All passes over the
// references are shared by all threads; the result depends on their number only.
std::vector<Part> decompose(KdTree& tree, const TriangleSet& set, const BuildSettings& settings, ByteCount& bytes);

}  // namespace cleave
