// Rays through a tree on the device.
#pragma once

#include <span>
#include <vector>

#include "device_tree.h"
#include "kdtree/oracle.h"
#include "shared/ray.h"
#include "shared/trace.h"

namespace cleave {

class Tracer {
  public:
    explicit Tracer(Context& context);
    ~Tracer();

    struct Result {
        std::vector<Hit> hits;         // one per ray
        std::vector<StepCount> steps;  // one per ray, or empty
        double ms = 0.0;               // on the device, rays and hits being there
        uint64_t invalidRays = 0;      // answered as misses (shared/ray.h, isValidRay)
        uint64_t cappedRays = 0;       // given up at the step cap: must be 0
    };
    Result trace(const DeviceTree& tree, std::span<const Ray> rays, Query query, bool countSteps = false);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave
