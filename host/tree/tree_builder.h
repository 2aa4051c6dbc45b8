// The interface of the builders that run on the CPU: those of host/builders and the device's twin alike.
#pragma once

#include <cstdint>
#include <string_view>

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

struct BuildOutcome {
    KdTree tree;
    uint64_t peakBytes = 0;      // at most so many were held at once
    bool memoryLimited = false;  // settings.memory was met: the last levels are leaves
};

struct TreeBuilder {
    std::string_view name;
    BuildOutcome (*build)(const TriangleSet& set, const BuildSettings& settings);
    std::string_view description;  // half a sentence for a list of builders
};

}  // namespace cleave
