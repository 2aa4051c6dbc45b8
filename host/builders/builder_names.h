// The CPU builders by name: what a user may choose, and what a test or a benchmark walks through.
#pragma once

#include <span>
#include <string_view>

#include "builders/builders.h"

namespace cleave {

struct CpuBuilder {
    std::string_view name;
    KdTree (*function)(const TriangleSet& set, const BuildSettings& settings, BuildReport* report);
    std::string_view description;  // half a sentence

    KdTree build(const TriangleSet& set, const BuildSettings& settings, BuildReport* report = nullptr) const {
        return function(set, settings, report);
    }
};

// All of them, in the order in which they are listed to a user. The reference of all costs, `exact`, comes first.
std::span<const CpuBuilder> cpuBuilders();

// Throws Error, which lists what there is, if no builder has the name.
const CpuBuilder& cpuBuilder(std::string_view name);

}  // namespace cleave
