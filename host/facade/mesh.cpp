#include <algorithm>

#include "base/error.h"
#include "base/stopwatch.h"
#include "facade/copied.h"
#include "facade/host_builders.h"
#include "facade/states.h"
#include "run/device_builders.h"
#include "tree/tree_bytes.h"

namespace cleave::scene {
namespace {

struct Built {
    std::shared_ptr<DeviceTree> tree;
    TreeCounts counts;  // but for what the tree's header tells
};

void requireWithin(const char* setting, uint64_t value, uint64_t least, uint64_t most) {
    if (value < least || value > most)
        throw Error("build settings: " + std::string(setting) + " is " + std::to_string(value) + "; it must be from " +
                    std::to_string(least) + " to " + std::to_string(most));
}

cleave::BuildSettings settingsOf(const BuildSettings& from) {
    requireWithin("bins", from.bins, 2, kBins);
    requireWithin("exactUpTo", from.exactUpTo, 0, kMostExactUpTo);
    requireWithin("maxDepth", from.maxDepth, 0, kMaxDepth);
    for (const float cost : {from.costTraverse, from.costIntersect})
        if (!(cost >= kLeastCost && cost <= kMostCost)) throw Error("costs of the SAH are from 0.001 to 1000");
    if (!(from.costLeaf >= 0.0f && from.costLeaf <= kMostCost))
        throw Error("the SAH's cost of a leaf is from 0 to 1000");
    if (!(from.emptyBonus >= kLeastCost && from.emptyBonus <= 1.0f)) throw Error("emptyBonus is from 0.001 to 1");
    cleave::BuildSettings s;
    s.costs = {from.costTraverse, from.costIntersect, from.costLeaf, from.emptyBonus};
    s.bins = from.bins;
    s.exactUpTo = from.exactUpTo;
    s.maxDepth = from.maxDepth;
    s.clip = from.clip;
    s.subsample = from.subsample;
    s.snap = from.snap;
    s.axes = static_cast<AxisChoice>(from.axes);
    s.leafSize = from.leafSize;
    s.threads = from.threads;
    s.memory = from.memory;
    return s;
}
static_assert(static_cast<int>(Axes::widest) == static_cast<int>(AxisChoice::widest) &&
              static_cast<int>(Axes::cycle) == static_cast<int>(AxisChoice::cycle));

void requireList(std::span<const uint32_t> list, size_t triangles) {
    const bool ascends = std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
    if (!ascends || (!list.empty() && list.back() >= triangles))
        throw Error("building a tree: the list of triangles must hold ascending numbers below " +
                    std::to_string(triangles));
}

Built buildOnDevice(GpuBuilder& builder, const DeviceTriangles& triangles, const cleave::BuildSettings& settings,
                    std::span<const uint32_t> list) {
    GpuBuilder::Result result = builder.build(triangles, settings, list);
    Built built{std::move(result.tree), {}};
    built.counts.peakBytes = result.peakBytes;
    built.counts.attempts = result.attempts;
    built.counts.memoryLimited = result.memoryLimited;
    built.counts.ms = result.ms;
    return built;
}

Built buildOnHost(cleave::Device& device, std::string_view builder, std::span<const cleave::Triangle> triangles,
                  const cleave::BuildSettings& settings, std::span<const uint32_t> list) {
    const TriangleSet set = makeTriangleSet(triangles, list);
    Built built;
    const Stopwatch watch;
    const BuildOutcome outcome = hostBuilder(builder).build(set, settings);
    built.counts.peakBytes = outcome.peakBytes;
    built.counts.memoryLimited = outcome.memoryLimited;
    built.counts.ms = watch.milliseconds();
    built.tree = uploadTree(device, set, outcome.tree);
    return built;
}

TreeCounts countsOf(const Built& built, size_t triangles) {
    TreeCounts counts = built.counts;
    const TreeHeader& h = built.tree->header;
    counts.triangles = static_cast<uint32_t>(triangles);
    counts.nonFinite = h.nonFinite;
    counts.noArea = h.noArea;
    counts.nodes = h.nodeCount;
    counts.references = h.leafRefCount;
    counts.bytes = h.bytes;
    return counts;
}

}  // namespace

std::vector<std::string_view> builders() {
    std::vector<std::string_view> names;
    for (const auto& [name, description] : allBuilders()) names.push_back(name);
    return names;
}

Mesh::Mesh(Device& device, std::span<const Triangle> triangles)
    : state_(std::make_unique<State>(
          State{device.state_.get(),
                std::make_shared<const std::vector<cleave::Triangle>>(copied<cleave::Triangle>(triangles)),
                {},
                {}})) {
    if (triangles.size() > kMaxLink) throw Error("the mesh has more than 2^30 triangles; split it");
}

Mesh::~Mesh() = default;
Mesh::Mesh(Mesh&&) noexcept = default;

Tree Mesh::build(std::string_view builder, const BuildSettings& settings, std::span<const uint32_t> list) {
    State& s = *state_;
    requireList(list, s.world->size());
    const std::vector<std::string_view> known = builders();
    if (std::find(known.begin(), known.end(), builder) == known.end()) {
        std::string names;
        for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
        throw Error("no builder is named '" + std::string(builder) + "'; there is: " + names);
    }
    const bool onDevice = isOnDevice(builder);
    const cleave::BuildSettings chosen = settingsFor(builder, settingsOf(settings));
    if (onDevice && !s.onDevice) s.onDevice = std::make_unique<DeviceTriangles>(s.device->device, *s.world);
    Built built = onDevice ? buildOnDevice(s.device->builder(), *s.onDevice, chosen, list)
                           : buildOnHost(s.device->device, builder, *s.world, chosen, list);
    const TreeCounts counts = countsOf(built, list.empty() ? s.world->size() : list.size());
    Tracer* const tracer = &s.device->tracer;
    return Tree(std::unique_ptr<Tree::State>(new Tree::State{
                    tracer, &s.device->searcher, std::move(built.tree), s.world, {list.begin(), list.end()}, {}}),
                counts);
}

Tree Mesh::load(std::span<const std::byte> saved) {
    State& s = *state_;
    const Stopwatch watch;
    const TriangleSet set = makeTriangleSet(*s.world);
    Built built;
    built.tree = uploadTree(s.device->device, set, treeOfBytes(saved, *s.world, set));
    built.counts.ms = watch.milliseconds();
    const TreeCounts counts = countsOf(built, s.world->size());
    Tracer* const tracer = &s.device->tracer;
    return Tree(std::unique_ptr<Tree::State>(
                    new Tree::State{tracer, &s.device->searcher, std::move(built.tree), s.world, {}, {}}),
                counts);
}

Twin Mesh::twin(uint32_t threads) const {
    const World& world = state_->world;
    return Twin(std::unique_ptr<Twin::State>(new Twin::State{world, makeTriangleSet(*world), threads, {}}));
}

Judgement Mesh::judge(std::span<const TraceRay> rays, std::span<const TraceHit> hits, Query query, uint64_t count,
                      uint32_t threads) {
    if (hits.size() != rays.size())
        throw Error("judging: there are " + std::to_string(hits.size()) + " hits for " + std::to_string(rays.size()) +
                    " rays; give one per ray");
    State& s = *state_;
    if (!s.reference) s.reference = std::make_unique<Reference>(*s.world, makeTriangleSet(*s.world).included);
    CheckResult result = check(*s.reference, copied<Ray>(rays), copied<Hit>(hits), query, count, threads);
    return {result.rays, result.mismatches, result.undecided, result.maxRelativeTError, std::move(result.first)};
}

}  // namespace cleave::scene
