// Points of floats at a triangle's plane, where rays start at t = 0 or a hair beside it.
#pragma once

#include <optional>

#include "shared/triangle.h"
#include "stability/random.h"

namespace cleave {

// A point inside of the triangle (up to rounding): exactly in its plane, or off it by so little that double does not
// tell on which side. Nothing where the dice find none: few triangles have floats in their planes beside vertices, and
// vertices of very different sizes have none close by either.
std::optional<vec3> pointInPlane(const Triangle& triangle, Random& random);
std::optional<vec3> pointBesidePlane(const Triangle& triangle, Random& random);

}  // namespace cleave
