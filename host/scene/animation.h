// Animations: they move nodes and weights to where they are at a time.
#pragma once

#include <vector>

#include "scene/pose.h"
#include "scene/refuse.h"

namespace cleave {

// The parts of a node that can move.
struct NodeState {
    gltf::Transform transform;
    std::vector<double> weights;  // of morph targets
};

// Returns the states of all nodes as the file has them. Weights of a node take the place of its mesh's; none stand
// for 0.
std::vector<NodeState> restStates(const Scene& scene);

// A channel, and the sampler that it plays.
struct PlayedChannel {
    gltf::Channel channel;
    gltf::AnimationSampler sampler;
};

// Returns the channels of these animations that are played. The others are left out with a warning: where an earlier
// one moves the same thing, where a node has a matrix, or where keys are in a buffer that is not there.
std::vector<PlayedChannel> playedChannels(const Scene& scene, const std::vector<uint32_t>& animations,
                                          Warnings& warnings);

// Returns the time of the last key of these animations, in seconds; 0 without any. Throws Error as animate() does.
double endOf(const Scene& scene, const std::vector<uint32_t>& animations);

// Moves `states` to a time, by the channels that are played. Throws Error if times do not increase.
void animate(const Scene& scene, const PoseTime& time, std::vector<NodeState>& states, Warnings& warnings);

}  // namespace cleave
