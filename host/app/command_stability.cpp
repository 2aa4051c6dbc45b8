#include <algorithm>

#include "app/commands.h"
#include "app/report.h"
#include "app/stability_trees.h"
#include "base/error.h"
#include "base/text.h"
#include "builders/builder_names.h"
#include "figures/stability_figures.h"
#include "formats/write_file.h"
#include "scene/pose.h"
#include "stability/cases.h"
#include "stability/placed_case.h"
#include "stability/query_sweep.h"

namespace cleave {
namespace {

constexpr uint64_t kQuickRays = 400, kFullRays = 4000;  // per case and family

// All builders but the one that makes no tree, whose answers are brute force's and come from elsewhere. A quick run
// takes two of them and a third that changes from case to case.
std::vector<Builder> buildersFor(const Options& options, size_t caseIndex) {
    if (!options.builders.empty()) return options.builders;
    std::vector<Builder> all{Builder::gpu, Builder::exact}, others{Builder::gpuExact};
    for (const TreeBuilder& builder : cpuBuilders())
        if (Builder{builder.name} != Builder::exact && builder.name != "brute") others.push_back({builder.name});
    if (options.quick) others = {others[caseIndex % others.size()]};
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

SweepSettings settingsFor(const Options& options) {
    SweepSettings settings;
    settings.rays = options.rayCount > 0 ? options.rayCount : options.quick ? kQuickRays : kFullRays;
    settings.bruteWork = options.quick ? 1'000'000 : 10'000'000;
    settings.seed = options.seed;
    settings.threads = options.settings.threads;
    return settings;
}

SceneFigures sweepScene(Run& run, const std::string& name, const std::string& about, std::span<const Triangle> world,
                        std::span<const Builder> builders) {
    const TriangleSet set = makeTriangleSet(world);
    const DeviceTriangles triangles(run.device.device(), world);
    const Options& options = run.options;
    const SweepSettings settings = settingsFor(options);
    SceneSweep sweep(name, world, set, settings);
    const std::vector<TraversalUnderTest> traversals = traversalsFor(run, set);
    const uint64_t work = options.quick ? 30'000 : 300'000;
    const QuerySweep queries(name, world, set, {settings.rays, work, settings.seed, settings.threads});
    SceneFigures figures{name, about, world.size(), set.included.size(), {}, {}, {}};
    for (const Builder builder : builders) {
        run.progress.phase(oneLine(name) + " (" + nameOf(builder) + ")");
        const std::shared_ptr<TreeUnderTest> tree = buildForTest(run, builder, set, triangles);
        buildHalves(run, builder, world, triangles, *tree);
        const TreeStatistics& s = tree->statistics;
        const double each =
            static_cast<double>(s.references) / static_cast<double>(std::max<size_t>(1, set.included.size()));
        figures.trees.push_back({tree->builder, s.nodes, s.maxDepth, each, tree->buildMs});
        std::vector<Cell> cells = sweep.run(tree, traversals);
        figures.cells.insert(figures.cells.end(), cells.begin(), cells.end());
        if (builder == Builder::gpu) {
            buildLazily(run, triangles, *tree);
            cells = sweep.run(tree, lazyTraversals(run));
            figures.cells.insert(figures.cells.end(), cells.begin(), cells.end());
        }
        const std::vector<QueryCell> more =
            queries.run(queriesOf(tree->builder, *tree->onDevice, run.device.tracer(), run.device.searcher()));
        figures.queries.insert(figures.queries.end(), more.begin(), more.end());
    }
    return figures;
}

// The cells of a case in three places, through instances. There are three times as many triangles to judge, so that
// fewer rays are shot, and a quick run takes one builder.
std::vector<Cell> sweepPlaced(Run& run, const std::string& name, std::span<const Triangle> mesh,
                              std::span<const Builder> builders, size_t caseIndex) {
    SweepSettings settings = settingsFor(run.options);
    settings.rays = (settings.rays + 7) / 8;
    Random random(seedFor(seedFor(settings.seed, name), "places"));
    const PlacedCase placed = placedCase(mesh, random);
    const TriangleSet set = makeTriangleSet(placed.world);
    const DeviceTriangles triangles(run.device.device(), placed.world);
    SceneSweep sweep(name, placed.world, set, settings);
    sweep.answerBy(buildForTest(run, Builder::exact, set, triangles), traversalsFor(run, set).front());
    const std::vector<TraversalUnderTest> traversals = placedTraversals(run);
    if (run.options.quick) builders = builders.subspan(caseIndex % builders.size(), 1);
    std::vector<Cell> cells;
    for (const Builder builder : builders) {
        run.progress.phase(oneLine(name) + " in places (" + nameOf(builder) + ")");
        const std::vector<Cell> more = sweep.run(buildPlaced(run, builder, placed.instances), traversals);
        cells.insert(cells.end(), more.begin(), more.end());
    }
    return cells;
}

bool isAsked(const Options& options, std::string_view name) {
    return options.cases.empty() || std::find(options.cases.begin(), options.cases.end(), name) != options.cases.end();
}

}  // namespace

void runStability(Run& run) {
    const Options& options = run.options;
    if (options.json) requireWritable(*options.json);
    if (options.leaks) return runLeaks(run);
    if (options.parity) return runParity(run);
    std::vector<SceneFigures> scenes;
    size_t index = 0;
    const auto add = [&](const std::string& name, const std::string& about, std::span<const Triangle> world) {
        const std::vector<Builder> builders = buildersFor(options, index);
        scenes.push_back(sweepScene(run, name, about, world, builders));
        const std::vector<Cell> placed = sweepPlaced(run, name, world, builders, index);
        scenes.back().cells.insert(scenes.back().cells.end(), placed.begin(), placed.end());
    };
    for (const StabilityCase& made : stabilityCases()) {
        ++index;
        if (!isAsked(options, made.name)) continue;
        Random random(seedFor(options.seed, made.name));
        const std::vector<Triangle> world = made.make(random, options.quick);
        add(std::string(made.name), std::string(made.about), world);
    }
    for (const std::filesystem::path& file : options.scenes) {
        ++index;
        add(file.filename().string(), "a file", pose(loadGltf(file)).triangles);
    }
    run.print("seed " + std::to_string(options.seed) + ", " + oneLine(run.device.name().value_or("")) + "\n\n" +
              stabilityText(scenes));
    Json report{{"stability", stabilityJson(scenes)}};
    report["stability"]["seed"] = options.seed;
    report["stability"]["quick"] = options.quick;
    writeReport(run, report);
    std::vector<Cell> all;
    for (const SceneFigures& scene : scenes) all.insert(all.end(), scene.cells.begin(), scene.cells.end());
    requireWithinBounds(all);
    std::vector<QueryCell> queries;
    for (const SceneFigures& scene : scenes) queries.insert(queries.end(), scene.queries.begin(), scene.queries.end());
    requireAsBruteForce(queries);
}

}  // namespace cleave
