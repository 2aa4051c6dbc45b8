// Whether triangles are a closed surface.
#pragma once

#include <cstdint>
#include <span>

#include "shared/triangle.h"

namespace cleave {

// The number of edges that belong to an odd number of triangles, where vertices at the same place are one. Without any,
// every line crosses the surface an even number of times, and a point is inside or outside of it. Which way triangles
// face does not matter. Triangles with a vertex that is not finite do not count; those without an area do.
uint64_t openEdges(std::span<const Triangle> triangles);

}  // namespace cleave
