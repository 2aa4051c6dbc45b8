#include "peers/stack_walk.h"

#include <algorithm>
#include <array>

#include "base/stopwatch.h"
#include "peers/for_each_ray.h"

namespace cleave {
namespace {

// Intervals are widened by more than the rounding errors of a plane's t, so that no cell that the ray meets is skipped.
constexpr float kWiden = 0x1p-20f;
constexpr float kLargeT = 3.0e38f;

// A node, and the part of the ray that may lie in its cell.
struct Visit {
    uint32_t node;
    float tMin;
    float tMax;
};

struct Tree {
    const KdNode* nodes;
    const uint32_t* numbers;    // leaf by leaf
    const Triangle* triangles;  // in the same order
    Box bounds;
};

// A ray as the walk reads it: arrays, since the axis is known only at each node.
struct WalkRay {
    explicit WalkRay(const ScaledRay& ray) : scaled(ray) {
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = ray.origin[axis];
            direction[axis] = ray.direction[axis];
            inverse[axis] = 1.0f / ray.direction[axis];  // not used where the direction is 0
        }
    }
    const ScaledRay& scaled;
    float origin[3];
    float direction[3];
    float inverse[3];
};

float clampedT(float t) { return std::clamp(t, -kLargeT, kLargeT); }

// Clips the ray to the root cell, widened; false if nothing is left.
bool enterRoot(const WalkRay& ray, const Box& box, Visit& root) {
    root = {0, ray.scaled.tMin, ray.scaled.tMax};
    for (int axis = 0; axis < 3; ++axis) {
        const float o = ray.origin[axis];
        if (ray.direction[axis] == 0.0f) {
            if (o < box.lo[axis] || o > box.hi[axis]) return false;
            continue;
        }
        const float a = clampedT((box.lo[axis] - o) * ray.inverse[axis]);
        const float b = clampedT((box.hi[axis] - o) * ray.inverse[axis]);
        const float enter = std::min(a, b), leave = std::max(a, b);
        root.tMin = std::max(root.tMin, enter - std::fabs(enter) * kWiden);
        root.tMax = std::min(root.tMax, leave + std::fabs(leave) * kWiden);
    }
    return root.tMin <= root.tMax;
}

// Moves `at` to the child that comes first; true if the other one has to wait, as `later`.
bool descend(KdNode node, const WalkRay& ray, Visit& at, Visit& later) {
    const uint32_t axis = nodeAxis(node), left = nodeChild(node);
    const float toPlane = nodePosition(node) - ray.origin[axis];
    if (ray.direction[axis] == 0.0f) {  // parallel to the plane: one child, or both where the ray lies in the plane
        at.node = left + (toPlane >= 0.0f ? 0 : 1);
        later = {left + 1, at.tMin, at.tMax};
        return toPlane == 0.0f;
    }
    const uint32_t nearSide = ray.direction[axis] < 0.0f ? 1 : 0;
    const float t = clampedT(toPlane * ray.inverse[axis]);
    const float slack = std::fabs(t) * kWiden;
    if (t + slack < at.tMin) {
        at.node = left + 1 - nearSide;
        return false;
    }
    at.node = left + nearSide;
    if (at.tMax < t - slack) return false;
    later = {left + 1 - nearSide, std::max(at.tMin, t - slack), at.tMax};
    at.tMax = std::min(at.tMax, t + slack);
    return true;
}

// Tests the triangles of a leaf; true if the best hit is now from this leaf.
bool testLeaf(const Tree& tree, const ScaledRay& ray, KdNode leaf, bool anyHit, Hit& best) {
    bool found = false;
    const uint32_t end = leafFirst(leaf) + leafCount(leaf);
    for (uint32_t i = leafFirst(leaf); i < end; ++i) {
        Hit hit = intersectTriangle(ray.origin, ray.direction, tree.triangles[i]);
        if (!(hit.t >= ray.tMin && hit.t <= ray.tMax && hit.t <= best.t) || !isFinite(hit.t)) continue;
        hit.prim = tree.numbers[i];
        if (!isCloser(hit, best)) continue;
        best = hit;
        found = true;
        if (anyHit) break;
    }
    return found;
}

template <bool anyHit>
Hit walk(const Tree& tree, const ScaledRay& scaled) {
    const WalkRay ray(scaled);
    std::array<Visit, kMaxDepth> waiting;  // at most one per inner node of a path
    size_t count = 0;
    Hit best = missedHit();
    Visit at;
    if (!enterRoot(ray, tree.bounds, at)) return best;
    while (true) {
        KdNode node = tree.nodes[at.node];
        while (!isLeaf(node)) {
            if (descend(node, ray, at, waiting[count])) ++count;
            node = tree.nodes[at.node];
        }
        if (testLeaf(tree, scaled, node, anyHit, best) && anyHit) return best;
        // Ties go to the lower number, so a cell that begins at the best t must still be visited.
        while (count > 0 && waiting[count - 1].tMin > best.t) --count;
        if (count == 0) return best;
        at = waiting[--count];
    }
}

class StackWalk : public Peer {
  public:
    explicit StackWalk(const PeerScene& scene) : scene_(scene) {}

    double build() override {
        const Stopwatch watch;
        inLeaves_.clear();
        inLeaves_.reserve(scene_.tree.leafTriangles.size());
        for (const uint32_t number : scene_.tree.leafTriangles) inLeaves_.push_back(scene_.set.triangles[number]);
        return scene_.treeMs + watch.milliseconds();
    }

    Traced trace(std::span<const Ray> rays, Query query) override {
        const Tree tree{scene_.tree.nodes.data(), scene_.tree.leafTriangles.data(), inLeaves_.data(),
                        scene_.tree.bounds};
        Traced traced;
        traced.hits.resize(rays.size());
        const Stopwatch watch;
        forEachRay(rays.size(), scene_.threads, [&](size_t i) {
            traced.hits[i] = missedHit();
            if (!isValidRay(rays[i])) return;
            const ScaledRay ray = scaledRay(rays[i], scene_.set.exponent);
            const Hit hit = query == Query::any ? walk<true>(tree, ray) : walk<false>(tree, ray);
            traced.hits[i] = worldHit(hit, ray.tExponent);
        });
        traced.ms = watch.milliseconds();
        return traced;
    }

  private:
    PeerScene scene_;
    std::vector<Triangle> inLeaves_;
};

}  // namespace

std::unique_ptr<Peer> makeStackWalk(const PeerScene& scene) { return std::make_unique<StackWalk>(scene); }

}  // namespace cleave
