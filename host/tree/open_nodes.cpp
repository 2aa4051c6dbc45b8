#include "tree/open_nodes.h"

#include <algorithm>

#include "shared/box.h"
#include "shared/build.h"

namespace cleave {
namespace {

struct Place {
    uint32_t node;
    uint32_t depth;
    Box cell;
};

OpenNode openNode(const Place& at, const KdNode& leaf) {
    return {{at.cell.lo.x, at.cell.lo.y, at.cell.lo.z},
            {at.cell.hi.x, at.cell.hi.y, at.cell.hi.z},
            at.node,
            leafFirst(leaf),
            leafCount(leaf),
            at.depth,
            0,
            0};
}

}  // namespace

std::vector<OpenNode> openNodesOf(const Box& bounds, std::span<const KdNode> nodes, uint32_t included,
                                  const BuildInfo& info) {
    const uint32_t deepest = depthLimit(info.maxDepth, included);
    std::vector<OpenNode> open;
    std::vector<Place> ahead{{0, 0, bounds}};
    while (!ahead.empty()) {
        const Place at = ahead.back();
        ahead.pop_back();
        const KdNode& node = nodes[at.node];
        if (!isLeaf(node)) {
            const uint32_t axis = nodeAxis(node);
            const uint32_t child = nodeChild(node);
            ahead.push_back({child, at.depth + 1, leftOf(at.cell, axis, nodePosition(node))});
            ahead.push_back({child + 1, at.depth + 1, rightOf(at.cell, axis, nodePosition(node))});
        } else if (leafCount(node) > kSubtree && leafCount(node) <= openLimit(info) && at.depth < deepest) {
            open.push_back(openNode(at, node));
        }
    }
    std::ranges::sort(open, {}, &OpenNode::node);
    return open;
}

}  // namespace cleave
