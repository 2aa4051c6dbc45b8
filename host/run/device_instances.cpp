#include "run/device_instances.h"

namespace cleave {

uint64_t DeviceInstances::bytes() const {
    uint64_t sum = memory.size();
    for (const auto& tree : trees) sum += tree->memory.size();
    return sum;
}

DeviceInstances placeTrees(Device& device, std::vector<std::shared_ptr<DeviceTree>> trees,
                           std::span<const PlaceNode> nodes, std::vector<PlacedMesh> places,
                           std::span<const uint32_t> treeOf, int exponent) {
    for (size_t i = 0; i < places.size(); i++) places[i].tree = trees[treeOf[i]]->address();
    const uint64_t atNodes = sizeof(PlacedScene), atPlaces = atNodes + nodes.size_bytes();
    const uint64_t placeBytes = places.size() * sizeof(PlacedMesh);
    DeviceInstances made;
    made.trees = std::move(trees);
    made.memory = Buffer(device, atPlaces + placeBytes);
    PlacedScene scene{};
    scene.nodes = made.address() + atNodes;
    scene.meshes = made.address() + atPlaces;
    scene.count = static_cast<uint32_t>(places.size());
    scene.exponent = exponent;
    made.exponent = exponent;
    if (!nodes.empty()) made.bounds = nodes[0].box;
    made.memory.write(0, &scene, sizeof(scene));
    made.memory.write(atNodes, nodes.data(), nodes.size_bytes());
    made.memory.write(atPlaces, places.data(), placeBytes);
    return made;
}

}  // namespace cleave
