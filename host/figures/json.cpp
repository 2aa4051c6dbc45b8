#include "figures/json.h"

#include <cmath>

#include "figures/timing.h"

namespace cleave {

Json numberJson(std::optional<double> value) { return value ? numberJson(*value) : Json(nullptr); }
Json numberJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json buildJson(const BuiltTree& built) {
    const TreeStatistics& s = built.statistics;
    Json kernels = Json::object();
    for (const PassWork& kernel : built.profile.passes) kernels[kernel.name] = numberJson(kernel.ms);
    return {{"builder", nameOf(built.builder)},
            {"ms", numberJson(built.ms)},
            {"trees", 1},
            {"runsMs", built.runs},
            {"setupMs", numberJson(built.setupMs)},
            {"sahCost", numberJson(s.sahCost)},
            {"costTraverse", s.costs.traverse},
            {"costIntersect", s.costs.intersect},
            {"costLeaf", s.costs.leaf},
            {"emptyBonus", std::round(1e6 * double{s.costs.emptyBonus}) / 1e6},  // 0.8, not what is nearest to it
            {"treeHash", built.hash},
            {"nodes", s.nodes},
            {"leaves", s.leaves},
            {"emptyLeaves", s.emptyLeaves},
            {"references", s.references},
            {"maxDepth", s.maxDepth},
            {"largestLeaf", s.largestLeaf},
            {"leafHistogram", s.leafHistogram},
            {"peakBytes", built.peakBytes},
            {"memoryLimited", built.memoryLimited},
            {"attempts", built.attempts},
            {"kernelsMs", kernels},
            {"expectedInner", numberJson(s.expectedInner)},
            {"expectedLeaves", numberJson(s.expectedLeaves)},
            {"expectedTriangles", numberJson(s.expectedTriangles)}};
}

Json traceJson(Traversal traversal, TriangleTest test, uint64_t rays, double ms, uint64_t invalidRays,
               uint64_t cappedRays) {
    return {{"traversal", nameOf(traversal)},
            {"triangleTest", nameOf(test)},
            {"rays", rays},
            {"ms", numberJson(ms)},
            {"mraysPerSecond", numberJson(mraysPerSecond(rays, ms))},
            {"invalidRays", invalidRays},
            {"cappedRays", cappedRays}};
}

Json checkJson(const CheckResult& result) {
    Json json{{"rays", result.rays},
              {"mismatches", result.mismatches},
              {"undecided", result.undecided},
              {"maxRelativeTError", numberJson(result.maxRelativeTError)}};
    if (!result.first.empty()) json["first"] = result.first;
    return json;
}

}  // namespace cleave
