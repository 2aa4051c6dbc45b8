#include "app/stability_trees.h"

#include "base/stopwatch.h"
#include "facade/host_builders.h"
#include "run/device_builders.h"

namespace cleave {
namespace {

constexpr uint64_t kStackWork = 20'000'000;  // rays times triangles of the walk on the host

Forest halvesOf(const TreeUnderTest& tree) {
    if (tree.halves.empty()) return *tree.onDevice;
    return Forest({tree.halves[0].get(), tree.halves[1].get()});
}

// Those of the device, for closest and for any hits, with steps counted. `traceBy`: how, for a mode and its index.
template <typename TraceBy>
std::vector<TraversalUnderTest> ofEachWalk(const std::string& prefix, const TraceBy& traceBy) {
    std::vector<TraversalUnderTest> traversals;
    for (const Query query : {Query::closest, Query::any})
        for (const Traversal t : kDeviceTraversals) {
            const TraceMode mode{query, t, TriangleTest::watertight, true};
            traversals.push_back(
                {traversalName(prefix + nameOf(t), query), traceBy(mode, traversals.size()), UINT64_MAX, query});
        }
    return traversals;
}

}  // namespace

std::shared_ptr<TreeUnderTest> buildForTest(Run& run, Builder builder, const TriangleSet& set,
                                            const DeviceTriangles& triangles) {
    auto tree = std::make_shared<TreeUnderTest>();
    tree->builder = nameOf(builder);
    if (isOnDevice(builder.name)) {
        GpuBuilder::Result result =
            run.device.builder().build(triangles, settingsFor(builder.name, run.options.settings));
        tree->onDevice = std::move(result.tree);
        tree->tree = readBack(*tree->onDevice);
        tree->buildMs = result.ms;
    } else {
        const Stopwatch watch;
        tree->tree = hostBuilder(builder.name).build(set, run.options.settings).tree;
        tree->buildMs = watch.milliseconds();
        tree->onDevice = uploadTree(run.device.device(), set, tree->tree);
    }
    tree->statistics = computeStatistics(tree->tree);
    return tree;
}

// Triangles of even numbers, and the others.
void buildHalves(Run& run, Builder builder, std::span<const Triangle> world, const DeviceTriangles& triangles,
                 TreeUnderTest& tree) {
    tree.halves.clear();
    for (uint32_t first = 0; world.size() > 1 && first < 2; ++first) {
        std::vector<uint32_t> list;
        for (uint32_t i = first; i < world.size(); i += 2) list.push_back(i);
        if (isOnDevice(builder.name)) {
            const BuildSettings settings = settingsFor(builder.name, run.options.settings);
            tree.halves.push_back(run.device.builder().build(triangles, settings, list).tree);
            continue;
        }
        const TriangleSet half = makeTriangleSet(trianglesOf(world, list));
        const KdTree built = hostBuilder(builder.name).build(half, run.options.settings).tree;
        tree.halves.push_back(uploadTree(run.device.device(), half, built, list));
    }
}

void buildLazily(Run& run, const DeviceTriangles& triangles, TreeUnderTest& tree) {
    tree.lazy.clear();
    for (size_t i = 0; i < lazyTraversals(run).size(); ++i)
        tree.lazy.push_back(run.device.lazyBuilder().buildLazily(triangles, run.options.settings, kExactUpTo));
}

std::shared_ptr<TreeUnderTest> buildPlaced(Run& run, Builder builder, const Instances& instances) {
    auto placed = std::make_shared<TreeUnderTest>();
    placed->builder = nameOf(builder);
    std::vector<std::shared_ptr<DeviceTree>> trees;
    const auto add = [&](std::span<const Triangle> triangles, std::span<const uint32_t> numbers) {
        KdTree tree;
        if (isOnDevice(builder.name)) {
            const DeviceTriangles onDevice(run.device.device(), triangles);
            GpuBuilder& gpu = run.device.builder();
            const BuildSettings settings = settingsFor(builder.name, run.options.settings);
            trees.push_back(numbers.empty() ? gpu.build(onDevice, settings).tree
                                            : gpu.buildNumbered(onDevice, settings, numbers).tree);
            if (trees.size() == 1) tree = readBack(*trees.back());
        } else {
            const TriangleSet set = makeTriangleSet(triangles);
            tree = hostBuilder(builder.name).build(set, run.options.settings).tree;
            trees.push_back(uploadTree(run.device.device(), set, tree, numbers));
        }
        if (trees.size() == 1) placed->tree = std::move(tree);
    };
    for (const std::vector<Triangle>& mesh : instances.meshes) add(mesh, {});
    if (!instances.rest.empty() || instances.meshes.empty()) add(instances.rest, instances.restNumbers);
    placed->instances =
        std::make_shared<DeviceInstances>(placeTrees(run.device.device(), std::move(trees), instances.nodes,
                                                     instances.places, instances.treeOf, instances.exponent));
    return placed;
}

std::vector<TraversalUnderTest> traversalsFor(Run& run, const TriangleSet& set) {
    const auto onDevice = [&run](const TraceMode& mode, bool inHalves = false) {
        return [&run, mode, inHalves](const TreeUnderTest& tree, std::span<const Ray> rays) {
            return run.device.tracer().trace(inHalves ? halvesOf(tree) : Forest(*tree.onDevice), rays, mode);
        };
    };
    const auto counted = [](Query query, Traversal traversal) {
        return TraceMode{query, traversal, TriangleTest::watertight, true};
    };
    std::vector<TraversalUnderTest> traversals;
    for (const Query query : {Query::closest, Query::any}) {
        for (const Traversal t : kDeviceTraversals)
            traversals.push_back({traversalName(nameOf(t), query), onDevice(counted(query, t)), UINT64_MAX, query});
        const TraceMode fastest = counted(query, kDefaultTraversal);
        traversals.push_back({traversalName("two trees", query), onDevice(fastest, true), UINT64_MAX, query});
        const TraceMode asPrograms{query, kDefaultTraversal};
        traversals.push_back({traversalName("uncounted", query), onDevice(asPrograms), UINT64_MAX, query});
    }
    traversals.push_back(hostStack(set, kStackWork, run.options.settings.threads));
    return traversals;
}

std::vector<TraversalUnderTest> lazyTraversals(Run& run) {
    return ofEachWalk("lazy ", [&run](const TraceMode& mode, size_t index) {
        return [&run, mode, index](const TreeUnderTest& tree, std::span<const Ray> rays) {
            return run.device.tracer().trace(Forest(*tree.lazy[index]), rays, mode);
        };
    });
}

std::vector<TraversalUnderTest> placedTraversals(Run& run) {
    return ofEachWalk("instances ", [&run](const TraceMode& mode, size_t) {
        return [&run, mode](const TreeUnderTest& tree, std::span<const Ray> rays) {
            return run.device.tracer().trace(*tree.instances, rays, mode);
        };
    });
}

}  // namespace cleave
