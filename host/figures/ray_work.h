// What rays do on their way, averaged.
#pragma once

#include <span>
#include <string>

#include "shared/step_count.h"

namespace cleave {

// Per ray.
struct RayWork {
    double inner = 0.0;  // inner nodes visited, those of restarts included
    double leaves = 0.0;
    double triangles = 0.0;  // triangle tests
    double resolved = 0.0;   // of them decided in double
    double restarts = 0.0;
    // The share of lanes that have a node to visit, if the lanes of a subgroup visit theirs together until the last of
    // them is done: the work of all over the largest times their number.
    double lanesInUse = 0.0;
};

// Of rays whose subgroups are `lanes` consecutive ones.
RayWork workOf(std::span<const StepCount> steps, uint32_t lanes);

}  // namespace cleave
