// Rays through a tree on the device.
#pragma once

#include <span>
#include <vector>

#include "device_tree.h"
#include "kdtree/oracle.h"
#include "shared/ray.h"

namespace cleave {

class Tracer {
  public:
    explicit Tracer(Context& context);
    ~Tracer();

    // What a ray did, for pictures and tables; counted only where asked for, by a kernel of its own.
    struct Steps {
        uint32_t inner = 0;      // inner nodes visited, those of restarts included
        uint32_t leaves = 0;     // leaves visited
        uint32_t triangles = 0;  // triangle tests
        uint32_t restarts = 0;
        uint32_t hitLeaf = 0;  // triangles in the leaf of the hit
    };
    struct Result {
        std::vector<Hit> hits;     // one per ray
        std::vector<Steps> steps;  // one per ray, or empty
        double ms = 0.0;           // on the device, rays and hits being there
        uint64_t invalidRays = 0;  // answered as misses (shared/ray.h, isValidRay)
        uint64_t cappedRays = 0;   // given up at the step cap: must be 0
    };
    Result trace(const DeviceTree& tree, std::span<const Ray> rays, Query query, bool countSteps = false);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave
