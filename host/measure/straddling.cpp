#include "measure/straddling.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

namespace cleave {
namespace {

// The triangles below a node, ascending.
std::vector<uint32_t> trianglesBelow(const KdTree& tree, uint32_t index, std::vector<CutNode>& nodes) {
    const KdNode node = tree.nodes[index];
    if (isLeaf(node)) {
        const auto begin = tree.leafTriangles.begin() + leafFirst(node);
        std::vector<uint32_t> listed(begin, begin + leafCount(node));
        std::sort(listed.begin(), listed.end());
        return listed;
    }
    const std::vector<uint32_t> left = trianglesBelow(tree, nodeChild(node), nodes);
    const std::vector<uint32_t> right = trianglesBelow(tree, nodeChild(node) + 1, nodes);
    std::vector<uint32_t> both;
    both.reserve(left.size() + right.size());
    std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(both));
    nodes.push_back(
        {static_cast<uint32_t>(both.size()), static_cast<uint32_t>(left.size() + right.size() - both.size())});
    return both;
}

struct Octave {
    double nodes = 0.0, triangles = 0.0, straddling = 0.0;
};

}  // namespace

std::vector<CutNode> cutNodes(const KdTree& tree) {
    std::vector<CutNode> nodes;
    trianglesBelow(tree, 0, nodes);
    return nodes;
}

StraddlingLaw fitStraddling(std::span<const CutNode> nodes, uint32_t fewest) {
    std::array<Octave, 33> octaves;
    for (const CutNode& node : nodes) {
        if (node.triangles < fewest) continue;
        Octave& octave = octaves[static_cast<size_t>(std::bit_width(node.triangles))];
        octave.nodes += 1.0;
        octave.triangles += node.triangles;
        octave.straddling += node.straddling;
    }
    double count = 0.0, sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0;
    for (const Octave& octave : octaves) {
        if (octave.straddling == 0.0) continue;
        const double x = std::log(octave.triangles / octave.nodes), y = std::log(octave.straddling / octave.nodes);
        count += 1.0;
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
    }
    StraddlingLaw law;
    law.octaves = static_cast<uint32_t>(count);
    if (law.octaves < 2) return law;
    law.exponent = (count * sumXY - sumX * sumY) / (count * sumXX - sumX * sumX);
    law.factor = std::exp((sumY - law.exponent * sumX) / count);
    return law;
}

}  // namespace cleave
