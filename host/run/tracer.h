// Traces rays of the host through a tree on the device.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "run/device_instances.h"
#include "run/device_tree.h"
#include "shared/ray.h"
#include "shared/step_count.h"

namespace cleave {

// How much a query does at once. Tests make these tiny; the answers are the same.
struct TraceLimits {
    size_t batch = size_t(1) << 21;  // rays of one submission: bounds the memory of large queries
    uint32_t stepLimit = 0;          // of one dispatch, as TraceInfo::stepLimit
    // Dispatches after which a ray is given up: with the default limit far more than any valid tree needs.
    uint32_t mostDispatches = 1024;
    bool keepsTrails = false;  // also of rays that no dispatch gives up on
};

// The fastest where it was measured: on a CPU (lavapipe) and on an NVIDIA H200 (docs/speed.md, docs/nvidia.md).
inline constexpr Traversal kDefaultTraversal = Traversal::stack;

class Tracer {
  public:
    explicit Tracer(Device& device, TraceLimits limits = {});
    ~Tracer();

    struct Result {
        std::vector<Hit> hits;         // one per ray
        std::vector<StepCount> steps;  // one per ray, or empty
        double ms = 0.0;               // on the device, rays and hits being there
        uint64_t invalidRays = 0;      // answered as misses (shared/ray.h, isValidRay)
        uint64_t cappedRays = 0;       // given up, answered as misses: must be 0
    };
    // `from`: hits of another tree to go on from, one per ray; empty: none. Of a lazy tree what the rays reach is
    // built.
    Result trace(const Forest& forest, std::span<const Ray> rays, const TraceMode& mode = {},
                 std::span<const Hit> from = {});
    // Through meshes in places; whatever the mode says of that.
    Result trace(const DeviceInstances& instances, std::span<const Ray> rays, TraceMode mode = {});

    // The first `hitsPerRay` crossings of each ray, in rows of as many whose rest are misses: by t and then by number,
    // an edge or a vertex of a closed surface once (docs/queries.md).
    Result all(const DeviceTree& tree, std::span<const Ray> rays, uint32_t hitsPerRay);
    struct Counts {
        std::vector<int32_t> counts;  // one per ray
        double ms = 0.0;
        uint64_t invalidRays = 0;  // answered by 0
    };
    // How often each ray crosses triangles; or, signed, how often more it leaves through the back of a triangle than it
    // enters through its front.
    Counts count(const DeviceTree& tree, std::span<const Ray> rays, bool isSigned = false);

    // Traces the same rays `runs` times, after a warm-up (base/warm_up.h), with rays and hits staying on the device:
    // the milliseconds that each took there.
    std::vector<double> time(const DeviceTree& tree, std::span<const Ray> rays, const TraceMode& mode, uint32_t runs);
    std::vector<double> time(const DeviceInstances& instances, std::span<const Ray> rays, TraceMode mode,
                             uint32_t runs);

    // The context that traces in a mode, made when it is first asked for. CPU devices compile at the first dispatch:
    // one without rays is run, so that a query's time is the query's.
    const Context& context(const TraceMode& mode);
    // What making contexts has taken so far.
    double setupMilliseconds() const;

  private:
    Result traceFrom(std::span<const uint64_t> trees, int exponent, std::span<const Ray> rays, const TraceMode& mode,
                     std::span<const Hit> from, LazyTree* lazy = nullptr);
    std::vector<double> timeFrom(uint64_t address, std::span<const Ray> rays, const TraceMode& mode, uint32_t runs);

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cleave
