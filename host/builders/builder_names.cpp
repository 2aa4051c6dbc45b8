#include "builders/builder_names.h"

#include <string>

#include "base/error.h"
#include "builders/builders.h"

namespace cleave {
namespace {

template <KdTree (*function)(const TriangleSet& set, const BuildSettings& settings, BuildReport* report)>
BuildOutcome outcomeOf(const TriangleSet& set, const BuildSettings& settings) {
    BuildReport report;
    KdTree tree = function(set, settings, &report);
    return {std::move(tree), report.peakBytes, false};
}

constexpr TreeBuilder kCpuBuilders[] = {
    {"exact", outcomeOf<buildExact>, "exact SAH with perfect splits (Wald and Havran 2006)"},
    {"exact-nlog2n", outcomeOf<buildExactNLog2N>, "the same tree, with events sorted in each node (see --small-nodes)"},
    {"hunt-all", outcomeOf<buildHuntAll>,
     "SAH from 16 adaptive samples per axis, exact in small nodes (Hunt et al. 2006)"},
    {"hunt-hybrid", outcomeOf<buildHuntHybrid>, "the same, in nodes above 1024 references along the longest axis only"},
    {"hunt-one", outcomeOf<buildHuntOne>, "the same, along the longest axis only, the others where that has no split"},
    {"shevtsov", outcomeOf<buildShevtsov>,
     "binned SAH, a subtree per thread, exact in small nodes (Shevtsov et al. 2007)"},
    {"object-median", outcomeOf<buildObjectMedian>, "planes through the centre of the median box, down to a leaf size"},
    {"spatial-median", outcomeOf<buildSpatialMedian>, "planes through the middle of the cell, down to a leaf size"},
    {"brute", outcomeOf<buildBrute>, "no tree: one leaf that lists all triangles"},
};

}  // namespace

std::span<const TreeBuilder> cpuBuilders() { return kCpuBuilders; }

const TreeBuilder& cpuBuilder(std::string_view name) {
    std::string names;
    for (const TreeBuilder& builder : kCpuBuilders) {
        if (builder.name == name) return builder;
        names += (names.empty() ? "" : ", ") + std::string(builder.name);
    }
    throw Error("no builder on the CPU is named '" + std::string(name) + "'; there is: " + names);
}

}  // namespace cleave
