#include "app/json_report.h"

#include <cmath>

#include "app/write_file.h"

namespace cleave {

Json numberJson(std::optional<double> value) { return value ? numberJson(*value) : Json(nullptr); }
Json numberJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json sceneJson(const Session& session) {
    // The kinds that scripts look for are there also where their count is 0.
    Json leftOut{{"points", 0}, {"lines", 0}};
    for (const auto& [what, count] : session.posed().leftOut) leftOut[what] = count;
    leftOut["nonFinite"] = session.set().nonFinite;
    leftOut["noArea"] = session.set().noArea;
    return {{"name", session.scene().name},
            {"triangles", session.posed().triangles.size()},
            {"leftOut", leftOut},
            {"materials", session.scene().materials.size()},
            {"cameras", session.posed().cameras.size()}};
}

Json buildJson(const BuiltTree& built) {
    const TreeStatistics& s = built.statistics;
    Json kernels = Json::object();
    for (const KernelTime& kernel : built.kernels) kernels[kernel.name] = numberJson(kernel.ms);
    return {{"builder", nameOf(built.builder)},
            {"ms", numberJson(built.ms)},
            {"runsMs", built.runs},
            {"setupMs", numberJson(built.setupMs)},
            {"sahCost", numberJson(s.sahCost)},
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

void writeReport(const Run& run, Json report) {
    if (!run.options.json) return;
    const std::optional<std::string> name = run.device.name();
    report["device"] = {{"name", name ? Json(*name) : Json(nullptr)}};
    report["process"] = {{"peakBytes", processPeakBytes()}};
    report["total"] = {{"ms", numberJson(run.total.milliseconds())}};
    // Names come from files and may be no UTF-8; what is not is replaced.
    writeFile(*run.options.json, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace cleave
