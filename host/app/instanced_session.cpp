#include "app/instanced_session.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "facade/host_builders.h"
#include "run/device_builders.h"

namespace cleave {
namespace {

// A ray pays for each place that it comes by, so that instances are chosen where at least half of a scene would be
// copies, and enough of them to matter: the trees of these are some 10 MB.
constexpr size_t kFewestCopies = size_t(1) << 16;
// Nor is it worth it to go into the space of a mesh for less.
constexpr size_t kFewestTriangles = 64;

void add(TreeStatistics& sum, const TreeStatistics& s) {
    sum.nodes += s.nodes;
    sum.leaves += s.leaves;
    sum.emptyLeaves += s.emptyLeaves;
    sum.references += s.references;
    sum.maxDepth = std::max(sum.maxDepth, s.maxDepth);
    sum.largestLeaf = std::max(sum.largestLeaf, s.largestLeaf);
    sum.leafHistogram.resize(std::max(sum.leafHistogram.size(), s.leafHistogram.size()));
    for (size_t i = 0; i < s.leafHistogram.size(); ++i) sum.leafHistogram[i] += s.leafHistogram[i];
    sum.costs = s.costs;
}

}  // namespace

std::optional<Sharing> sharingFor(const Run& run, const Scene& scene) {
    const Choice choice = run.options.instances;
    if (choice == Choice::off) return std::nullopt;
    if (choice == Choice::on) {
        Sharing all = sharingOf(scene, 1);
        if (all.copies == 0)
            throw Error("--instances on: no mesh of '" + scene.name +
                        "' that keeps its shape stands in two places; leave it out");
        return all;
    }
    if (needForCopies(run.options)) return std::nullopt;
    Sharing large = sharingOf(scene, kFewestTriangles);
    if (large.copies < kFewestCopies || 2 * large.copies < large.triangles) return std::nullopt;
    return large;
}

InstancedSession::InstancedSession(Run& run, ReadScene loaded, const Sharing& sharing)
    : run_(run), needs_(run.options.keep), scene_(std::move(loaded.scene)), loadMs_(loaded.ms) {
    warnOnce(scene_.warnings);
    const std::vector<uint32_t> animations = chosenAnimations(run, scene_);
    if (run.options.time) time_ = {*run.options.time, animations};
    run_.progress.phase("posing");
    const Stopwatch watch;
    const auto placedAt = [&](const PoseTime& time) {
        SharedPose shared = poseShared(scene_, time, sharing);
        Instances placed = instancesOf(shared);
        posed_ = std::move(shared.posed);
        return placed;
    };
    if (run.options.command == Command::render && run.options.time) restBounds_ = placedAt({}).bounds;
    instances_ = placedAt(time_);
    if (!run.options.time) restBounds_ = instances_.bounds;
    poseMs_ = watch.milliseconds();
    warnOnce(posed_.warnings);
    if (const auto warning = nonFiniteWarning(instances_.rest, instances_.restNumbers)) warnOnce({*warning});
    findInScene(needs_, scene_, instances_.bounds, run.options.time && !animations.empty());
    run_.progress.clear();
}

void InstancedSession::warnOnce(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        if (warned_.insert(warning).second) run_.warn(warning);
}

BuiltTree InstancedSession::buildOne(Builder builder, const std::vector<Triangle>& triangles,
                                     std::span<const uint32_t> numbers) {
    const BuildSettings settings = settingsFor(builder.name, run_.options.settings);
    Device& device = run_.device.device();
    BuiltTree built;
    if (isOnDevice(builder.name)) {
        const DeviceTriangles onDevice(device, triangles);
        GpuBuilder& gpu = run_.device.builder();
        GpuBuilder::Result result =
            numbers.empty() ? gpu.build(onDevice, settings) : gpu.buildNumbered(onDevice, settings, numbers);
        built.onDevice = std::move(result.tree);
        built.tree = readBack(*built.onDevice);
        built.ms = result.ms;
        built.peakBytes = result.peakBytes;
        built.memoryLimited = result.memoryLimited;
        built.attempts = result.attempts;
    } else {
        const TriangleSet set = makeTriangleSet(triangles);
        const Stopwatch watch;
        BuildOutcome outcome = hostBuilder(builder.name).build(set, settings);
        built.ms = watch.milliseconds();
        built.tree = std::move(outcome.tree);
        built.peakBytes = outcome.peakBytes;
        built.memoryLimited = outcome.memoryLimited;
        built.onDevice = uploadTree(device, set, built.tree, numbers);
    }
    built.statistics = computeStatistics(built.tree, settings.costs);
    return built;
}

BuiltInstances InstancedSession::build(Builder builder) {
    if (isOnDevice(builder.name)) run_.device.builder().prepare(settingsFor(builder.name, {}));
    run_.progress.phase("building (" + nameOf(builder) + ")");
    BuiltInstances all;
    all.sum.builder = builder;
    all.sum.setupMs = isOnDevice(builder.name) ? run_.device.builderSetupMilliseconds() : 0.0;
    all.noArea = instances_.noArea;
    std::vector<std::shared_ptr<DeviceTree>> trees;
    uint64_t bytes = 0;
    Hash hash;
    const auto take = [&](BuiltTree built) {
        all.sum.ms += built.ms;
        all.sum.peakBytes = std::max(all.sum.peakBytes, bytes + built.peakBytes);
        all.sum.memoryLimited = all.sum.memoryLimited || built.memoryLimited;
        all.sum.attempts = std::max(all.sum.attempts, built.attempts);
        add(all.sum.statistics, built.statistics);
        for (const char digit : treeHash(built.tree)) hash.add(static_cast<uint32_t>(digit));
        bytes += built.onDevice->memory.size();
        trees.push_back(std::move(built.onDevice));
    };
    for (const std::vector<Triangle>& mesh : instances_.meshes) take(buildOne(builder, mesh, {}));
    if (!instances_.rest.empty()) {
        take(buildOne(builder, instances_.rest, instances_.restNumbers));
        all.nonFinite = trees.back()->header.nonFinite;
        all.noArea += trees.back()->header.noArea;
    }
    all.sum.runs = {all.sum.ms};
    all.sum.hash = hash.text();
    all.onDevice = placeTrees(run_.device.device(), std::move(trees), instances_.nodes, instances_.places,
                              instances_.treeOf, instances_.exponent);
    run_.progress.clear();
    return all;
}

SceneFacts InstancedSession::facts(const BuiltInstances& built) const {
    return {scene_, posed_, needs_, instances_.triangles, built.nonFinite, built.noArea, loadMs_, poseMs_};
}

CheckResult InstancedSession::check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count) {
    run_.progress.phase("checking");
    const std::vector<Triangle> world = pose(scene_, time_).triangles;
    const Reference reference(world, makeTriangleSet(world).included);
    CheckResult result = cleave::check(reference, rays, hits, query, count, run_.options.settings.threads);
    run_.progress.clear();
    return result;
}

Traversal instancedTraversal(const Run& run) {
    return run.options.traversals.empty() ? Traversal::shortStack : run.options.traversals.front();
}

Json instancesBuildJson(const InstancedSession& session, const BuiltInstances& built) {
    const Instances& made = session.instances();
    Json build = buildJson(built.sum);
    build["trees"] = built.onDevice.trees.size();
    build["instances"] = {{"meshes", made.meshes.size()},
                          {"places", static_cast<size_t>(std::ranges::count(made.places, 0u, &PlacedMesh::isWorld))},
                          {"copiedPlaces", made.copiedPlaces},
                          {"placedTriangles", session.placedTriangles()},
                          {"restTriangles", made.rest.size()},
                          {"bytes", built.onDevice.bytes()}};
    return build;
}

std::string instancesLine(const InstancedSession& session, const BuiltInstances& built) {
    return "build     " + fixed(built.sum.ms, 3) + " ms (" + nameOf(built.sum.builder) + "), " +
           grouped(built.onDevice.trees.size()) + " trees in " + grouped(session.instances().places.size()) +
           " places, " + grouped(built.sum.statistics.nodes) + " nodes\n";
}

}  // namespace cleave
