#include "pass/device_tree.h"

#include "base/error.h"
#include "pass/device_arrays.h"
#include "twin/build_capacity.h"

namespace cleave {

std::shared_ptr<DeviceTriangles> uploadTriangles(Context& context, const TriangleSet& set) {
    if (set.triangles.size() > kMaxLink) throw Error("the scene has more than 2^30 triangles; split it");
    auto device = std::make_shared<DeviceTriangles>();
    device->triangles = Buffer(context, set.triangles.size() * sizeof(Triangle));
    device->triangles.upload(std::span(set.triangles));
    device->included = Buffer(context, set.included.size() * sizeof(uint32_t));
    device->included.upload(std::span(set.included));
    device->count = static_cast<uint32_t>(set.triangles.size());
    device->includedCount = static_cast<uint32_t>(set.included.size());
    device->root = rootCell(set);
    device->exponent = set.exponent;
    return device;
}

std::shared_ptr<DeviceTree> uploadTree(Context& context, std::shared_ptr<DeviceTriangles> triangles,
                                       const KdTree& tree) {
    auto device = std::make_shared<DeviceTree>();
    device->triangles = std::move(triangles);
    device->nodes = Buffer(context, tree.nodes.size() * sizeof(KdNode));
    device->nodes.upload(std::span(tree.nodes));
    device->leafTriangles = Buffer(context, tree.leafTriangles.size() * sizeof(uint32_t));
    device->leafTriangles.upload(std::span(tree.leafTriangles));
    device->nodeCount = static_cast<uint32_t>(tree.nodes.size());
    device->leafRefCount = static_cast<uint32_t>(tree.leafTriangles.size());
    device->bounds = tree.bounds;
    device->exponent = tree.exponent;
    return device;
}

KdTree readBack(Context&, const DeviceTree& device) {
    KdTree tree;
    tree.bounds = device.bounds;
    tree.exponent = device.exponent;
    tree.nodes = device.nodes.download<KdNode>(device.nodeCount);
    tree.leafTriangles = device.leafTriangles.download<uint32_t>(device.leafRefCount);
    return tree;
}

}  // namespace cleave
