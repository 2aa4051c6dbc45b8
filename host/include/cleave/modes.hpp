// Names the ways in which rays are answered, for everything that traces, judges or reports them.
#pragma once

#include <cstdint>

namespace cleave {

// closest: the nearest hit, ties by the lower triangle number. any: whether there is a hit, by some triangle.
//
// The others count an edge or a vertex of a closed surface once (docs/queries.md). all: the first hits, by t and then
// by number. count: how many there are. signedCount: how many leave through the back of a triangle, less those that
// enter through its front, where corners are seen counter-clockwise. They take traversal and test of their own, and
// count no steps: what a mode says of these is not looked at.
enum class Query : uint32_t { closest, any, all, count, signedCount };

// What is asked of points and boxes. nearest: the nearest triangle of each point. contains: whether a point is inside
// of a closed surface, or on it. countOverlaps, listOverlaps: the triangles that meet each box, where those that
// several leaves list count as often.
enum class Search : uint32_t { nearest, contains, countOverlaps, listOverlaps };

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
    // Closest and any hits: through meshes that stand in places (PlacedScene in shaders/shared/placed_mesh.h), not
    // through one tree.
    bool instances = false;
    // Closest and any hits, steps uncounted, watertight: the tree is a single leaf (its nodeCount is 1), of few
    // triangles. All are tested, by whatever traversal; the kernel is compiled sooner.
    bool single = false;
    // Closest and any hits: rays wait at nodes that were left open (TraceInfo::open).
    bool lazy = false;
    bool operator==(const TraceMode&) const = default;
};

}  // namespace cleave
