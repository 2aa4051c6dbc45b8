// The judges of all crossings of a ray, by the rule "once": an edge or a vertex is crossed as often as a line beside it
// would be (docs/queries.md).
#pragma once

#include <span>
#include <vector>

#include "shared/ray.h"
#include "shared/triangle.h"
#include "tree/triangle_set.h"

namespace cleave {

// Same arithmetic: the shared function in the plainest of loops. All crossings in the ray's interval, in the order of
// (t, number); none of an invalid ray. The twin of the kernels trace_all and trace_count.
std::vector<Hit> bruteCrossings(const TriangleSet& set, const Ray& ray);
// How many of them leave, less those that enter.
int bruteWinding(const TriangleSet& set, const Ray& ray);

// The reference: how the ray's line crosses the triangle, by exact arithmetic on projected vertices. 1 along its
// normal, -1 against it, 0 not at all. Shares nothing with the shared function.
int crossesOnce(const Ray& ray, const Triangle& triangle);
// All crossings in the ray's interval, t rounded once. An interval that begins at 0 holds what has exactly t >= 0.
std::vector<Hit> referenceCrossings(std::span<const Triangle> world, const Ray& ray);

}  // namespace cleave
