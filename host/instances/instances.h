// A scene whose meshes stand in many places, as it is traced: each mesh once, a record of each place, and the rest.
#pragma once

#include <span>
#include <vector>

#include "instances/place_tree.h"
#include "scene/shared_pose.h"

namespace cleave {

struct Instances {
    size_t triangles = 0;     // of the scene, each place counted
    int exponent = 0;         // of the copied scene's tree
    Box bounds = emptyBox();  // of triangles with finite vertices, in the world
    // What has a tree of its own: the meshes and, last where it has any, the rest in the world.
    std::vector<std::vector<Triangle>> meshes;
    // Triangles of the world that no mesh holds: what does not stand in several places, what cannot be placed, and
    // slivers. Their numbers in the scene, ascending.
    std::vector<Triangle> rest;
    std::vector<uint32_t> restNumbers;
    // In the order of leaves. Trees are still to be filled in: treeOf has the index of each mesh, meshes.size() for the
    // rest.
    std::vector<PlacedMesh> places;
    std::vector<uint32_t> treeOf;
    std::vector<PlaceNode> nodes;
    size_t noArea = 0;        // triangles of places that have no area, whatever the place
    size_t copiedPlaces = 0;  // of meshes that cannot be placed there
};

// Takes what it keeps out of `shared`.
Instances instancesOf(SharedPose& shared);

}  // namespace cleave
