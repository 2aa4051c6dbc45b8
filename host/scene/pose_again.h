// Poses anew what moves, and leaves the rest as it is.
#pragma once

#include <vector>

#include "scene/pose.h"

namespace cleave {

// Brings a pose to another time: it becomes what pose() makes of `time`, but costs only the meshes of nodes that move
// (moving_nodes.h), and its warnings are of these alone. `posed` is of another time of the same animations, with the
// same detail. Returns false where it had to be posed whole, since at this time the file lacks data of other meshes:
// numbers of triangles may then be others.
bool poseAgain(PosedScene& posed, const Scene& scene, const PoseTime& time, const std::vector<bool>& movingNodes,
               Detail detail = Detail::triangles);

}  // namespace cleave
