#include "tree/kd_tree.h"

#include <algorithm>
#include "base/error.h"
#include "base/hash.h"
#include "shared/build.h"

namespace cleave {
namespace {

[[noreturn]] void refuse(uint64_t node) {
    throw Error("cannot hash the tree: node " + std::to_string(node) +
                " links to what is not there or was seen before; validate the tree first");
}

void addLeaf(Hash& hash, const KdTree& tree, uint32_t node, std::vector<uint32_t>& list) {
    const uint64_t first = leafFirst(tree.nodes[node]);
    const uint64_t count = leafCount(tree.nodes[node]);
    if (first + count > tree.leafTriangles.size()) refuse(node);
    const auto begin = tree.leafTriangles.begin() + static_cast<std::ptrdiff_t>(first);
    list.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    std::sort(list.begin(), list.end());
    hash.add(kLeafAxis);
    hash.add(static_cast<uint32_t>(count));
    for (const uint32_t triangle : list) hash.add(triangle);
}

}  // namespace

SahCosts splitCosts(const BuildSettings& settings) {
    SahCosts costs = settings.costs;
    if (settings.stop == StopRule::equation41) costs.traverse = costs.leaf = 0.0f;
    return costs;
}

uint32_t depthLimit(const BuildSettings& settings, uint64_t triangleCount) {
    return depthLimit(settings.maxDepth, static_cast<uint32_t>(std::min<uint64_t>(triangleCount, kMaxLink)));
}

// Bounds and exponent are no choice of a builder and stay out.
std::string treeHash(const KdTree& tree) {
    Hash hash;
    std::vector<uint32_t> queue{0};  // breadth-first; what was treated stays in front
    std::vector<uint32_t> list;
    if (tree.nodes.empty()) refuse(0);
    for (size_t next = 0; next < queue.size(); ++next) {
        const uint32_t index = queue[next];
        const KdNode node = tree.nodes[index];
        if (isLeaf(node)) {
            addLeaf(hash, tree, index, list);
            continue;
        }
        const uint32_t child = nodeChild(node);
        if (child + size_t{1} >= tree.nodes.size() || queue.size() + 2 > tree.nodes.size()) refuse(index);
        hash.add(nodeAxis(node));
        hash.add(node.plane);
        queue.push_back(child);
        queue.push_back(child + 1);
    }
    return hash.text();
}

}  // namespace cleave
