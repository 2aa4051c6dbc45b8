#include "builders/builder_names.h"

#include <string>

#include "base/error.h"

namespace cleave {
namespace {

constexpr CpuBuilder kCpuBuilders[] = {
    {"exact", buildExact, "exact SAH with perfect splits (Wald and Havran 2006)"},
    {"exact-nlog2n", buildExactNLog2N, "the same tree, with events sorted in each node"},
    {"hunt-all", buildHuntAll, "SAH from 16 adaptive samples per axis, exact in small nodes (Hunt et al. 2006)"},
    {"hunt-hybrid", buildHuntHybrid, "the same, in nodes above 1024 references along the longest axis only"},
    {"hunt-one", buildHuntOne, "the same, along the longest axis only, the others where that has no split"},
    {"shevtsov", buildShevtsov, "binned SAH, a subtree per thread, exact in small nodes (Shevtsov et al. 2007)"},
    {"object-median", buildObjectMedian, "planes through the centre of the median box, down to a leaf size"},
    {"spatial-median", buildSpatialMedian, "planes through the middle of the cell, down to a leaf size"},
    {"brute", buildBrute, "no tree: one leaf that lists all triangles"},
};

}  // namespace

std::span<const CpuBuilder> cpuBuilders() { return kCpuBuilders; }

const CpuBuilder& cpuBuilder(std::string_view name) {
    std::string names;
    for (const CpuBuilder& builder : kCpuBuilders) {
        if (builder.name == name) return builder;
        names += (names.empty() ? "" : ", ") + std::string(builder.name);
    }
    throw Error("no builder on the CPU is named '" + std::string(name) + "'; there is: " + names);
}

}  // namespace cleave
