// The twins of the render kernels (shaders/render).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/shade.h"

namespace cleave::twin {

// What ShadePush points at. `triangles` are scaled ones: their directions are those of the world.
struct ShadeArrays {
    std::span<const Ray> rays;
    std::span<const Hit> hits;
    std::span<const StepCount> steps;
    std::span<const Hit> shadowHits;
    std::span<const Triangle> triangles;
    std::span<const uint32_t> materialOf;
    std::span<const glm::vec4> baseColours;
};

std::vector<Ray> shadowRays(const ShadeArrays& a, float offset);
// The pixels of a view (kViewShaded, ...).
std::vector<uint32_t> shade(const ShadeArrays& a, uint32_t view, float scaleLow, float scaleHigh);

}  // namespace cleave::twin
