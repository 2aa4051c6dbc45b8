// Triangles and trees on the device.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "cleave/cleave.hpp"
#include "gpu/buffer.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// A scene's triangles in world space, numbered; every tree is built over them, and pictures take their normals.
struct DeviceTriangles {
    Buffer triangles;  // Triangle
    uint32_t count = 0;

    DeviceTriangles(Device& device, std::span<const Triangle> world);
    // Takes `many` of the triangles from `first` on to where `world` has them now.
    void move(std::span<const Triangle> world, size_t first, size_t many);
    // As what a tree is built over.
    Geometry geometry() const;
};

// A finished tree, and what it begins with.
struct DeviceTree {
    Buffer memory;
    TreeHeader header{};
    bool isOfList = false;  // built over some of the triangles: their numbers are not their indices

    uint64_t address() const { return memory.address(); }
    Box bounds() const;
};

// Trees that share the triangles of a scene: one, or several that rays visit one after the other. They outlive this.
struct Forest {
    std::vector<const DeviceTree*> trees;

    Forest(const DeviceTree& tree) : trees{&tree} {}
    explicit Forest(std::vector<const DeviceTree*> several) : trees(std::move(several)) {}
    // As a tree over all of the triangles would have them.
    int exponent() const;
    Box bounds() const;
};

// A tree of the host, moved to the device. `set` is what it was built over; `numbers`: those of its triangles; empty:
// their indices.
std::shared_ptr<DeviceTree> uploadTree(Device& device, const TriangleSet& set, const KdTree& tree,
                                       std::span<const uint32_t> numbers = {});
// A tree of the device, on the host. Its leaves list numbers of triangles.
KdTree readBack(const DeviceTree& tree);

}  // namespace cleave
