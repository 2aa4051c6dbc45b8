// Names the ways in which rays are answered, for everything that traces, judges or reports them.
#pragma once

#include <cstdint>

namespace cleave {

// closest: the nearest hit, ties by the lower triangle number. any: whether there is a hit, by some triangle.
enum class Query : uint32_t { closest, any };

// restart: without a stack, by a restart trail (Laine 2010). stack: the textbook walk. shortStack: a stack of a few
// entries, and the trail for what does not fit (Horn et al. 2007). Answers are the same.
enum class Traversal : uint32_t { restart, stack, shortStack };

// watertight: no ray slips through an edge or a vertex. plain: Moeller and Trumbore's test in float, which leaks.
// unfiltered: the watertight test, all of it in double, without the filter in float before it.
enum class TriangleTest : uint32_t { watertight, plain, unfiltered };

// A way to trace; each combination is a pipeline of its own.
struct TraceMode {
    Query query = Query::closest;
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
    bool countSteps = false;  // counts nodes, leaves and tests per ray, so that others do not pay for it
    bool operator==(const TraceMode&) const = default;
};

}  // namespace cleave
