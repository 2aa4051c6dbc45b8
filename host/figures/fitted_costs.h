// What a node and a triangle test take on a device, fitted to counts and times.
#pragma once

#include <optional>
#include <span>

#include "shared/sah.h"

namespace cleave {

// Rays through a tree.
struct WorkSample {
    double inner = 0.0, triangles = 0.0;  // per ray: inner nodes visited, triangle tests
    double nanoseconds = 0.0;             // per ray, above 0
};

// Nanoseconds of the whole device, not of a lane: what one more of each adds to the time of a ray. An inner node takes
// its share of the leaves with it, of which a ray visits about a fifth as many.
struct FittedCosts {
    double ray = 0.0, inner = 0.0, triangle = 0.0;
    double meanError = 0.0, largestError = 0.0;  // relative, of the samples
    size_t samples = 0;

    double nanosecondsOf(const WorkSample& sample) const {
        return ray + inner * sample.inner + triangle * sample.triangles;
    }
};

// The non-negative costs of least squared relative error. Nothing with fewer samples than costs.
std::optional<FittedCosts> fitCosts(std::span<const WorkSample> samples);

// As the heuristic's constants, with an inner node at 15 for comparison. The heuristic knows no cost of a ray. Nothing
// where inner nodes or triangles seem to cost nothing.
std::optional<SahCosts> sahCostsOf(const FittedCosts& fitted);

}  // namespace cleave
