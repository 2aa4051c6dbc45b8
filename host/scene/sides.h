// Which side of triangles is their front.
#pragma once

#include <cstdint>
#include <span>

#include "shared/material.h"
#include "shared/triangle.h"

namespace cleave {

// Returns kMirrored where a primitive was placed by a node that mirrors, and so turns its triangles round (glTF 2.0,
// section 3.7.4), and kNoBack where they enclose a volume from within: from outside, which is what most such files
// mean, backs would be all that there is of it. The volume is taken about the middle of the box: a plane has none, a
// room that is seen from inside has.
uint32_t sidesOf(std::span<const Triangle> placed, bool mirrored);

}  // namespace cleave
