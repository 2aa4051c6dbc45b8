// The stiff and extreme scenes, each made by code from a seed.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shared/triangle.h"
#include "stability/random.h"

namespace cleave {

struct StabilityCase {
    std::string_view name;
    std::string_view about;  // half a sentence
    // `quick` asks for a smaller version of what is large.
    std::vector<Triangle> (*make)(Random& random, bool quick);
};

// In the order in which they are run and listed.
std::span<const StabilityCase> stabilityCases();

// By group, a file each.
std::span<const StabilityCase> tinyCases();    // hardly any triangles, or none that count
std::span<const StabilityCase> planarCases();  // sheets, grids, boxes: planes on planes
std::span<const StabilityCase> thinCases();    // needles, hair, fans, shells
std::span<const StabilityCase> scaleCases();   // far away, tiny, huge, and far apart
std::span<const StabilityCase> denseCases();   // large or crowded

}  // namespace cleave
