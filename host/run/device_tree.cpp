#include "run/device_tree.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "run/lazy_tree.h"
#include "shared/scale.h"
#include "shared/tree_layout.h"

namespace cleave {
namespace {

uint64_t bytesOf(uint32_t blocks) { return uint64_t(16) * blocks; }

}  // namespace

DeviceTriangles::DeviceTriangles(Device& device, std::span<const Triangle> world) {
    if (world.size() > kMaxLink) throw Error("the scene has more than 2^30 triangles; split it");
    triangles = uploaded(device, world);
    count = static_cast<uint32_t>(world.size());
}

void DeviceTriangles::move(std::span<const Triangle> world, size_t first, size_t many) {
    const std::span<const Triangle> moved = world.subspan(first, many);
    triangles.write(first * sizeof(Triangle), moved.data(), moved.size_bytes());
}

Geometry DeviceTriangles::geometry() const {
    Geometry g;
    g.vertices = triangles.address();
    g.vertexCount = 3 * count;
    g.triangleCount = count;
    return g;
}

Box DeviceTree::bounds() const {
    return {{header.lo[0], header.lo[1], header.lo[2]}, {header.hi[0], header.hi[1], header.hi[2]}};
}

Forest::Forest(LazyTree& grows) : trees{&grows.tree()}, lazy(&grows) {}

int Forest::exponent() const {
    std::optional<int> largest;
    for (const DeviceTree* tree : trees)
        if (!isEmpty(tree->bounds()))
            largest = std::max(largest.value_or(tree->header.exponent), tree->header.exponent);
    return largest.value_or(trees.front()->header.exponent);
}

Box Forest::bounds() const {
    Box all = emptyBox();
    for (const DeviceTree* tree : trees) {
        const Box own = tree->bounds();
        if (isEmpty(own)) continue;
        const int shift = tree->header.exponent - exponent();
        all = including(including(all, timesPowerOfTwo(own.lo, shift)), timesPowerOfTwo(own.hi, shift));
    }
    return all;
}

std::shared_ptr<DeviceTree> uploadTree(Device& device, const TriangleSet& set, const KdTree& tree,
                                       std::span<const uint32_t> numbers) {
    const auto triangles = static_cast<uint32_t>(set.triangles.size());
    const auto nodes = static_cast<uint32_t>(tree.nodes.size());
    const auto leafRefs = static_cast<uint32_t>(tree.leafTriangles.size());
    const TreeLayout at = treeLayout(triangles, nodes, leafRefs);
    auto made = std::make_shared<DeviceTree>();
    made->memory = Buffer(device, bytesOf(at.end));
    TreeHeader& h = made->header;
    h.magic = TreeHeader::kMagic;
    h.format = kTreeFormat;
    h.triangleCount = triangles;
    h.nodeCount = nodes;
    h.leafRefCount = leafRefs;
    h.nonFinite = static_cast<uint32_t>(set.nonFinite);
    h.noArea = static_cast<uint32_t>(set.noArea);
    h.exponent = tree.exponent;
    std::memcpy(h.lo, &tree.bounds.lo, sizeof(h.lo));
    std::memcpy(h.hi, &tree.bounds.hi, sizeof(h.hi));
    h.bytes = bytesOf(at.end);
    h.triangles = made->address() + bytesOf(at.triangles);
    h.nodes = made->address() + bytesOf(at.nodes);
    h.leafRefs = made->address() + bytesOf(at.leafRefs);
    made->memory.write(0, &h, sizeof(h));
    std::vector<TreeTriangle> numbered;
    numbered.reserve(triangles);
    for (uint32_t i = 0; i < triangles; i++)
        numbered.push_back(treeTriangle(set.triangles[i], numbers.empty() ? i : numbers[i]));
    made->isOfList = !numbers.empty();
    made->memory.write(bytesOf(at.triangles), numbered.data(), triangles * sizeof(TreeTriangle));
    made->memory.write(bytesOf(at.nodes), tree.nodes.data(), nodes * sizeof(KdNode));
    made->memory.write(bytesOf(at.leafRefs), tree.leafTriangles.data(), leafRefs * sizeof(uint32_t));
    return made;
}

KdTree readBack(const DeviceTree& device) {
    const TreeHeader& h = device.header;
    const auto read = [&](uint64_t address, auto& items, size_t count) {
        items.resize(count);
        device.memory.read(address - device.address(), items.data(), count * sizeof(items[0]));
    };
    KdTree tree;
    tree.bounds = device.bounds();
    tree.exponent = h.exponent;
    read(h.nodes, tree.nodes, h.nodeCount);
    read(h.leafRefs, tree.leafTriangles, h.leafRefCount);
    if (device.isOfList) {
        std::vector<TreeTriangle> triangles;
        read(h.triangles, triangles, h.triangleCount);
        for (uint32_t& triangle : tree.leafTriangles) triangle = triangles[triangle].number;
    }
    return tree;
}

}  // namespace cleave
