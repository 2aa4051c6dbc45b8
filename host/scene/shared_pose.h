// Posing without copies: a mesh that stands in many places is kept once, beside where it stands.
#pragma once

#include <span>

#include "scene/pose.h"

namespace cleave {

// Triangles of a mesh as its file has them: where they stand, toWorld makes vertices of the world of theirs.
struct SharedMesh {
    std::vector<Triangle> triangles;
    std::vector<uint32_t> materialOf;  // of each triangle, an index into Scene::materials
};

struct MeshPlace {
    uint32_t mesh = 0;   // index into SharedPose::meshes
    uint32_t first = 0;  // number of its first triangle; the others follow in order
    glm::dmat4 toWorld{1.0};
};

struct SharedPose {
    PosedScene posed;               // triangles: of what is not shared; all else: of the whole scene
    std::vector<uint32_t> numbers;  // of these triangles, ascending
    std::vector<SharedMesh> meshes;
    std::vector<MeshPlace> places;  // in the order of their triangles
    size_t triangles = 0;           // of the scene, each place counted
};

// Which meshes may be kept once.
struct Sharing {
    std::vector<bool> meshes;  // of each in Scene::meshes
    size_t triangles = 0;      // of the scene, each place counted
    size_t copies = 0;         // of them, what would be kept less
};

// Finds the meshes that stand in several places and always have the same shape: without morph targets, and where
// positions are floats, or whole numbers, which floats hold. (Normalised ones are quotients in double.) Places of nodes
// with a skin do not count, nor do meshes with fewer triangles than `fewest`, nor those that would make it more than
// 2^20 places.
Sharing sharingOf(const Scene& scene, size_t fewest, size_t mostTriangles = kMostTriangles);

// Poses as pose() does, with the same numbers and warnings; of triangles that are not finite it does not warn.
SharedPose poseShared(const Scene& scene, const PoseTime& time, const Sharing& sharing,
                      size_t mostTriangles = kMostTriangles);

// The warning of triangles that have a vertex that is not finite; none if there is none. `numbers`: theirs; empty:
// their indices.
std::optional<std::string> nonFiniteWarning(std::span<const Triangle> triangles,
                                            std::span<const uint32_t> numbers = {});

}  // namespace cleave
