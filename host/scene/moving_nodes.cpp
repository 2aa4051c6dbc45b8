#include "scene/moving_nodes.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "scene/animation.h"
#include "scene/key_values.h"
#include "scene/morph_targets.h"
#include "scene/refuse.h"
#include "scene/skin_matrices.h"

namespace cleave {
namespace {

// Knows of channels whether the keys of their samplers are all alike; samplers that share their keys are read once.
class ConstantKeys {
  public:
    explicit ConstantKeys(const Scene& scene) : scene_(scene) {}

    bool are(const PlayedChannel& played) {
        const auto& [channel, sampler] = played;
        const size_t width = channel.path == gltf::Path::rotation ? 4 : channel.path == gltf::Path::weights ? 1 : 3;
        const size_t each = width == 1 ? morphTargetsOf(scene_, channel.node) : 1;
        const auto [entry, isNew] =
            known_.try_emplace({sampler.input, sampler.output, sampler.interpolation, width, each});
        if (isNew) {
            const std::vector<double> times = keyTimes(scene_, sampler.input);
            entry->second = KeyValues(scene_, sampler, times).isConstant(width, each);
        }
        return entry->second;
    }

  private:
    const Scene& scene_;
    std::map<std::tuple<uint32_t, uint32_t, gltf::Interpolation, size_t, size_t>, bool> known_;
};

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

std::vector<bool> findMovingNodes(const Scene& scene, const std::vector<uint32_t>& animations) {
    std::vector<bool> placesMove(scene.nodes.size());
    std::vector<bool> weightsMove(scene.nodes.size());
    ConstantKeys constant(scene);
    Warnings ignored;  // a pose gives the same
    for (const PlayedChannel& played : playedChannels(scene, animations, ignored)) {
        if (constant.are(played)) continue;
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

}  // namespace

std::vector<bool> movingNodes(const Scene& scene, const std::vector<uint32_t>& animations) {
    return naming("cannot find what moves in '" + scene.name + "'", [&] { return findMovingNodes(scene, animations); });
}

uint64_t countMoving(const PosedScene& posed, const std::vector<bool>& movingNodes) {
    uint64_t count = 0;
    for (const ShownMesh& mesh : posed.meshes)
        if (movingNodes[mesh.node]) count += mesh.triangles;
    return count;
}

std::vector<TriangleRun> runsThat(bool move, const PosedScene& posed, const std::vector<bool>& movingNodes) {
    std::vector<TriangleRun> runs;
    size_t first = 0;
    for (const ShownMesh& mesh : posed.meshes) {
        if (movingNodes[mesh.node] == move && mesh.triangles > 0) {
            if (!runs.empty() && runs.back().first + runs.back().count == first)
                runs.back().count += mesh.triangles;
            else
                runs.push_back({first, mesh.triangles});
        }
        first += mesh.triangles;
    }
    return runs;
}

std::vector<uint32_t> trianglesThat(bool move, const PosedScene& posed, const std::vector<bool>& movingNodes) {
    std::vector<uint32_t> numbers;
    for (const TriangleRun& run : runsThat(move, posed, movingNodes))
        for (size_t i = 0; i < run.count; ++i) numbers.push_back(static_cast<uint32_t>(run.first + i));
    return numbers;
}

}  // namespace cleave
