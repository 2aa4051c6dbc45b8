// cleave stability --leaks: rays from inside of closed meshes, none of which may get out.
#include "app/commands.h"
#include "app/report.h"
#include "app/stability_trees.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/timing.h"
#include "stability/closed_meshes.h"

namespace cleave {
namespace {

constexpr uint64_t kBatch = uint64_t{1} << 20;

struct LeakFigures {
    std::string mesh, builder, traversal;
    uint64_t triangles = 0;
    Leaks leaks;
    double ms = 0.0;
};

LeakFigures shoot(Run& run, const ClosedMesh& mesh, const TreeUnderTest& tree, Traversal traversal, uint64_t rays) {
    LeakFigures figures{std::string(mesh.name), tree.builder, nameOf(traversal), mesh.triangles.size(), {}, 0.0};
    const uint64_t seed = seedFor(seedFor(run.options.seed, mesh.name), tree.builder + figures.traversal);
    for (uint64_t batch = 0; figures.leaks.rays < rays; ++batch) {
        run.progress.phase(figures.mesh + " (" + tree.builder + ", " + figures.traversal + "), " +
                           grouped(figures.leaks.rays) + " of " + grouped(rays) + " rays");
        const std::vector<Ray> some = leakRays(mesh, std::min(kBatch, rays - figures.leaks.rays), seed + batch);
        const Tracer::Result traced = run.device.tracer().trace(*tree.onDevice, some, {.traversal = traversal});
        countLeaks(figures.leaks, some, traced.hits);
        figures.ms += traced.ms;
    }
    return figures;
}

std::string leakTable(const std::vector<LeakFigures>& all) {
    std::vector<std::vector<std::string>> rows{
        {"mesh", "triangles", "builder", "traversal", "rays", "leaks", "ms", "Mrays/s"}};
    for (const LeakFigures& f : all)
        rows.push_back({f.mesh, grouped(f.triangles), f.builder, f.traversal, grouped(f.leaks.rays),
                        grouped(f.leaks.leaks), fixed(f.ms, 0), fixed(mraysPerSecond(f.leaks.rays, f.ms), 2)});
    return alignedTable(rows, "lrllrrrr");
}

Json leakJson(const std::vector<LeakFigures>& all) {
    Json meshes = Json::array();
    uint64_t rays = 0, leaks = 0;
    for (const LeakFigures& f : all) {
        meshes.push_back({{"mesh", f.mesh},
                          {"triangles", f.triangles},
                          {"builder", f.builder},
                          {"traversal", f.traversal},
                          {"rays", f.leaks.rays},
                          {"leaks", f.leaks.leaks},
                          {"ms", numberJson(f.ms)}});
        rays += f.leaks.rays;
        leaks += f.leaks.leaks;
    }
    return {{"rays", rays}, {"leaks", leaks}, {"meshes", meshes}};
}

void requireNoLeak(const std::vector<LeakFigures>& all) {
    for (const LeakFigures& f : all) {
        if (f.leaks.leaks == 0) continue;
        const Ray& r = f.leaks.first;
        char text[160];
        std::snprintf(text, sizeof text, "origin (%.9g, %.9g, %.9g), direction (%.9g, %.9g, %.9g)", double{r.origin.x},
                      double{r.origin.y}, double{r.origin.z}, double{r.direction.x}, double{r.direction.y},
                      double{r.direction.z});
        throw Error("stability: " + grouped(f.leaks.leaks) + " of " + grouped(f.leaks.rays) +
                    " rays leave the closed mesh " + f.mesh + " (" + f.builder + ", " + f.traversal +
                    "), first: " + text + "; please report this");
    }
}

}  // namespace

void runLeaks(Run& run) {
    const Options& options = run.options;
    const std::vector<ClosedMesh> meshes = closedMeshes(options.seed);
    std::vector<Builder> builders = options.builders;
    if (builders.empty()) builders = {Builder::gpu, Builder::exact};
    const uint64_t parts = meshes.size() * builders.size() * kDeviceTraversals.size();
    const uint64_t each = (*options.leaks + parts - 1) / parts;
    std::vector<LeakFigures> all;
    for (const ClosedMesh& mesh : meshes) {
        const TriangleSet set = makeTriangleSet(mesh.triangles);
        const DeviceTriangles triangles(run.device.device(), mesh.triangles);
        for (const Builder builder : builders) {
            const auto tree = buildForTest(run, builder, set, triangles);
            for (const Traversal traversal : kDeviceTraversals) all.push_back(shoot(run, mesh, *tree, traversal, each));
        }
    }
    run.print("seed " + std::to_string(options.seed) + ", " + oneLine(run.device.name().value_or("")) + "\n\n" +
              leakTable(all));
    writeReport(run, Json{{"leaks", leakJson(all)}, {"seed", options.seed}});
    requireNoLeak(all);
}

}  // namespace cleave
