#include "scene/animation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scene/key_values.h"
#include "scene/morph_targets.h"
#include "scene/not_found.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

void play(const Scene& scene, const gltf::Channel& channel, const KeyValues& keys, double seconds, NodeState& state) {
    switch (channel.path) {
        case gltf::Path::translation:
            state.transform.translation = keys.vec3At(seconds);
            break;
        case gltf::Path::rotation:
            state.transform.rotation = keys.rotationAt(seconds);
            break;
        case gltf::Path::scale:
            state.transform.scale = keys.vec3At(seconds);
            break;
        case gltf::Path::weights:
            state.weights = keys.scalarsAt(seconds, morphTargetsOf(scene, channel.node));
            break;
    }
}

// The parts of nodes that channels have moved already.
using Moved = std::set<std::pair<uint32_t, gltf::Path>>;

// Says why a channel cannot be played; empty if it can be.
std::string whyNot(const Scene& scene, const gltf::Channel& channel, const gltf::AnimationSampler& sampler,
                   const Moved& moved) {
    if (!hasBytes(scene, sampler.input) || !hasBytes(scene, sampler.output))
        return "its keys are in a buffer that is not there";
    if (channel.path != gltf::Path::weights && scene.nodes[channel.node].transform.matrix)
        return "its node has a matrix";
    return moved.contains({channel.node, channel.path}) ? "an earlier channel moves the same" : "";
}

}  // namespace

std::vector<uint32_t> chooseAnimation(const Scene& scene, const std::string& nameOrIndex) {
    if (nameOrIndex.empty()) return scene.animations.empty() ? std::vector<uint32_t>{} : std::vector<uint32_t>{0};
    return {uint32_t(findNamed(scene.animations, nameOrIndex, "animation", scene.name))};
}

std::vector<uint32_t> allAnimations(const Scene& scene) {
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < scene.animations.size(); ++i) all.push_back(i);
    return all;
}

std::vector<NodeState> restStates(const Scene& scene) {
    std::vector<NodeState> states;
    for (const gltf::Node& node : scene.nodes) {
        const bool byMesh = node.weights.empty() && node.mesh;
        states.push_back({node.transform, byMesh ? scene.meshes[*node.mesh].weights : node.weights});
    }
    return states;
}

std::vector<PlayedChannel> playedChannels(const Scene& scene, const std::vector<uint32_t>& animations,
                                          Warnings& warnings) {
    std::vector<PlayedChannel> played;
    Moved moved;
    for (uint32_t i : animations) {
        const gltf::Animation& animation = scene.animations.at(i);
        for (size_t c = 0; c < animation.channels.size(); ++c) {
            const gltf::Channel& channel = animation.channels[c];
            const gltf::AnimationSampler& sampler = animation.samplers[channel.sampler];
            const std::string why = whyNot(scene, channel, sampler, moved);
            if (!why.empty()) {
                warnings.add("animation " + std::to_string(i) + ", channel " + std::to_string(c) +
                             " is left out: " + why);
                continue;
            }
            played.push_back({channel, sampler});
            moved.insert({channel.node, channel.path});
        }
    }
    return played;
}

double endOf(const Scene& scene, const std::vector<uint32_t>& animations) {
    double end = 0.0;
    Warnings ignored;
    for (const PlayedChannel& played : playedChannels(scene, animations, ignored)) {
        const std::vector<double> times = keyTimes(scene, played.sampler.input);
        if (!times.empty()) end = std::max(end, times.back());
    }
    return end;
}

void animate(const Scene& scene, const PoseTime& time, std::vector<NodeState>& states, Warnings& warnings) {
    if (!time.seconds) return;
    if (!std::isfinite(*time.seconds)) refuseGltf("the time is not a finite number of seconds", "give one that is");
    std::map<uint32_t, std::vector<double>> times;  // by accessor
    for (const auto& [channel, sampler] : playedChannels(scene, time.animations, warnings)) {
        auto known = times.find(sampler.input);  // samplers often share theirs
        if (known == times.end()) known = times.emplace(sampler.input, keyTimes(scene, sampler.input)).first;
        const KeyValues keys(scene, sampler, known->second);
        play(scene, channel, keys, *time.seconds, states[channel.node]);
    }
}

}  // namespace cleave
