// What a user would pick instead of cleave: something else that answers rays in the same scene.
#pragma once

#include <span>
#include <vector>

#include "cleave/modes.hpp"
#include "shared/ray.h"
#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

// What peers are built over. All of it outlives them.
struct PeerScene {
    std::span<const Triangle> world;  // by number
    const TriangleSet& set;           // the same, scaled; peers are given those of them that are in our trees
    const KdTree& tree;               // of the stack walk
    double treeMs = 0.0;              // what building it took
    uint32_t threads = 2;             // of peers on the CPU
};

class Peer {
  public:
    Peer() = default;
    virtual ~Peer() = default;
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    // Makes what rays need, anew at each call: the milliseconds that took.
    virtual double build() = 0;

    struct Traced {
        // One per ray. `prim` is the scene's number of the triangle; of an any-hit query it says hit or miss only.
        std::vector<Hit> hits;
        double ms = 0.0;
    };
    // After build(). Rays that are not valid are answered as misses.
    virtual Traced trace(std::span<const Ray> rays, Query query) = 0;
    // The milliseconds of each of `runs` more traces of the same rays.
    virtual std::vector<double> time(std::span<const Ray> rays, Query query, uint32_t runs) {
        std::vector<double> ms;
        for (uint32_t i = 0; i < runs; ++i) ms.push_back(trace(rays, query).ms);
        return ms;
    }
};

}  // namespace cleave
