#include "twin/twin_builder.h"

#include "base/error.h"
#include "core/build_layout.h"
#include "core/capacity.h"
#include "tree/build_info.h"
#include "twin/passes.h"

namespace cleave {

namespace {

// The set is scaled already, and scaling it again by its own exponent would change nothing; so the pass that finds the
// scale does not run: what it would find is a largest coordinate in [0.5, 1).
BuildArrays built(const TriangleSet& set, const BuildInfo& info) {
    BuildArrays a = makeArrays(set.triangles, {}, info);
    a.state.scene.largest = floatBitsToUint(0.5f);
    for (const twin::Pass& pass : twin::setupPasses())
        if (pass.run != twin::findScale) pass.run(a, 0);
    twin::runLevels(a, choiceOf(info));
    return a;
}

KdTree treeOf(BuildArrays& a, const TriangleSet& set) {
    KdTree tree;
    tree.bounds = a.header.bounds;
    tree.exponent = set.exponent;
    a.tree.resize(a.header.nodeCount);
    a.leafRefs.resize(a.header.leafRefCount);
    tree.nodes = std::move(a.tree);
    tree.leafTriangles = std::move(a.leafRefs);
    return tree;
}

// With the counts that the device's build has, so that budgets cut both alike.
BuildInfo infoFor(const TriangleSet& set, const BuildSettings& settings, Geometry& all) {
    all.triangleCount = static_cast<uint32_t>(set.triangles.size());
    BuildInfo info = buildInfo(settings);
    info.geometries = &all;
    info.geometryCount = 1;
    return info;
}

}  // namespace

BuildOutcome buildTwin(const TriangleSet& set, const BuildSettings& settings) {
    Geometry all;
    BuildInfo info = infoFor(set, settings, all);
    info.capacity = requireCapacity(info, settings.memory);
    while (true) {
        BuildArrays a = built(set, info);
        const Capacity wanted{a.header.wantedRefs, a.header.wantedLevelNodes, a.header.wantedNodes,
                              a.header.wantedLeafRefs};
        BuildOutcome result;
        result.memoryLimited = a.header.status == kShortOfCapacity;
        result.peakBytes = buildBytes(info);
        if (result.memoryLimited && growCapacity(info, wanted, settings.memory)) continue;
        result.tree = treeOf(a, set);
        return result;
    }
}

}  // namespace cleave
