#include "figures/report_json.h"

#include "figures/error_rows.h"
#include "figures/picture_rows.h"

namespace cleave {
namespace {

Json countsJson(const RayCounts& c) {
    return {{"inner", numberJson(c.inner)}, {"leaves", numberJson(c.leaves)}, {"triangles", numberJson(c.triangles)}};
}

Json linesJson(const LineErrors& lines) {
    return {{"lines", lines.lines},
            {"hits", lines.hits},
            {"unstopped", countsJson(lines.unstopped)},
            {"untilHit", countsJson(lines.hitting)},
            {"withoutHit", countsJson(lines.missing)},
            {"fromHit", countsJson(lines.beyond)},
            {"descent", countsJson(lines.descent)}};
}

Json predictionJson(const SceneErrors& scene, const TracedErrors& traced) {
    const TreeErrors& tree = scene.trees[traced.tree];
    Json row{{"scene", scene.name},
             {"builder", tree.builder},
             {"settings", tree.settings},
             {"sahCost", tree.hasCost ? numberJson(tree.sahCost) : Json()},
             {"expected", tree.hasCost ? countsJson(tree.expected) : Json()},
             {"lines", linesJson(traced.lines)}};
    for (size_t k = 0; k < kRaySets.size(); ++k) {
        row[kRaySets[k]] = countsJson(traced.counts[k]);
        row[kRaySets[k]]["byRestart"] = countsJson(traced.restartCounts[k]);
    }
    return row;
}

Json fittedJson(const SceneErrors& scene, const NamedFit& fit) {
    return {{"scene", scene.name},
            {"rays", fit.rays},
            {"rayNs", fit.costs.ray},
            {"innerNs", fit.costs.inner},
            {"triangleNs", fit.costs.triangle},
            {"meanError", fit.costs.meanError},
            {"largestError", fit.costs.largestError},
            {"trees", fit.costs.samples}};
}

Json errorsJson(const std::vector<SceneErrors>& scenes) {
    Json tree = Json::array(), rays = Json::array(), hits = Json::array(), picture = Json::array();
    const auto add = [](Json& all, const Json& more) {
        for (const Json& row : more) all.push_back(row);
    };
    for (const SceneErrors& scene : scenes) {
        add(tree, errorRowsJson(treeRows(scene)));
        add(rays, errorRowsJson(rayRows(scene)));
        add(hits, errorRowsJson(hitRows(scene)));
        add(picture, pictureRowsJson(scene));
    }
    return {{"tree", tree}, {"rays", rays}, {"hits", hits}, {"picture", picture}};
}

}  // namespace

Json reportJson(const ReportPage& page) {
    Json predictions = Json::array(), fitted = Json::array(), leftOut = Json::array();
    for (const SceneErrors& scene : page.scenes) {
        for (const TracedErrors& traced : scene.traced) predictions.push_back(predictionJson(scene, traced));
        for (const NamedFit& fit : scene.fits) fitted.push_back(fittedJson(scene, fit));
    }
    for (const auto& [what, why] : page.leftOut) leftOut.push_back({{"what", what}, {"why", why}});
    return {{"program", page.version},    {"commandLine", page.commandLine},
            {"runs", page.runs},          {"traversal", page.settings.traversal},
            {"interrupted", page.wentOn}, {"errors", errorsJson(page.scenes)},
            {"predictions", predictions}, {"fitted", fitted},
            {"leftOut", leftOut},         {"picture", pictureJson(page.scenes)}};
}

}  // namespace cleave
