#include "tracer.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "device_arrays.h"
#include "gpu/recorder.h"
#include "shared/dispatch.h"

namespace cleave {

namespace {
// Rays of one submission: bounds the memory of large queries, and the time of one dispatch.
constexpr size_t kBatch = size_t(1) << 21;
}  // namespace

struct Tracer::Impl {
    explicit Impl(Context& c)
        : context(c),
          closest(c, "trace", sizeof(TracePush), {0, 0}),
          any(c, "trace", sizeof(TracePush), {1, 0}),
          closestCounted(c, "trace", sizeof(TracePush), {0, 1}),
          anyCounted(c, "trace", sizeof(TracePush), {1, 1}),
          counters(c, sizeof(TraceCounters)) {}

    Context& context;
    Kernel closest, any, closestCounted, anyCounted;
    Buffer counters;
    Buffer rays, hits, steps;  // kept from call to call

    std::set<const Kernel*> compiled;

    // CPU devices compile at the first dispatch: one without rays, so that a query's time is the query's.
    void warmUp(const Kernel& kernel) {
        if (!compiled.insert(&kernel).second) return;
        const auto start = std::chrono::steady_clock::now();
        Recorder recorder(context);
        recorder.dispatch(kernel, TracePush{}, 1);
        recorder.submit();
        context.setupMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }

    void reserve(Buffer& buffer, size_t bytes) {
        if (buffer.size() >= bytes) return;
        buffer = Buffer();
        buffer = Buffer(context, bytes);
    }
};

Tracer::Tracer(Context& context) : impl_(std::make_unique<Impl>(context)) {}
Tracer::~Tracer() = default;

Tracer::Result Tracer::trace(const DeviceTree& tree, std::span<const Ray> rays, Query query, bool countSteps) {
    Impl& d = *impl_;
    const Kernel& kernel =
        query == Query::any ? (countSteps ? d.anyCounted : d.any) : (countSteps ? d.closestCounted : d.closest);
    d.warmUp(kernel);
    Result result;
    result.hits.resize(rays.size());
    if (countSteps) result.steps.resize(rays.size());
    for (size_t first = 0; first < rays.size(); first += kBatch) {
        const std::span<const Ray> batch = rays.subspan(first, std::min(kBatch, rays.size() - first));
        d.reserve(d.rays, batch.size_bytes());
        d.reserve(d.hits, batch.size() * sizeof(Hit));
        if (countSteps) d.reserve(d.steps, batch.size() * sizeof(StepCount));
        d.rays.upload(batch);
        const TracePush push{d.rays.address(),
                             d.hits.address(),
                             countSteps ? d.steps.address() : 0,
                             d.counters.address(),
                             tree.nodes.address(),
                             tree.leafTriangles.address(),
                             tree.triangles->triangles.address(),
                             tree.bounds,
                             tree.exponent,
                             static_cast<uint32_t>(batch.size())};
        Recorder recorder(d.context);
        recorder.fillZero(d.counters);
        recorder.dispatch(kernel, push, ceilDiv(push.rayCount, kGroup));
        result.ms += recorder.submit();
        d.hits.read(0, &result.hits[first], batch.size() * sizeof(Hit));
        if (countSteps) d.steps.read(0, &result.steps[first], batch.size() * sizeof(StepCount));
        const TraceCounters counted = d.counters.download<TraceCounters>(1)[0];
        result.invalidRays += counted.invalidRays;
        result.cappedRays += counted.cappedRays;
    }
    return result;
}

}  // namespace cleave
