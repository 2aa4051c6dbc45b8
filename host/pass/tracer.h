// Rays through a tree on the device.
#pragma once

#include <span>
#include <vector>

#include "pass/device_tree.h"
#include "shared/ray.h"
#include "shared/trace.h"
#include "tree/query.h"

namespace cleave {

// Without a stack, or with one to compare with.
enum class Traversal { restart, stack };
// kWatertightTest, kPlainTest, kUnfilteredTest of shared/trace.h.
enum class TriangleTest : uint32_t { watertight, plain, unfiltered };

struct TraceMode {
    Traversal traversal = Traversal::restart;
    TriangleTest test = TriangleTest::watertight;
    bool countSteps = false;  // by variants of the kernels, so that others do not pay for it
};

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
    Result trace(const DeviceTree& tree, std::span<const Ray> rays, Query query, const TraceMode& mode = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave
