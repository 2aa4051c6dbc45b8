// `cleave bench --survey`: the tables of the survey, measured again.
#include "app/commands.h"
#include "app/report.h"
#include "app/survey_run.h"
#include "base/text.h"
#include "figures/survey_tables.h"
#include "formats/write_file.h"

namespace cleave {
namespace {

Json lawJson(const StraddlingLaw& law) {
    if (law.octaves < 2) return nullptr;
    return {{"factor", numberJson(law.factor)}, {"exponent", numberJson(law.exponent)}, {"octaves", law.octaves}};
}

Json reportJson(const BuildReport& report) {
    return {{"peakBytes", report.peakBytes}, {"eventsSwept", report.eventsSwept}, {"sortSteps", report.sortSteps}};
}

Json variantJson(const SurveyVariant& v) {
    return {{"oneThreadMs", v.oneThread},
            {"oneThreadCpuMs", v.oneCpu},
            {"allThreadsMs", v.allThreads},
            {"uploadMs", v.upload},
            {"primaryMs", v.primary},
            {"diffuseMs", v.diffuse},
            {"rayCost", numberJson(v.rayCost)},
            {"sahCost", numberJson(v.statistics.sahCost)},
            {"references", v.statistics.references},
            {"nodes", v.statistics.nodes},
            {"treeHash", v.hash},
            {"check", checkJson(v.check)}};
}

// Our figures beside the builder's name, the pure ones below `pure`.
Json builderJson(const SurveyBuilder& b) {
    Json json = variantJson(b.ours);
    json["builder"] = nameOf(b.builder);
    json["pure"] = b.pure ? variantJson(*b.pure) : Json(nullptr);
    return json;
}

Json mediansJson(const SurveyMedians& medians) {
    Json trees = Json::array();
    for (const MedianTree& tree : medians.trees)
        trees.push_back({{"builder", nameOf(tree.builder)},
                         {"axes", nameOf(tree.axes)},
                         {"leafSize", tree.leafSize},
                         {"sahCost", numberJson(tree.sahCost)},
                         {"rayCost", numberJson(tree.rayCost)},
                         {"references", tree.references}});
    return {{"exactSahCost", numberJson(medians.exactSahCost)},
            {"exactRayCost", numberJson(medians.exactRayCost)},
            {"trees", trees}};
}

Json surveyJson(const SurveyScene& scene) {
    Json builders = Json::array();
    for (const SurveyBuilder& b : scene.builders) builders.push_back(builderJson(b));
    const SurveyComplexity& c = scene.complexity;
    return {{"model", scene.model != nullptr ? Json(scene.model->name) : Json(nullptr)},
            {"standsIn", scene.standsIn},
            {"rays", scene.rays},
            {"builders", builders},
            {"medians", mediansJson(scene.medians)},
            {"complexity",
             {{"exact", reportJson(c.once)},
              {"exact-nlog2n", reportJson(c.perNode)},
              {"straddling", lawJson(c.straddling)},
              {"straddlingOverRoot", numberJson(c.worstCut)}}}};
}

}  // namespace

void runSurvey(Run& run) {
    if (run.options.json) requireWritable(*run.options.json);
    std::vector<SurveyScene> scenes;
    Json reports = Json::array();
    for (const std::filesystem::path& file : run.options.scenes) {
        Session session(run, file);
        scenes.push_back(measureForSurvey(run, session, file));
        reports.push_back({{"scene", sceneJson(session)}, {"survey", surveyJson(scenes.back())}});
    }
    const uint32_t threads = run.options.settings.threads;
    run.print(oneLine(run.device.name().value_or("")) + ", median of " + std::to_string(run.options.runs) +
              ", builders take turns; ratios are of these medians\n\n" + surveyTables(scenes, threads));
    Json report = reports.size() == 1 ? reports.front() : Json{{"scenes", reports}};
    report["threads"] = threads;
    writeReport(run, report);
}

}  // namespace cleave
