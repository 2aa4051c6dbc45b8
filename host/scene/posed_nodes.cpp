#include "scene/posed_nodes.h"

#include "scene/node_transforms.h"

namespace cleave {

PosedNodes poseNodes(const Scene& scene, const PoseTime& time, Warnings& warnings) {
    PosedNodes nodes{restStates(scene), {}};
    animate(scene, time, nodes.states, warnings);
    std::vector<glm::dmat4> local;
    for (const NodeState& state : nodes.states) local.push_back(matrixOf(state.transform));
    nodes.toWorld = worldTransforms(scene, local);
    return nodes;
}

}  // namespace cleave
