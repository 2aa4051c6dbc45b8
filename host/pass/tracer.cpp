#include "pass/tracer.h"

#include <algorithm>
#include <map>

#include "base/stopwatch.h"
#include "gpu/recorder.h"
#include "pass/device_arrays.h"
#include "shared/dispatch.h"

namespace cleave {

namespace {
// Rays of one submission: bounds the memory of large queries, and the time of one dispatch.
constexpr size_t kBatch = size_t(1) << 21;
}  // namespace

struct Tracer::Impl {
    explicit Impl(Context& c) : context(c), counters(c, sizeof(TraceCounters)) {}

    Context& context;
    Buffer counters;
    Buffer rays, hits, steps;  // kept from call to call
    std::map<std::vector<uint32_t>, std::unique_ptr<Kernel>> kernels;

    // Made when it is first asked for. CPU devices compile at the first dispatch: one without rays, so that a query's
    // time is the query's.
    const Kernel& kernel(Query query, const TraceMode& mode) {
        const bool stack = mode.traversal == Traversal::stack;
        const std::vector<uint32_t> constants{query == Query::any ? 1u : 0u, mode.countSteps ? 1u : 0u,
                                              static_cast<uint32_t>(mode.test)};
        std::vector<uint32_t> key = constants;
        key.push_back(stack ? 1 : 0);
        std::unique_ptr<Kernel>& kept = kernels[key];
        if (!kept) {
            kept = std::make_unique<Kernel>(context, stack ? "trace_stack" : "trace", sizeof(TracePush), constants);
            warmUp(*kept);
        }
        return *kept;
    }

    void warmUp(const Kernel& kernel) {
        const Stopwatch watch;
        Recorder recorder(context);
        recorder.dispatch(kernel, TracePush{}, 1);
        recorder.submit();
        context.setupMs += watch.milliseconds();
    }

    void reserve(Buffer& buffer, size_t bytes) {
        if (buffer.size() >= bytes) return;
        buffer = Buffer();
        buffer = Buffer(context, bytes);
    }
};

Tracer::Tracer(Context& context) : impl_(std::make_unique<Impl>(context)) {}
Tracer::~Tracer() = default;

Tracer::Result Tracer::trace(const DeviceTree& tree, std::span<const Ray> rays, Query query, const TraceMode& mode) {
    Impl& d = *impl_;
    const Kernel& kernel = d.kernel(query, mode);
    Result result;
    result.hits.resize(rays.size());
    if (mode.countSteps) result.steps.resize(rays.size());
    for (size_t first = 0; first < rays.size(); first += kBatch) {
        const std::span<const Ray> batch = rays.subspan(first, std::min(kBatch, rays.size() - first));
        d.reserve(d.rays, batch.size_bytes());
        d.reserve(d.hits, batch.size() * sizeof(Hit));
        if (mode.countSteps) d.reserve(d.steps, batch.size() * sizeof(StepCount));
        d.rays.upload(batch);
        const TracePush push{d.rays.address(),
                             d.hits.address(),
                             mode.countSteps ? d.steps.address() : 0,
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
        if (mode.countSteps) d.steps.read(0, &result.steps[first], batch.size() * sizeof(StepCount));
        const TraceCounters counted = d.counters.download<TraceCounters>(1)[0];
        result.invalidRays += counted.invalidRays;
        result.cappedRays += counted.cappedRays;
    }
    return result;
}

}  // namespace cleave
