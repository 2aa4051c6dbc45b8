#include "app/survey_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "builders/builder_names.h"
#include "scene/camera.h"
#include "scene/ray_sets.h"

namespace cleave {
namespace {

// The first is what the others are compared with.
constexpr std::string_view kBuilders[] = {"exact",    "exact-nlog2n", "hunt-all",       "hunt-hybrid",  "hunt-one",
                                          "shevtsov", "gpu",          "spatial-median", "object-median"};

struct SurveyRays {
    std::vector<Ray> primary, diffuse;
};

bool isThere(std::string_view name) {
    const std::span<const TreeBuilder> builders = cpuBuilders();
    return name == Builder::gpu.name || std::any_of(builders.begin(), builders.end(),
                                                    [&](const TreeBuilder& builder) { return builder.name == name; });
}

std::vector<Hit> traceJudged(Run& run, Session& session, const DeviceTree& tree, std::span<const Ray> rays,
                             const std::string& what, CheckResult& sum) {
    if (rays.empty()) return {};
    run.progress.phase("checking " + what);
    Tracer::Result traced = run.device.tracer().trace(tree, rays);
    const CheckResult check = session.check(rays, traced.hits, Query::closest, raysToJudge(run.options));
    requireAnswered(traced.cappedRays, check, what);
    sum.add(check);
    return std::move(traced.hits);
}

// Of both sets, by the SAH's constants. It does not depend on what else the machine does.
double costPerRay(Run& run, const DeviceTree& tree, const SurveyRays& rays) {
    TraceMode counting;
    counting.countSteps = true;
    const SahCosts costs = run.options.settings.costs;
    double cost = 0.0;
    for (const std::vector<Ray>* set : {&rays.primary, &rays.diffuse}) {
        if (set->empty()) continue;
        for (const StepCount& s : run.device.tracer().trace(tree, *set, counting).steps)
            cost += double{costs.traverse} * s.inner + double{costs.leaf} * s.leaves +
                    double{costs.intersect} * s.triangles;
    }
    return cost / static_cast<double>(std::max<size_t>(1, rays.primary.size() + rays.diffuse.size()));
}

// Diffuse rays start where the first builder's primary rays end, and are then the same for all.
SurveyBuilder judged(Run& run, Session& session, Builder builder, SurveyRays& rays) {
    SurveyBuilder figures;
    figures.builder = builder;
    BuiltTree built = session.build(builder);
    figures.statistics = built.statistics;
    figures.hash = built.hash;
    const DeviceTree& tree = session.upload(built);
    const std::string what = session.scene().name + ", " + nameOf(builder);
    const std::vector<Hit> hits = traceJudged(run, session, tree, rays.primary, what + ", primary rays", figures.check);
    if (rays.diffuse.empty() && !hits.empty())
        rays.diffuse = diffuseRays(surfacePoints(session.posed().triangles, session.worldBounds(), rays.primary, hits));
    traceJudged(run, session, tree, rays.diffuse, what + ", diffuse rays", figures.check);
    figures.rayCost = costPerRay(run, tree, rays);
    return figures;
}

BuiltTree buildTimed(Run& run, Session& session, SurveyBuilder& figures) {
    BuiltTree built;
    built.builder = figures.builder;
    if (built.builder == Builder::gpu) {
        built = session.build(built.builder);
        figures.allThreads.push_back(built.ms);
        return built;
    }
    const TreeBuilder& builder = cpuBuilder(built.builder.name);
    BuildSettings alone = run.options.settings;
    alone.threads = 1;
    const std::clock_t before = std::clock();
    const Stopwatch one;
    builder.build(session.set(), alone);
    figures.oneThread.push_back(one.milliseconds());
    figures.oneCpu.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    const Stopwatch all;
    built.tree = builder.build(session.set(), run.options.settings).tree;
    figures.allThreads.push_back(all.milliseconds());
    return built;
}

void timeOnce(Run& run, Session& session, const SurveyRays& rays, SurveyBuilder& figures) {
    run.progress.phase("timing " + nameOf(figures.builder));
    BuiltTree built = buildTimed(run, session, figures);
    const bool onDevice = built.onDevice != nullptr;
    const Stopwatch upload;
    const DeviceTree& tree = session.upload(built);
    if (!onDevice) figures.upload.push_back(upload.milliseconds());
    if (!rays.primary.empty()) figures.primary.push_back(run.device.tracer().trace(tree, rays.primary).ms);
    if (!rays.diffuse.empty()) figures.diffuse.push_back(run.device.tracer().trace(tree, rays.diffuse).ms);
}

SurveyComplexity complexityOf(Run& run, const TriangleSet& set) {
    run.progress.phase("counting events");
    SurveyComplexity complexity;
    BuildSettings alone = run.options.settings;
    alone.threads = 1;
    const KdTree tree = buildExact(set, alone, &complexity.once);
    buildExactNLog2N(set, alone, &complexity.perNode);
    const std::vector<CutNode> nodes = cutNodes(tree);
    complexity.straddling = fitStraddling(nodes);
    for (const CutNode& node : nodes)
        if (node.triangles >= 64)
            complexity.worstCut =
                std::max(complexity.worstCut, node.straddling / std::sqrt(static_cast<double>(node.triangles)));
    return complexity;
}

}  // namespace

SurveyScene measureForSurvey(Run& run, Session& session, const std::filesystem::path& file) {
    SurveyScene scene;
    scene.name = oneLine(file.stem().string());
    scene.triangles = session.set().included.size();
    scene.model = surveyModelOf(scene.name, scene.triangles);
    scene.standsIn = scene.model != nullptr && scene.name != scene.model->name;
    SurveyRays rays;
    if (!isEmpty(session.worldBounds())) rays.primary = primaryRays(session.worldBounds(), run.options.interior);
    scene.rays = rays.primary.size();
    for (const std::string_view name : kBuilders)
        if (isThere(name)) scene.builders.push_back(judged(run, session, Builder{name}, rays));
    if (scene.find("exact")->hash != scene.find("exact-nlog2n")->hash)
        throw Error("bench of " + session.scene().name +
                    ": exact and exact-nlog2n built different trees; please report this scene");
    for (uint32_t i = 0; i < run.options.runs; ++i)
        for (SurveyBuilder& figures : scene.builders) timeOnce(run, session, rays, figures);
    scene.complexity = complexityOf(run, session.set());
    run.progress.clear();
    return scene;
}

}  // namespace cleave
