// cleave stability --parity: lines through closed meshes, each of which must leave as often as it enters.
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

struct ParityFigures {
    std::string mesh, builder;
    uint64_t triangles = 0;
    Parity parity;
    double ms = 0.0;
};

ParityFigures shoot(Run& run, const ClosedMesh& mesh, const TreeUnderTest& tree, uint64_t lines) {
    ParityFigures figures{std::string(mesh.name), tree.builder, mesh.triangles.size(), {}, 0.0};
    const uint64_t seed = seedFor(seedFor(run.options.seed, mesh.name), tree.builder);
    for (uint64_t batch = 0; figures.parity.lines < lines; ++batch) {
        run.progress.phase(figures.mesh + " (" + tree.builder + "), " + grouped(figures.parity.lines) + " of " +
                           grouped(lines) + " lines");
        const std::vector<Ray> some = linesThrough(mesh, std::min(kBatch, lines - figures.parity.lines), seed + batch);
        const Tracer::Counts counted = run.device.tracer().count(*tree.onDevice, some, true);
        addParity(figures.parity, some, counted.counts);
        figures.ms += counted.ms;
    }
    return figures;
}

std::string parityTable(const std::vector<ParityFigures>& all) {
    std::vector<std::vector<std::string>> rows{
        {"mesh", "triangles", "builder", "lines", "odd", "uneven", "ms", "Mrays/s"}};
    for (const ParityFigures& f : all)
        rows.push_back({f.mesh, grouped(f.triangles), f.builder, grouped(f.parity.lines), grouped(f.parity.odd),
                        grouped(f.parity.uneven), fixed(f.ms, 0), fixed(mraysPerSecond(f.parity.lines, f.ms), 2)});
    return alignedTable(rows, "lrlrrrrr");
}

Json parityJson(const std::vector<ParityFigures>& all) {
    Json meshes = Json::array();
    Parity sum;
    for (const ParityFigures& f : all) {
        meshes.push_back({{"mesh", f.mesh},
                          {"triangles", f.triangles},
                          {"builder", f.builder},
                          {"lines", f.parity.lines},
                          {"odd", f.parity.odd},
                          {"uneven", f.parity.uneven},
                          {"ms", numberJson(f.ms)}});
        sum.lines += f.parity.lines;
        sum.odd += f.parity.odd;
        sum.uneven += f.parity.uneven;
    }
    return {{"lines", sum.lines}, {"odd", sum.odd}, {"uneven", sum.uneven}, {"meshes", meshes}};
}

void requireEven(const std::vector<ParityFigures>& all) {
    for (const ParityFigures& f : all) {
        if (f.parity.uneven == 0) continue;
        const Ray& r = f.parity.first;
        char text[160];
        std::snprintf(text, sizeof text, "origin (%.9g, %.9g, %.9g), direction (%.9g, %.9g, %.9g)", double{r.origin.x},
                      double{r.origin.y}, double{r.origin.z}, double{r.direction.x}, double{r.direction.y},
                      double{r.direction.z});
        throw Error("stability: " + grouped(f.parity.uneven) + " of " + grouped(f.parity.lines) +
                    " lines through the closed mesh " + f.mesh + " (" + f.builder +
                    ") leave it more or less often than they enter it, first: " + text + "; please report this");
    }
}

}  // namespace

void runParity(Run& run) {
    const Options& options = run.options;
    std::vector<ClosedMesh> meshes = closedMeshes(options.seed);
    for (ClosedMesh& mesh : closedSlivers(options.seed)) meshes.push_back(std::move(mesh));
    std::vector<Builder> builders = options.builders;
    if (builders.empty()) builders = {Builder::gpu, Builder::exact};
    const uint64_t parts = meshes.size() * builders.size();
    const uint64_t each = (*options.parity + parts - 1) / parts;
    std::vector<ParityFigures> all;
    for (const ClosedMesh& mesh : meshes) {
        const TriangleSet set = makeTriangleSet(mesh.triangles);
        const DeviceTriangles triangles(run.device.device(), mesh.triangles);
        for (const Builder builder : builders) {
            const auto tree = buildForTest(run, builder, set, triangles);
            all.push_back(shoot(run, mesh, *tree, each));
        }
    }
    run.print("seed " + std::to_string(options.seed) + ", " + oneLine(run.device.name().value_or("")) + "\n\n" +
              parityTable(all));
    writeReport(run, Json{{"parity", parityJson(all)}, {"seed", options.seed}});
    requireEven(all);
}

}  // namespace cleave
