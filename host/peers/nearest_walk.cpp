#include "peers/nearest_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleave {
namespace {

// Ericson, Real-Time Collision Detection (2005), section 5.1.5: by the region of the triangle's plane.
double squareTo(const dvec3& p, const Triangle& t) {
    const dvec3 a(t.a), b(t.b), c(t.c);
    const dvec3 ab = b - a, ac = c - a, ap = p - a;
    const auto square = [](const dvec3& v) { return glm::dot(v, v); };
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return square(ap);
    const dvec3 bp = p - b;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return square(bp);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return square(ap - d1 / (d1 - d3) * ab);
    const dvec3 cp = p - c;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return square(cp);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return square(ap - d2 / (d2 - d6) * ac);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return square(bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
    const double scale = 1.0 / (va + vb + vc);
    return square(ap - vb * scale * ab - vc * scale * ac);
}

struct Walk {
    const KdTree& tree;
    const TriangleSet& set;
    dvec3 point;
    double best = std::numeric_limits<double>::infinity();  // squared
    uint32_t prim = kNone;

    void visit(uint32_t index) {
        const KdNode node = tree.nodes[index];
        if (isLeaf(node)) {
            for (uint32_t i = 0; i < leafCount(node); ++i) {
                const uint32_t number = tree.leafTriangles[leafFirst(node) + i];
                const double square = squareTo(point, set.triangles[number]);
                if (square > best || (square == best && number > prim)) continue;
                best = square;
                prim = number;
            }
            return;
        }
        const double beyond = point[static_cast<int>(nodeAxis(node))] - double{nodePosition(node)};
        const uint32_t near = nodeChild(node) + (beyond < 0.0 ? 0 : 1), far = nodeChild(node) + (beyond < 0.0 ? 1 : 0);
        visit(near);
        if (beyond * beyond <= best) visit(far);
    }
};

}  // namespace

std::vector<Hit> nearestWalk(const KdTree& tree, const TriangleSet& set, std::span<const vec3> points) {
    std::vector<Hit> hits;
    hits.reserve(points.size());
    for (const vec3& point : points) {
        Walk walk{tree, set, dvec3(point) * std::exp2(-set.exponent)};
        walk.visit(0);
        hits.push_back({static_cast<float>(std::sqrt(walk.best) * std::exp2(set.exponent)), walk.prim, 0.0f, 0.0f});
    }
    return hits;
}

}  // namespace cleave
