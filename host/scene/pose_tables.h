// What a device needs to pose the triangles that move (shared/pose.h).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/pose.h"
#include "shared/pose.h"

namespace cleave {

// What is the same at all times.
struct PoseTables {
    std::vector<PosePart> parts;
    std::vector<glm::dvec3> positions;
    std::vector<PoseMorph> morphs;
    std::vector<glm::dvec3> deltas;
    std::vector<PoseInfluence> influences;
    std::vector<uint32_t> corners;  // of triangles that move: numbers of posed vertices
    std::vector<uint32_t> numbers;  // of these triangles
    uint32_t vertices = 0;          // of all parts
};

// What a time has.
struct PoseMotion {
    std::vector<AffineMap> maps;  // of each mesh that moves: where it stands, and of its skin
    std::vector<double> weights;  // of morph targets
};

// Makes the tables of nodes that move (moving_nodes.h), for triangles with the numbers that they have in `posed`.
// Returns nothing where these take more than `mostBytes`, or where pose() may find fault with the scene at another
// time: it is left to pose() to say so.
std::optional<PoseTables> poseTables(const Scene& scene, const PosedScene& posed, const std::vector<bool>& movingNodes,
                                     uint64_t mostBytes);

// With the tables of the same nodes it makes the triangles that pose() makes at this time, to the last bit. Throws
// Error as pose() does.
PoseMotion poseMotion(const Scene& scene, const PoseTime& time, const std::vector<bool>& movingNodes);

}  // namespace cleave
