// The reference's own tree: a bounding volume hierarchy over world-space triangles, split at medians, with a slab test
// that never misses. It shares nothing with kd-trees.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/box.h"
#include "shared/ray.h"
#include "shared/triangle.h"

namespace cleave {

class ReferenceBvh {
  public:
    ReferenceBvh(std::span<const Triangle> world, std::span<const uint32_t> included);

    // Calls visit(prim) for every triangle whose box the ray's line may meet at t <= limit(); the limit may shrink.
    template <class Limit, class Visit>
    void traverse(const Ray& ray, Limit limit, Visit visit) const {
        if (nodes_.empty()) return;
        uint32_t stack[64];
        int size = 0;
        stack[size++] = 0;
        while (size > 0) {
            const Node& node = nodes_[stack[--size]];
            if (!mayMeet(node.box, ray, limit())) continue;
            if (node.count == 0) {
                // The child on the ray's side last, so that it is visited first.
                const bool leftFirst = ray.direction[static_cast<int>(node.axis)] >= 0.0f;
                stack[size++] = leftFirst ? node.first + 1 : node.first;
                stack[size++] = leftFirst ? node.first : node.first + 1;
            }
            for (uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
        }
    }

  private:
    struct Node {
        Box box;
        uint32_t first;  // the left child, the right one beside it; or where the leaf begins in order_
        uint32_t count;  // 0: inner
        uint32_t axis;
    };

    void build(uint32_t index, std::span<const Triangle> world, uint32_t begin, uint32_t end);

    // A quotient of double with one rounded difference is off by 2^-52 of itself: 2^-50 is safe.
    static bool mayMeet(const Box& box, const Ray& ray, double limit) {
        constexpr double kError = 0x1p-50;
        double tNear = -std::numeric_limits<double>::infinity(), tFar = limit;
        for (int axis = 0; axis < 3; ++axis) {
            const double o = ray.origin[axis], d = ray.direction[axis];
            if (d == 0.0) {
                if (o < box.lo[axis] || o > box.hi[axis]) return false;
                continue;
            }
            const double t0 = (box.lo[axis] - o) / d, t1 = (box.hi[axis] - o) / d;
            const double lower = std::min(t0, t1), upper = std::max(t0, t1);
            tNear = std::max(tNear, lower - std::fabs(lower) * kError);
            tFar = std::min(tFar, upper + std::fabs(upper) * kError);
        }
        return tNear <= tFar;
    }

    std::vector<Node> nodes_;
    std::vector<uint32_t> order_;
};

}  // namespace cleave
