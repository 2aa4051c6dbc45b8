// Which nodes move while animations play.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/pose.h"

namespace cleave {

// Returns for each node whether the triangles of its mesh may differ between two times of these animations. They do
// where a channel whose keys differ moves the node or one above it, a joint of its skin, or the weights of its morph
// targets; triangles of the others are the same at all times, to the last bit. Throws Error
// if times of keys do not increase.
std::vector<bool> movingNodes(const Scene& scene, const std::vector<uint32_t>& animations);

// How many triangles nodes that move have, and the numbers of theirs or of the others.
uint64_t countMoving(const PosedScene& posed, const std::vector<bool>& movingNodes);
std::vector<uint32_t> trianglesThat(bool move, const PosedScene& posed, const std::vector<bool>& movingNodes);

// Triangles whose numbers follow each other.
struct TriangleRun {
    size_t first = 0;
    size_t count = 0;
};
// Those of nodes that move, or of the others; runs do not touch.
std::vector<TriangleRun> runsThat(bool move, const PosedScene& posed, const std::vector<bool>& movingNodes);

}  // namespace cleave
