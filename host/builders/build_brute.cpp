#include "builders/builders.h"

namespace cleave {

KdTree buildBrute(const TriangleSet& set, const BuildSettings&, BuildReport* report) {
    KdTree tree;
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    tree.leafTriangles = set.included;
    tree.nodes.push_back(leafNode(0, static_cast<uint32_t>(set.included.size())));
    if (report != nullptr) *report = {tree.nodes.capacity() * sizeof(KdNode) + set.included.size() * sizeof(uint32_t)};
    return tree;
}

}  // namespace cleave
