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

// What is measured of a builder: also without what goes beyond its paper, where it does.
struct Measured {
    std::string_view name;
    bool hasPure;
};
// The first is what the others are compared with.
constexpr Measured kBuilders[] = {{"exact", true},       {"exact-nlog2n", true},    {"hunt-all", true},
                                  {"hunt-hybrid", true}, {"hunt-one", true},        {"shevtsov", true},
                                  {"gpu", true},         {"spatial-median", false}, {"object-median", false}};

// As the survey and its papers have it: exact builds sort in all nodes, planes stay where samples and bins put them,
// one axis is one axis, and binning ends where there are as few references as bins.
BuildSettings pureSettings(BuildSettings settings) {
    settings.smallNodes = SmallNodes::sort;
    settings.snap = false;
    settings.otherAxes = false;
    settings.exactUpTo = settings.bins;
    return settings;
}

struct SurveyRays {
    std::vector<Ray> primary, diffuse;
};

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

// Of every `step`-th ray of both sets, by the SAH's constants. It does not depend on what else the machine does.
double costPerRay(Run& run, const DeviceTree& tree, const SurveyRays& rays, size_t step = 1) {
    TraceMode counting;
    counting.countSteps = true;
    const SahCosts costs = run.options.settings.costs;
    double cost = 0.0;
    size_t counted = 0;
    for (const std::vector<Ray>* set : {&rays.primary, &rays.diffuse}) {
        std::vector<Ray> some;
        for (size_t i = 0; i < set->size(); i += step) some.push_back((*set)[i]);
        if (some.empty()) continue;
        counted += some.size();
        for (const StepCount& s : run.device.tracer().trace(tree, some, counting).steps)
            cost += double{costs.traverse} * s.inner + double{costs.leaf} * s.leaves +
                    double{costs.intersect} * s.triangles;
    }
    return cost / static_cast<double>(std::max<size_t>(1, counted));
}

// Diffuse rays start where the first builder's primary rays end, and are then the same for all.
SurveyVariant judged(Run& run, Session& session, Builder builder, const BuildSettings& settings, SurveyRays& rays) {
    SurveyVariant figures;
    BuiltTree built = session.build(builder, settings);
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

BuiltTree buildTimed(Session& session, Builder of, const BuildSettings& settings, SurveyVariant& figures) {
    BuiltTree built;
    built.builder = of;
    if (of == Builder::gpu) {
        built = session.build(of, settings);
        figures.allThreads.push_back(built.ms);
        return built;
    }
    const TreeBuilder& builder = cpuBuilder(of.name);
    BuildSettings alone = settings;
    alone.threads = 1;
    const std::clock_t before = std::clock();
    const Stopwatch one;
    builder.build(session.set(), alone);
    figures.oneThread.push_back(one.milliseconds());
    figures.oneCpu.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    const Stopwatch all;
    built.tree = builder.build(session.set(), settings).tree;
    figures.allThreads.push_back(all.milliseconds());
    return built;
}

void timeOnce(Run& run, Session& session, Builder builder, const BuildSettings& settings, const SurveyRays& rays,
              SurveyVariant& figures) {
    run.progress.phase("timing " + nameOf(builder));
    BuiltTree built = buildTimed(session, builder, settings, figures);
    const bool onDevice = built.onDevice != nullptr;
    const Stopwatch upload;
    const DeviceTree& tree = session.upload(built);
    if (!onDevice) figures.upload.push_back(upload.milliseconds());
    if (!rays.primary.empty()) figures.primary.push_back(run.device.tracer().trace(tree, rays.primary).ms);
    if (!rays.diffuse.empty()) figures.diffuse.push_back(run.device.tracer().trace(tree, rays.diffuse).ms);
}

// Counts of every 16th ray tell the costs of trees that differ by tens of per cent.
constexpr size_t kMedianRayStep = 16;

SurveyMedians mediansOf(Run& run, Session& session, const SurveyRays& rays) {
    SurveyMedians medians;
    BuiltTree exact = session.build(Builder::exact);
    medians.exactSahCost = exact.statistics.sahCost;
    medians.exactRayCost = costPerRay(run, session.upload(exact), rays, kMedianRayStep);
    for (const Builder builder : {Builder{"spatial-median"}, Builder{"object-median"}})
        for (const auto& [name, axes] : kAxes)
            for (const uint32_t leafSize : kMedianLeafSizes) {
                BuildSettings settings = run.options.settings;
                settings.axes = axes;
                settings.leafSize = leafSize;
                BuiltTree built = session.build(builder, settings);
                const double rayCost = costPerRay(run, session.upload(built), rays, kMedianRayStep);
                medians.trees.push_back(
                    {builder, axes, leafSize, built.statistics.sahCost, rayCost, built.statistics.references});
            }
    return medians;
}

SurveyComplexity complexityOf(Run& run, const TriangleSet& set) {
    run.progress.phase("counting events");
    SurveyComplexity complexity;
    BuildSettings alone = pureSettings(run.options.settings);
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

void requireOneExactTree(const Session& session, const SurveyScene& scene) {
    const SurveyBuilder *const once = scene.find("exact"), *const perNode = scene.find("exact-nlog2n");
    for (const std::string& hash : {once->pure->hash, perNode->ours.hash, perNode->pure->hash})
        if (hash != once->ours.hash)
            throw Error("bench of " + session.scene().name +
                        ": exact and exact-nlog2n built different trees; please report this scene");
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
    const BuildSettings& settings = run.options.settings;
    const BuildSettings pure = pureSettings(settings);
    for (const auto& [name, hasPure] : kBuilders) {
        SurveyBuilder& figures = scene.builders.emplace_back();
        figures.builder = {name};
        figures.ours = judged(run, session, figures.builder, settings, rays);
        if (hasPure) figures.pure = judged(run, session, figures.builder, pure, rays);
    }
    requireOneExactTree(session, scene);
    for (uint32_t i = 0; i < run.options.runs; ++i)
        for (SurveyBuilder& figures : scene.builders) {
            timeOnce(run, session, figures.builder, settings, rays, figures.ours);
            if (figures.pure) timeOnce(run, session, figures.builder, pure, rays, *figures.pure);
        }
    scene.medians = mediansOf(run, session, rays);
    scene.complexity = complexityOf(run, session.set());
    run.progress.clear();
    return scene;
}

}  // namespace cleave
