#include "run/tracer.h"

#include <algorithm>

#include "base/warm_up.h"
#include "core/trace_push.h"
#include "gpu/commands.h"
#include "run/context_of.h"
#include "run/lazy_tree.h"
#include "shared/trace.h"

namespace cleave {
namespace {

constexpr size_t kHitsOfBatch = 8;  // per ray, before a batch has fewer rays

struct Traced {
    TraceMode mode;
    std::unique_ptr<Context> context;
};

}  // namespace

struct Tracer::State {
    State(Device& d, const TraceLimits& l) : device(d), limits(l), commands(d), counters(d, sizeof(TraceCounters)) {}

    Device& device;
    TraceLimits limits;
    Commands commands;
    Buffer counters;
    Buffer rays, hits, steps, trails;  // kept from call to call
    std::vector<Traced> contexts;
    double setupMs = 0.0;

    void reserve(Buffer& buffer, size_t bytes) {
        if (buffer.size() >= bytes) return;
        buffer = Buffer();
        buffer = Buffer(device, bytes);
    }

    std::span<const Ray> batchAt(std::span<const Ray> all, size_t first) const {
        return all.subspan(first, std::min(limits.batch, all.size() - first));
    }

    // Rays of a batch that has so many hits of each: its memory is bounded.
    size_t batchOf(uint32_t hitsPerRay) const {
        const size_t most = limits.batch * kHitsOfBatch / std::max(hitsPerRay, 1u);
        return std::max<size_t>(std::min(limits.batch, most), 1);
    }

    // Puts a batch of rays on the device, with what their query needs beside them.
    TraceInfo placed(uint64_t tree, std::span<const Ray> batch, const TraceMode& mode, uint32_t hitsPerRay = 1) {
        reserve(rays, batch.size_bytes());
        reserve(hits, batch.size() * hitsPerRay * sizeof(Hit));
        const bool goesOn = (limits.keepsTrails && !mode.instances) || mayGoOn(mode);
        if (goesOn) reserve(trails, batch.size() * sizeof(Trail));
        if (mode.countSteps) reserve(steps, batch.size() * sizeof(StepCount));
        rays.upload(batch);
        TraceInfo info;
        info.tree = tree;
        info.rays = rays.address();
        info.hits = hits.address();
        if (goesOn) info.trails = trails.address();
        info.count = static_cast<uint32_t>(batch.size());
        info.hitsPerRay = hitsPerRay;
        info.mode = mode;
        info.counters = counters.address();
        if (mode.countSteps) info.steps = steps.address();
        info.stepLimit = limits.stepLimit;
        return info;
    }

    // Runs one dispatch; what it counted.
    TraceCounters run(const Context& context, const TraceInfo& info, double& ms) {
        commands.begin();
        commands.fillZero(counters.handle());
        cmdTrace(commands.handle(), context, info);
        commands.run();
        ms += commands.milliseconds();
        return counters.download<TraceCounters>(1)[0];
    }

