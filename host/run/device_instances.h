// Meshes that stand in places, on the device.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "run/device_tree.h"
#include "shared/placed_mesh.h"

namespace cleave {

struct DeviceInstances {
    std::vector<std::shared_ptr<DeviceTree>> trees;  // each once
    Buffer memory;                                   // PlacedScene, nodes, places
    Box bounds = emptyBox();                         // as a copied scene's tree has them, scaled by
    int exponent = 0;                                // this

    uint64_t address() const { return memory.address(); }
    // Of all of it.
    uint64_t bytes() const;
};

// Puts the trees where the places say. `treeOf`: of each place, an index into `trees`; `exponent`: as PlacedScene has
// it.
DeviceInstances placeTrees(Device& device, std::vector<std::shared_ptr<DeviceTree>> trees,
                           std::span<const PlaceNode> nodes, std::vector<PlacedMesh> places,
                           std::span<const uint32_t> treeOf, int exponent);

}  // namespace cleave
