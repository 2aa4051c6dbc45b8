// Settings of a build, as the recording library takes them: for the device's builder and its twin alike.
#pragma once

#include <string>

#include "base/error.h"
#include "cleave/cleave.hpp"
#include "core/capacity.h"
#include "tree/kd_tree.h"

namespace cleave {

inline BuildInfo buildInfo(const BuildSettings& settings) {
    BuildInfo info;
    const SahCosts costs = splitCosts(settings);
    info.costTraverse = costs.traverse;
    info.costIntersect = costs.intersect;
    info.costLeaf = costs.leaf;
    info.emptyBonus = costs.emptyBonus;
    info.bins = settings.bins;
    info.exactUpTo = settings.exactUpTo;
    info.maxDepth = settings.maxDepth;
    info.clip = settings.clip;
    info.subsample = settings.subsample;
    info.snap = settings.snap;
    info.exact = settings.exact;
    info.everything = settings.everything;
    return info;
}

// The capacity that a build starts with, within a budget of bytes (0: none). Throws Error if nothing fits it.
inline Capacity requireCapacity(const BuildInfo& info, uint64_t bytes) {
    if (const std::optional<Capacity> capacity = limitedCapacity(info, bytes)) return *capacity;
    throw Error("building this tree takes more than the memory budget of " + std::to_string(bytes) +
                " bytes, even as one leaf; allow more");
}

}  // namespace cleave
