#include "app/stability_trees.h"

#include "base/stopwatch.h"
#include "facade/host_builders.h"

namespace cleave {
namespace {

constexpr uint64_t kStackWork = 20'000'000;  // rays times triangles of the walk on the host

}  // namespace

std::shared_ptr<TreeUnderTest> buildForTest(Run& run, Builder builder, const TriangleSet& set,
                                            const DeviceTriangles& triangles) {
    auto tree = std::make_shared<TreeUnderTest>();
    tree->builder = nameOf(builder);
    if (builder == Builder::gpu) {
        GpuBuilder::Result result = run.device.builder().build(triangles, run.options.settings);
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

std::vector<TraversalUnderTest> traversalsFor(Run& run, const TriangleSet& set) {
    const auto onDevice = [&run](Traversal traversal, Query query) {
        return [&run, traversal, query](const TreeUnderTest& tree, std::span<const Ray> rays) {
            const TraceMode mode{query, traversal, TriangleTest::watertight, true};
            return run.device.tracer().trace(*tree.onDevice, rays, mode);
        };
    };
    std::vector<TraversalUnderTest> traversals;
    for (const Query query : {Query::closest, Query::any})
        for (const Traversal t : kDeviceTraversals)
            traversals.push_back({traversalName(nameOf(t), query), onDevice(t, query), UINT64_MAX, query});
    traversals.push_back(hostStack(set, kStackWork, run.options.settings.threads));
    return traversals;
}

}  // namespace cleave
