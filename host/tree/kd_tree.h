// The kd-tree: output of every builder, input of everything else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/box.h"
#include "shared/config.h"
#include "shared/kd_node.h"

namespace cleave {

struct KdTree {
    Box bounds = emptyBox();              // of the root cell: the scaled triangles' bounds, not inflated
    int exponent = 0;                     // scaled space to world, as in TriangleSet
    std::vector<KdNode> nodes;            // node 0 is the root; always at least one (a leaf, perhaps empty)
    std::vector<uint32_t> leafTriangles;  // triangle numbers, leaf by leaf
};

// Which axes a median builder looks at in a node: all, and the cheapest by the SAH wins; the cell's longest; or one
// after the other with the level, as in Bentley's trees. SAH builders have their rule in their name.
enum class AxisChoice { all, widest, cycle };

// When a node is split at its best plane: if that costs less than a leaf, or if equation 4.1 of the survey is below 0
// there, that is if areas times triangles of the children sum up to less than the node's, whatever a visit costs.
enum class StopRule { cost, equation41 };

// How the exact builders look at the planes of small nodes: they count the boxes on either side of each, or sort events
// as in large nodes. The planes, and so the trees, are the same.
enum class SmallNodes { count, sort };

// Bins per axis, at most: on the CPU; the device and its twin have kBins.
inline constexpr uint32_t kMostBins = 512;

// Settings that shape a tree. A builder ignores those that it has no use for.
struct BuildSettings {
    SahCosts costs = kDefaultCosts;       // of a leaf: 0 or more, of others: positive; the bonus at most 1; finite
    StopRule stop = StopRule::cost;       // of SAH builders
    uint32_t bins = kBins;                // per axis, 2 to kMostBins or kBins
    uint32_t exactUpTo = kExactUpTo;      // exact SAH in nodes of at most so many references, up to kMostExactUpTo
    uint32_t maxDepth = 0;                // deepest leaf, at most kMaxDepth; 0: round(8 + 1.3 log2 N)
    AxisChoice axes = AxisChoice::cycle;  // of median builders
    uint32_t leafSize = 4;                // median builders stop at so many references
    bool clip = true;                     // clip straddling triangles to the children's cells
    bool subsample = true;                // binning looks at every l-th reference, l = max(1, floor(log10 n))
    bool snap = true;                     // sampled and binned planes move to a face beside them where that is cheaper
    bool otherAxes = true;                // hunt-one tries these, too, where the longest has no split
    SmallNodes smallNodes = SmallNodes::count;
    bool exact = false;       // the device's: exact SAH in large nodes, too
    bool everything = false;  // the device's: also what can find nothing; see BuildInfo
    uint64_t memory = 0;      // bytes that a build may use; 0: no limit but the machine's
    uint32_t threads = 2;     // of CPU builders that use several
};

// round(8 + 1.3 log2 n), the field's formula, at most kMaxDepth; `settings.maxDepth` where that is given.
uint32_t depthLimit(const BuildSettings& settings, uint64_t triangleCount);

// What builders compare splits and leaves by: the costs, or equation 4.1, which is what is left of them where visits
// cost nothing.
SahCosts splitCosts(const BuildSettings& settings);

// A hash of the tree in canonical form (nodes breadth-first, leaf lists ascending), 16 hexadecimal digits: two trees
// are the same exactly if builders chose the same splits and lists, whatever the order in memory.
std::string treeHash(const KdTree& tree);

}  // namespace cleave
