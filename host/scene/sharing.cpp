#include <algorithm>

#include "scene/instances.h"
#include "scene/node_transforms.h"
#include "scene/shared_pose.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

// A small file can ask for any number of places, by instances; one takes some 650 bytes while a scene is put together.
constexpr size_t kMostPlaces = size_t(1) << 20;

bool areFloats(const gltf::Accessor& accessor) {
    return !accessor.normalized && accessor.componentType != gltf::ComponentType::uint32;
}

bool keepsItsShape(const Scene& scene, const gltf::Mesh& mesh) {
    return std::all_of(mesh.primitives.begin(), mesh.primitives.end(), [&](const gltf::Primitive& primitive) {
        const auto position = primitive.attributes.find("POSITION");
        return primitive.targets.empty() &&
               (position == primitive.attributes.end() || areFloats(scene.accessors[position->second]));
    });
}

size_t trianglesOf(const Scene& scene, const gltf::Mesh& mesh) {
    size_t sum = 0;
    for (const gltf::Primitive& primitive : mesh.primitives)
        if (isReadable(scene, primitive)) sum += triangleCount(primitive.mode, indexCountOf(scene, primitive));
    return sum;
}

}  // namespace

Sharing sharingOf(const Scene& scene, size_t fewest, size_t mostTriangles) {
    Sharing sharing;
    sharing.triangles = countTriangles(scene, mostTriangles);  // which also bounds the products below
    std::vector<size_t> places(scene.meshes.size(), 0);
    for (uint32_t index : shownNodes(scene)) {
        const gltf::Node& node = scene.nodes[index];
        if (node.mesh && !node.skin) places[*node.mesh] += instanceCount(scene, node);
    }
    size_t room = kMostPlaces;
    for (size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        const size_t triangles = trianglesOf(scene, scene.meshes[mesh]);
        const bool isShared = places[mesh] >= 2 && places[mesh] <= room && triangles >= std::max<size_t>(fewest, 1) &&
                              keepsItsShape(scene, scene.meshes[mesh]);
        sharing.meshes.push_back(isShared);
        if (!isShared) continue;
        sharing.copies += (places[mesh] - 1) * triangles;
        room -= places[mesh];
    }
    return sharing;
}

}  // namespace cleave
