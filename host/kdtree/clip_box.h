// Perfect splits: the box of what a cell holds of a triangle (survey section 5; Wald and Havran 2006, section 3.2).
#pragma once

#include "shared/box.h"
#include "shared/triangle.h"

namespace cleave {

// A float box that certainly holds the part of the triangle inside `cell`, and no more than a rounding beyond it.
// Always within the cell and the triangle's own box; empty only if the triangle certainly misses the cell.
Box clippedBox(const Triangle& triangle, const Box& cell);

}  // namespace cleave
