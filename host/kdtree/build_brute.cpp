#include "kdtree/builders.h"

namespace cleave {

KdTree buildBrute(const TriangleSet& set) {
    KdTree tree;
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    tree.leafTriangles = set.included;
    tree.nodes.push_back(leafNode(0, static_cast<uint32_t>(set.included.size())));
    return tree;
}

}  // namespace cleave
