// Walks over the nodes of a tree and their cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tree/kd_tree.h"

namespace cleave {

// A node, and where it lies in the tree and in scaled space.
struct NodeVisit {
    uint32_t node = 0;
    uint32_t depth = 0;
    Box cell;
};

inline NodeVisit rootVisit(const KdTree& tree) { return {0, 0, tree.bounds}; }

// The children of an inner node: below the plane, then above.
inline std::array<NodeVisit, 2> childVisits(const KdTree& tree, const NodeVisit& visit) {
    const KdNode node = tree.nodes[visit.node];
    const uint32_t child = nodeChild(node), depth = visit.depth + 1;
    return {{{child, depth, leftOf(visit.cell, nodeAxis(node), nodePosition(node))},
             {child + 1, depth, rightOf(visit.cell, nodeAxis(node), nodePosition(node))}}};
}

// Calls visit(NodeVisit) for every node of a tree whose links are sound: depth first, left children before right ones.
template <class Visit>
void forEachNode(const KdTree& tree, Visit visit) {
    std::vector<NodeVisit> stack{rootVisit(tree)};
    while (!stack.empty()) {
        const NodeVisit at = stack.back();
        stack.pop_back();
        visit(at);
        if (isLeaf(tree.nodes[at.node])) continue;
        const std::array<NodeVisit, 2> children = childVisits(tree, at);
        stack.push_back(children[1]);
        stack.push_back(children[0]);
    }
}

}  // namespace cleave
