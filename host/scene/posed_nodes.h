// Where the nodes of a scene are at a time.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/animation.h"

namespace cleave {

struct PosedNodes {
    std::vector<NodeState> states;
    std::vector<glm::dmat4> toWorld;
};

// Moves the nodes to a time. Throws Error as animate() does.
PosedNodes poseNodes(const Scene& scene, const PoseTime& time, Warnings& warnings);

}  // namespace cleave
