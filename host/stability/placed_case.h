// A case as a mesh that stands in three places, for what walks instances.
#pragma once

#include <span>
#include <vector>

#include "instances/instances.h"
#include "stability/random.h"

namespace cleave {

struct PlacedCase {
    std::vector<Triangle> world;  // of all places, copied by pose()
    Instances instances;
};

// Places: the mesh's own space; turned, stretched and moved, so that it cuts through the first; and mirrored with its
// axes swapped, where what lies on a grid stays on one. All about the middle of the case.
PlacedCase placedCase(std::span<const Triangle> mesh, Random& random);

}  // namespace cleave
