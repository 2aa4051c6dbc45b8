// What queries of trees and of their twins refuse.
#pragma once

#include <span>

#include "cleave/scene.hpp"
#include "shared/triangle.h"

namespace cleave::scene {

// Each throws what the class of the query says it does.
void requireHitsPerRay(uint32_t hitsPerRay);
void requireWithin(float within);
void requirePoints(std::span<const Point> points);
void requireBoxes(std::span<const Box> boxes);
void requireNoOpenEdges(uint64_t openEdges);

// Distances of points: negative where the point is inside and not on the surface.
std::vector<float> signedDistances(std::span<const TraceHit> nearest, std::span<const uint8_t> isInside);

}  // namespace cleave::scene
