#include "scene/moving_nodes.h"

#include <algorithm>

#include "scene/animation.h"
#include "scene/key_values.h"
#include "scene/morph_targets.h"
#include "scene/node_transforms.h"
#include "scene/skin_matrices.h"

namespace cleave {
namespace {

bool isConstant(const Scene& scene, const PlayedChannel& played) {
    const std::vector<double> times = keyTimes(scene, played.sampler.input);
    const KeyValues keys(scene, played.sampler, times);
    switch (played.channel.path) {
        case gltf::Path::rotation:
            return keys.isConstant(4, 1);
        case gltf::Path::weights:
            return keys.isConstant(1, morphTargetsOf(scene, played.channel.node));
        case gltf::Path::translation:
        case gltf::Path::scale:
            break;
    }
    return keys.isConstant(3, 1);
}

// What moves moves what is below it, too.
void passOn(const Scene& scene, std::vector<bool>& moves) {
    std::vector<uint32_t> waiting;
    for (uint32_t i = 0; i < moves.size(); ++i)
        if (moves[i]) waiting.push_back(i);
    while (!waiting.empty()) {
        const uint32_t node = waiting.back();
        waiting.pop_back();
        for (const uint32_t child : scene.nodes[node].children) {
            if (moves[child]) continue;
            moves[child] = true;
            waiting.push_back(child);
        }
    }
}

}  // namespace

std::vector<bool> movingNodes(const Scene& scene, const std::vector<uint32_t>& animations) {
    std::vector<bool> placesMove(scene.nodes.size());
    std::vector<bool> weightsMove(scene.nodes.size());
    Warnings ignored;  // a pose gives the same
    for (const PlayedChannel& played : playedChannels(scene, animations, ignored)) {
        if (isConstant(scene, played)) continue;
        const bool ofWeights = played.channel.path == gltf::Path::weights;
        (ofWeights ? weightsMove : placesMove)[played.channel.node] = true;
    }
    passOn(scene, placesMove);
    std::vector<bool> moving(scene.nodes.size());
    for (size_t i = 0; i < moving.size(); ++i) {
        const gltf::Node& node = scene.nodes[i];
        bool isPlacedAnew = placesMove[i];
        if (node.skin && hasMatrices(scene, *node.skin)) {
            const std::vector<uint32_t>& joints = scene.skins[*node.skin].joints;
            isPlacedAnew = std::ranges::any_of(joints, [&](uint32_t joint) { return placesMove[joint]; });
        }
        moving[i] = isPlacedAnew || weightsMove[i];
    }
    return moving;
}

uint64_t countMoving(const PosedScene& posed, const std::vector<bool>& movingNodes) {
    uint64_t count = 0;
    for (const ShownMesh& mesh : posed.meshes)
        if (movingNodes[mesh.node]) count += mesh.triangles;
    return count;
}

}  // namespace cleave
