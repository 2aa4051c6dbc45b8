// The oracles that share the triangle function with the GPU: they judge trees and traversals.
#include <algorithm>
#include <cmath>

#include "judge/oracle.h"

namespace cleave {
namespace {

// Keeps the closest hit in the ray's interval. A t beyond the range of float is no hit.
void test(const TriangleSet& set, uint32_t prim, const ScaledRay& ray, Hit& best) {
    Hit h = intersectTriangle(ray.origin, ray.direction, set.triangles[prim]);
    h.prim = prim;
    if (isFinite(h.t) && h.t >= ray.tMin && h.t <= ray.tMax && isCloser(h, best)) best = h;
}

// Visits every leaf whose cell, widened by `margin`, meets the ray within its interval, near children first. There is
// no culling by the best hit: then no error of t can hide a closer one, and the answer is that of brute force.
struct Walk {
    const KdTree& tree;
    const TriangleSet& set;
    ScaledRay ray;
    Query query;
    double margin;
    Hit best = missedHit();

    bool isDone() const { return query == Query::any && best.prim != kNone; }

    void visitLeaf(KdNode node) {
        for (uint32_t i = 0; i < leafCount(node) && !isDone(); ++i)
            test(set, tree.leafTriangles[leafFirst(node) + i], ray, best);
    }

    void visit(uint32_t index, double tMin, double tMax) {
        if (tMin > tMax || isDone()) return;
        const KdNode node = tree.nodes[index];
        if (isLeaf(node)) return visitLeaf(node);
        const int axis = static_cast<int>(nodeAxis(node));
        const double o = ray.origin[axis], d = ray.direction[axis], plane = nodePosition(node);
        const uint32_t left = nodeChild(node), right = left + 1;
        // The ray is left of the plane where o + t d <= plane + margin, right where o + t d >= plane - margin.
        const double tLeft = (plane + margin - o) / d, tRight = (plane - margin - o) / d;
        if (d > 0.0) {
            visit(left, tMin, std::min(tMax, tLeft));
            visit(right, std::max(tMin, tRight), tMax);
        } else if (d < 0.0) {
            visit(right, tMin, std::min(tMax, tRight));
            visit(left, std::max(tMin, tLeft), tMax);
        } else {
            if (o <= plane + margin) visit(left, tMin, tMax);
            if (o >= plane - margin) visit(right, tMin, tMax);
        }
    }
};

}  // namespace

Hit bruteForce(const TriangleSet& set, const Ray& ray, Query query) {
    if (!isValidRay(ray)) return missedHit();
    const ScaledRay scaled = scaledRay(ray, set.exponent);
    Hit best = missedHit();
    for (const uint32_t prim : set.included) {
        test(set, prim, scaled, best);
        if (query == Query::any && best.prim != kNone) break;
    }
    return worldHit(best, scaled.tExponent);
}

Hit stackWalk(const KdTree& tree, const TriangleSet& set, const Ray& ray, Query query) {
    if (!isValidRay(ray)) return missedHit();
    const ScaledRay scaled = scaledRay(ray, set.exponent);
    // The triangle test decides in double for differences of about `reach`, so it may hit a triangle that the ray
    // passes at some 2^-50 reach^2 / edge. 2^-30 reach^2 is far more for every edge above 1e-6 of the scene.
    const double reach = std::max(1.0f, largestComponent(scaled.origin));
    const double margin = 0x1p-30 * reach * reach;
    Walk walk{tree, set, scaled, query, margin};
    // t is rounded to float; the largest direction component is at least 1, so `margin` bounds t's shift, too.
    constexpr double kSlack = 0x1p-20;
    walk.visit(0, scaled.tMin * (1.0 - kSlack) - margin, scaled.tMax * (1.0 + kSlack) + margin);
    return worldHit(walk.best, scaled.tExponent);
}

}  // namespace cleave
