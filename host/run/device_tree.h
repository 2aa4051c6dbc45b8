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

// Triangles of a leaf that rays may as well test one by one.
inline constexpr uint32_t kFewInLeaf = 32;

// A finished tree, and what it begins with.
struct DeviceTree {
    Buffer memory;
    TreeHeader header{};
    bool isOfList = false;  // built over some of the triangles: their numbers are not their indices

    uint64_t address() const { return memory.address(); }
    // Whether it is a single leaf, of few triangles (TraceMode::single).
    bool isSingle() const { return header.nodeCount == 1 && header.leafRefCount <= kFewInLeaf; }
    Box bounds() const;
};

class LazyTree;

// Trees that share the triangles of a scene: one, or several that rays visit one after the other. They outlive this.
struct Forest {
    std::vector<const DeviceTree*> trees;
    LazyTree* lazy = nullptr;  // whose tree is the only one: rays wait at its open nodes

    Forest(const DeviceTree& tree) : trees{&tree} {}
    explicit Forest(LazyTree& grows);
    explicit Forest(std::vector<const DeviceTree*> several) : trees(std::move(several)) {}
    // As a tree over all of the triangles would have them.
    int exponent() const;
    Box bounds() const;
    bool isSingle() const { return trees.size() == 1 && !lazy && trees.front()->isSingle(); }
};

// A tree of the host, moved to the device. `set` is what it was built over; `numbers`: those of its triangles; empty:
// their indices.
std::shared_ptr<DeviceTree> uploadTree(Device& device, const TriangleSet& set, const KdTree& tree,
                                       std::span<const uint32_t> numbers = {});
// A tree of the device, on the host. Its leaves list numbers of triangles.
KdTree readBack(const DeviceTree& tree);

}  // namespace cleave
