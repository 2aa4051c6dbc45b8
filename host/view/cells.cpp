#include "view/cells.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "tree/walk.h"

namespace cleave {
namespace {

using glm::dvec3;

WorldBox worldBox(const KdTree& tree, const Box& cell) {
    const double unit = std::ldexp(1.0, tree.exponent);
    return {dvec3(cell.lo) * unit, dvec3(cell.hi) * unit};
}

struct Interval {
    double entry = 0.0, exit = 0.0;
};

// Empty, entry above exit, if the ray does not pass the box.
Interval passage(const Ray& ray, const WorldBox& box) {
    Interval within{double{ray.tMin}, double{ray.tMax}};
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = double{ray.origin[axis]}, direction = double{ray.direction[axis]};
        if (direction == 0.0) {
            if (origin < box.lo[axis] || origin > box.hi[axis]) return {1.0, 0.0};
            continue;
        }
        const double a = (box.lo[axis] - origin) / direction, b = (box.hi[axis] - origin) / direction;
        within.entry = std::max(within.entry, std::min(a, b));
        within.exit = std::min(within.exit, std::max(a, b));
    }
    return within;
}

}  // namespace

WorldBox rootCell(const KdTree& tree) { return worldBox(tree, tree.bounds); }

std::vector<CutPlane> cutPlanes(const KdTree& tree, uint32_t level, size_t most) {
    std::vector<CutPlane> planes;
    std::deque<NodeVisit> open{rootVisit(tree)};
    while (!open.empty() && planes.size() < most) {
        const NodeVisit at = open.front();
        open.pop_front();
        const KdNode node = tree.nodes[at.node];
        if (isLeaf(node) || at.depth >= level) continue;
        CutPlane plane{worldBox(tree, at.cell), nodeAxis(node), at.depth};
        const auto axis = static_cast<int>(plane.axis);
        plane.box.lo[axis] = plane.box.hi[axis] = std::ldexp(double{nodePosition(node)}, tree.exponent);
        planes.push_back(plane);
        for (const NodeVisit& child : childVisits(tree, at)) open.push_back(child);
    }
    return planes;
}

std::vector<PassedLeaf> leavesAlong(const KdTree& tree, const Ray& ray) {
    std::vector<PassedLeaf> leaves;
    if (ray.direction == vec3(0.0f)) return leaves;
    std::vector<NodeVisit> open{rootVisit(tree)};
    while (!open.empty()) {
        const NodeVisit at = open.back();
        open.pop_back();
        const WorldBox box = worldBox(tree, at.cell);
        const Interval within = passage(ray, box);
        if (!(within.entry <= within.exit)) continue;
        const KdNode node = tree.nodes[at.node];
        if (isLeaf(node)) {
            leaves.push_back({box, at.depth, leafCount(node), within.entry, within.exit});
            continue;
        }
        for (const NodeVisit& child : childVisits(tree, at)) open.push_back(child);
    }
    std::ranges::stable_sort(leaves, {}, [](const PassedLeaf& leaf) { return leaf.entry + leaf.exit; });
    return leaves;
}

}  // namespace cleave
