// Rays made to go wrong, by family. A family fixes how its rays relate to the scene or to the very tree under test.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "shared/ray.h"
#include "stability/random.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// The target that rays are aimed at.
struct Target {
    std::span<const Triangle> world;
    const TriangleSet& set;  // of these triangles
    const KdTree* tree;      // only for families that ask for one
    uint64_t count;          // of rays wanted; fewer come where the scene offers nothing to aim at
    uint64_t seed;
    // Closest hits of rays, for families that start from hits.
    std::function<std::vector<Hit>(std::span<const Ray>)> answer;
};

struct RayFamily {
    std::string_view name;
    std::string_view about;  // half a sentence
    // Most rays pass through edges or vertices on purpose, or end at a hit: what the reference leaves undecided there
    // is counted, not bounded.
    bool isEdgeFamily;
    bool needsTree;  // rays differ from tree to tree
    std::vector<Ray> (*make)(const Target& target);
};

// In the order in which they are shot and listed.
std::span<const RayFamily> rayFamilies();

// By group, a file each.
std::span<const RayFamily> generalFamilies();
std::span<const RayFamily> edgeFamilies();
std::span<const RayFamily> treeFamilies();

}  // namespace cleave