    // `lazy`: the tree is this one, or null.
    void trace(const Context& context, TraceInfo info, LazyTree* lazy, Result& result) {
        if (lazy) info.open = lazy->open();
        TraceCounters counted = run(context, info, result.ms);
        result.invalidRays += counted.invalidRays;
        info.resumes = true;
        if (info.hitScale == HitScale::last) info.hitScale = HitScale::world;
        for (uint32_t i = 1; counted.unfinishedRays > 0 && i < limits.mostDispatches; i++) {
            if (lazy && lazy->expandMarked()) info.tree = lazy->address();
            counted = run(context, info, result.ms);
        }
        result.cappedRays += counted.unfinishedRays;
    }
};

Tracer::Tracer(Device& device, TraceLimits limits) : state_(std::make_unique<State>(device, limits)) {}
Tracer::~Tracer() = default;

const Context& Tracer::context(const TraceMode& mode) {
    State& s = *state_;
    const auto known =
        std::find_if(s.contexts.begin(), s.contexts.end(), [&](const Traced& t) { return t.mode == mode; });
    if (known != s.contexts.end()) return *known->context;
    const Stopwatch watch;
    s.contexts.push_back({mode, contextOf(s.device, {&mode, 1}, Building{})});
    TraceInfo nothing;
    nothing.mode = mode;
    s.commands.begin();
    cmdTrace(s.commands.handle(), *s.contexts.back().context, nothing);
    s.commands.run();
    s.setupMs += watch.milliseconds();
    return *s.contexts.back().context;
}

double Tracer::setupMilliseconds() const { return state_->setupMs; }

Tracer::Result Tracer::trace(const Forest& forest, std::span<const Ray> rays, const TraceMode& mode,
                             std::span<const Hit> from) {
    std::vector<uint64_t> addresses;
    for (const DeviceTree* tree : forest.trees) addresses.push_back(tree->address());
    TraceMode suited = mode;
    suited.lazy = forest.lazy != nullptr;
    suited.single = forest.isSingle() && from.empty() && mayBeSingle(mode);
    return traceFrom(addresses, forest.exponent(), rays, suited, from, forest.lazy);
}

Tracer::Result Tracer::trace(const DeviceInstances& instances, std::span<const Ray> rays, TraceMode mode) {
    mode.instances = true;
    const uint64_t address = instances.address();
    return traceFrom({&address, 1}, 0, rays, mode, {});
}

Tracer::Result Tracer::traceFrom(std::span<const uint64_t> trees, int exponent, std::span<const Ray> rays,
                                 const TraceMode& mode, std::span<const Hit> from, LazyTree* lazy) {
    State& s = *state_;
    const Context& traced = context(mode);
    Result result;
    result.hits.resize(rays.size());
    if (mode.countSteps) result.steps.resize(rays.size());
    for (size_t first = 0; first < rays.size(); first += s.limits.batch) {
        const std::span<const Ray> batch = s.batchAt(rays, first);
        TraceInfo info = s.placed(trees.front(), batch, mode);
        if (!from.empty()) s.hits.upload(from.subspan(first, batch.size()));
        info.fromHits = !from.empty();
        if (info.fromHits && mode.countSteps)
            s.steps.upload(std::span<const StepCount>(result.steps).subspan(first, batch.size()));
        info.hitExponent = exponent;
        for (size_t tree = 0; tree < trees.size(); tree++) {
            info.tree = lazy ? lazy->address() : trees[tree];
            if (trees.size() > 1 && from.empty())
                info.hitScale = tree + 1 < trees.size() ? HitScale::between : HitScale::last;
            s.trace(traced, info, lazy, result);
            info.fromHits = true;
        }
        s.hits.read(0, &result.hits[first], batch.size() * sizeof(Hit));
        if (mode.countSteps) s.steps.read(0, &result.steps[first], batch.size() * sizeof(StepCount));
    }
    return result;
}

Tracer::Result Tracer::all(const DeviceTree& tree, std::span<const Ray> rays, uint32_t hitsPerRay) {
    State& s = *state_;
    const Context& traced = context({Query::all});
    Result result;
    result.hits.resize(rays.size() * hitsPerRay);
    const size_t batch = s.batchOf(hitsPerRay);
    for (size_t first = 0; first < rays.size(); first += batch) {
        const std::span<const Ray> some = rays.subspan(first, std::min(batch, rays.size() - first));
        const TraceInfo info = s.placed(tree.address(), some, {Query::all}, hitsPerRay);
        result.invalidRays += s.run(traced, info, result.ms).invalidRays;
        s.hits.read(0, &result.hits[first * hitsPerRay], some.size() * hitsPerRay * sizeof(Hit));
    }
    return result;
}

Tracer::Counts Tracer::count(const DeviceTree& tree, std::span<const Ray> rays, bool isSigned) {
    State& s = *state_;
    const TraceMode mode{isSigned ? Query::signedCount : Query::count};
    const Context& traced = context(mode);
    Counts result;
    result.counts.resize(rays.size());
    for (size_t first = 0; first < rays.size(); first += s.limits.batch) {
        const std::span<const Ray> batch = s.batchAt(rays, first);
        const TraceInfo info = s.placed(tree.address(), batch, mode);
        result.invalidRays += s.run(traced, info, result.ms).invalidRays;
        s.hits.read(0, &result.counts[first], batch.size() * sizeof(int32_t));
    }
    return result;
}

std::vector<double> Tracer::time(const DeviceTree& tree, std::span<const Ray> rays, const TraceMode& mode,
                                 uint32_t runs) {
    return timeFrom(tree.address(), rays, mode, runs);
}

std::vector<double> Tracer::time(const DeviceInstances& instances, std::span<const Ray> rays, TraceMode mode,
                                 uint32_t runs) {
    mode.instances = true;
    return timeFrom(instances.address(), rays, mode, runs);
}

std::vector<double> Tracer::timeFrom(uint64_t address, std::span<const Ray> rays, const TraceMode& mode,
                                     uint32_t runs) {
    State& s = *state_;
    const Context& traced = context(mode);
    std::vector<double> ms(runs, 0.0);
    for (size_t first = 0; first < rays.size(); first += s.limits.batch) {
        const TraceInfo info = s.placed(address, s.batchAt(rays, first), mode);
        const auto once = [&] {
            Result result;
            s.trace(traced, info, nullptr, result);
            return result.ms;
        };
        warmUp(once);
        for (double& sum : ms) sum += once();
    }
    return ms;
}

}  // namespace cleave
