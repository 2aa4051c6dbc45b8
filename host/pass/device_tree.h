// Triangles and a tree on the device, ready to trace.
#pragma once

#include <memory>

#include "gpu/context.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// The scene's triangles on the device; shared by every tree over them.
class DeviceTriangles;
std::shared_ptr<DeviceTriangles> uploadTriangles(Context& context, const TriangleSet& set);

// A tree on the device, with its triangles.
class DeviceTree;
std::shared_ptr<DeviceTree> uploadTree(Context& context, std::shared_ptr<DeviceTriangles> triangles,
                                       const KdTree& tree);
KdTree readBack(Context& context, const DeviceTree& tree);

}  // namespace cleave
