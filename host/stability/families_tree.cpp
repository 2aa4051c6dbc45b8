// Rays inside the split planes of the tree under test, along the edges of its cells, and through their corners.
#include <cmath>

#include "shared/scale.h"
#include "stability/aim.h"
#include "tree/walk.h"

namespace cleave {
namespace {

// A split plane and the cell that it splits, in world space.
struct Split {
    int axis;
    float position;
    Box cell;
};

// Up to `most` inner nodes from all over the tree. Planes that leave the range of normal floats in world space are left
// out: a ray could not lie in them.
std::vector<Split> splitsOf(const KdTree& tree, size_t most) {
    const auto world = [&](const Box& box) {
        return Box{timesPowerOfTwo(box.lo, tree.exponent), timesPowerOfTwo(box.hi, tree.exponent)};
    };
    const size_t stride = 1 + tree.nodes.size() / most;
    std::vector<Split> splits;
    std::vector<NodeVisit> stack{rootVisit(tree)};
    for (size_t seen = 0; !stack.empty(); ++seen) {
        const NodeVisit at = stack.back();
        stack.pop_back();
        const KdNode node = tree.nodes[at.node];
        if (isLeaf(node)) continue;
        const int axis = static_cast<int>(nodeAxis(node));
        const float position = nodePosition(node), placed = timesPowerOfTwo(position, tree.exponent);
        if (seen % stride == 0 && timesPowerOfTwo(placed, -tree.exponent) == position)
            splits.push_back({axis, placed, world(at.cell)});
        for (const NodeVisit& child : childVisits(tree, at)) stack.push_back(child);
    }
    return splits;
}

template <class Make>
std::vector<Ray> collectFrom(const Target& target, Make make) {
    const std::vector<Split> splits = splitsOf(*target.tree, 20000);
    if (splits.empty()) return {};
    const Place place = placeOf(target.set);
    return collect(target, [&](Random& random, uint64_t i) {
        return make(random, place, splits[random.below(splits.size())], i);
    });
}

dvec3 inCell(Random& random, const Split& split) { return random.inBox(dvec3(split.cell.lo), dvec3(split.cell.hi)); }

// The corner where the plane meets two faces of its cell: often planes of nodes above, at times those of the root.
vec3 anyCorner(Random& random, const Split& split) {
    vec3 corner;
    for (int axis = 0; axis < 3; ++axis)
        corner[axis] = random.below(2) == 0 ? split.cell.lo[axis] : split.cell.hi[axis];
    corner[split.axis] = split.position;
    return corner;
}

// Origin and direction in the plane.
std::vector<Ray> planeRays(const Target& target) {
    return collectFrom(target, [&](Random& random, const Place& place, const Split& split, uint64_t i) {
        const dvec3 to = inCell(random, split);
        const dvec3 from = i % 2 == 0 ? around(random, place) : inCell(random, split);
        Ray ray = i % 8 == 0 ? alongAxis(random, place, vec3(to)) : aimed(from, to);
        ray.origin[split.axis] = split.position;
        ray.direction[split.axis] = random.below(2) == 0 ? 0.0f : -0.0f;
        return ray;
    });
}

// Along the line where the plane meets a face of its cell.
std::vector<Ray> kdEdgeRays(const Target& target) {
    return collectFrom(target, [&](Random& random, const Place& place, const Split& split, uint64_t i) {
        const vec3 corner = anyCorner(random, split);
        const int along = (split.axis + 1 + static_cast<int>(random.below(2))) % 3;
        const bool up = random.below(2) == 0;
        Ray ray{corner, 0.0f, vec3(random.below(2) == 0 ? 0.0f : -0.0f), infinity()};
        ray.direction[along] = up ? 1.0f : -1.0f;
        const double from = up ? place.lo[along] - 0.5 * place.diagonal : place.hi[along] + 0.5 * place.diagonal;
        if (i % 4 != 0) ray.origin[along] = static_cast<float>(from);
        return ray;
    });
}

std::vector<Ray> kdCornerRays(const Target& target) {
    return collectFrom(target, [&](Random& random, const Place& place, const Split& split, uint64_t i) {
        const vec3 corner = anyCorner(random, split);
        if (i % 4 == 0) return aimed(corner, vec3(around(random, place)));
        if (i % 4 == 1) return alongAxis(random, place, corner);
        if (i % 4 == 2) return aimed(vec3(around(random, place)), corner);
        const vec3 diagonal(dvec3(random.sign(), random.sign(), random.sign()));
        return Ray{corner - static_cast<float>(std::exp2(std::ceil(std::log2(place.diagonal)))) * diagonal, 0.0f,
                   diagonal, infinity()};
    });
}

constexpr RayFamily kFamilies[] = {
    {"kd-planes", "inside split planes", true, true, planeRays},
    {"kd-edges", "along edges of cells", true, true, kdEdgeRays},
    {"kd-corners", "through and from corners of cells", true, true, kdCornerRays},
};

}  // namespace

std::span<const RayFamily> treeFamilies() { return kFamilies; }

}  // namespace cleave
