// A tree that is built where rays come to (lazy building: Hunt et al. 2007). Large nodes are split at first; smaller
// ones are left open. Rays that reach an open node mark it and wait; marked nodes are built to their leaves together,
// breadth first, and the rays go on. Hits are those of the whole tree.
#pragma once

#include <memory>

#include "gpu/commands.h"
#include "run/device_tree.h"
#include "run/ranges.h"

namespace cleave {

// References up to which nodes are left open. Of 512 to 32,768 this was best, or nearly so, on scenes of 66,000 to a
// million triangles (docs/lazy.md).
inline constexpr uint32_t kOpenUpTo = 1024;

// What came of it so far.
struct LazyFigures {
    double ms = 0.0;          // of all builds, from triangles on the device to a tree for rays
    double topMs = 0.0;       // of the first
    uint32_t expansions = 0;  // builds after it
    uint32_t openNodes = 0;   // that the first left
    uint32_t stillOpen = 0;   // of these
    uint64_t references = 0;  // in all leaves after the first
    uint64_t neverBuilt = 0;  // of these, in nodes that are still open
    uint64_t peakBytes = 0;   // device memory: scratch and tree
    bool memoryLimited = false;

    double builtShare() const {
        return references == 0 ? 1.0 : 1.0 - static_cast<double>(neverBuilt) / static_cast<double>(references);
    }
};

class LazyTree {
  public:
    // Builds the nodes of more than `openUpTo` references. The context has
    // Building::open; triangles and device outlive this. `capacity`: what it begins with. Throws Error.
    LazyTree(Device& device, std::shared_ptr<const Context> context, const DeviceTriangles& triangles,
             const BuildSettings& settings, uint32_t openUpTo, const Capacity& capacity = {});

    // As it is now. expandMarked() may move it.
    const DeviceTree& tree() const { return tree_; }
    VkDeviceAddress address() const { return tree_.address(); }
    // For rays that are to wait (TraceInfo::open).
    VkDeviceAddress open() const { return words_.address(); }
    const LazyFigures& figures() const { return figures_; }

    // Builds what rays have marked. False if that is nothing.
    bool expandMarked();
    // Builds what is still open.
    void expandAll();

  private:
    void reserve();
    void buildTop();
    void findOpenNodes();
    std::vector<OpenNode> takeMarked();
    void expand(std::vector<OpenNode> nodes);
    uint32_t build(std::span<OpenNode> nodes);
    TreeHeader run(const Expansion* expansion);
    bool takeMore(const Capacity& wanted);
    void moveToLarger(const TreeHeader& before);

    Device& device_;
    std::shared_ptr<const Context> context_;
    Commands commands_;
    Geometry geometry_;
    BuildSettings settings_;
    BuildInfo info_;
    RangeBuffers scratch_;
    DeviceTree tree_;
    std::vector<OpenNode> open_;  // that are still open
    Buffer words_;                // of each node of the top: kClosedNode, kOpenNode or kMarkedNode
    LazyFigures figures_;
};

}  // namespace cleave
