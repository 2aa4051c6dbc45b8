#include <algorithm>

#include "app/build_options.h"
#include "app/command_options.h"
#include "app/option_kinds.h"
#include "app/run_options.h"
#include "stability/cases.h"

namespace cleave {
namespace {

void addCases(CLI::App& app, Options& options) {
    const auto read = [&options](const std::string& given) {
        options.cases = CLI::detail::split(given, ',');
        std::string known;
        for (const StabilityCase& made : stabilityCases())
            known += (known.empty() ? "" : ", ") + std::string(made.name);
        for (const std::string& name : options.cases)
            if (std::none_of(stabilityCases().begin(), stabilityCases().end(),
                             [&](const StabilityCase& made) { return made.name == name; }))
                throw CLI::ValidationError("--cases", "'" + name + "' is not known; there is: " + known);
    };
    app.add_option_function<std::string>("--cases", read, "these cases only")->type_name("NAME,...");
}

constexpr uint64_t kManyRays = 100'000'000;

}  // namespace

void addInfo(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb", true);
    app.add_flag("--validate", options.validate, "check the tree against its triangles");
    addTime(app, options);
    addBuild(app, options, false);
    addTree(app, options);
    app.add_option("--save-tree", options.saveTree, "keep the tree in this file, for --tree")->type_name("FILE");
    addKeepAll(app, options);
    addOutput(app, options);
}

void addBench(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scenes, ".gltf or .glb, one or more")->type_name("FILE")->required();
    addWhole(app, "--runs", "median of so many runs (5); on a device after a warm-up of 0.15 s", options.runs, 1,
             10000);
    app.add_flag("--interior", options.interior, "primary rays from inside, for rooms");
    addTime(app, options);
    addBuild(app, options, true);
    addTraversal(app, options, true);
    CLI::Option* survey =
        app.add_flag("--survey", options.survey, "the survey's tables, measured again with each of its builders");
    app.add_flag(
        "--work", options.work,
        "nodes, triangle tests and lanes in use per ray, time per pass and level of a build on the device, too");
    app.add_flag("--peers", options.peers,
                 "beside other ray tracers: the driver's own, Embree, a plain stack walk in C++");
    CLI::Option* queries =
        app.add_flag("--queries", options.queries, "all hits, counts, nearest points, containment, overlaps instead");
    for (const char* fixed : {"--builder", "--traversal", "--triangle-test", "--peers", "--work", "--queries"})
        survey->excludes(fixed);
    CLI::Option* needs = app.add_flag("--needs", options.needs, "what leaving out parts saves in pictures, one by one");
    for (const char* fixed : {"--builder", "--triangle-test", "--peers", "--work", "--queries", "--survey"})
        needs->excludes(fixed);
    for (const char* other : {"--traversal", "--triangle-test", "--peers", "--work", "--check"})
        queries->excludes(other);
    addKeepAll(app, options);
    needs->excludes("--keep-all");
    addOutput(app, options);
}

void addReport(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scenes, ".gltf or .glb, one or more")->type_name("FILE")->required();
    app.add_option("-o,--output", options.output, "the folder of index.html and report.json (report)")
        ->type_name("FOLDER");
    app.add_flag("--quick", options.quick, "builders at their defaults only, fewer rays, smaller pictures and 2 runs");
    app.add_flag("--peers", options.peers, "other ray tracers, too, on the same rays");
    addWhole(app, "--runs", "median of so many runs (5; quick: 2)", options.runs, 1, 10000);
    addWhole(app, "--check", "judge so many rays of each kind by the reference", options.check, 1, uint64_t{1} << 32);
    app.add_flag("--interior", options.interior, "primary rays from inside, for rooms");
    addMachine(app, options);
    addOutput(app, options);
}

void addStability(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scenes, ".gltf or .glb, further cases")->type_name("FILE");
    app.add_flag("--quick", options.quick, "fewer rays and builders, smaller scenes: about a minute");
    addCases(app, options);
    addWhole(app, "--rays", "rays per case and family (4000; quick: 400)", options.rayCount, 1, 1u << 24);
    const auto addRays = [&app](const std::string& name, std::optional<uint64_t>& rays, const std::string& text) {
        const auto read = [&rays, name](const std::string& given) {
            rays = given.empty() ? kManyRays : parseWhole(given, 1, uint64_t{1} << 40);
            if (!rays) throw CLI::ValidationError(name, "'" + given + "' is not a whole number above 0");
        };
        return app.add_option_function<std::string>(name, read, text)->type_name("N")->expected(0, 1);
    };
    CLI::Option* leaks =
        addRays("--leaks", options.leaks, "only: N rays (100,000,000) from inside of closed meshes, which must hit");
    addRays("--parity", options.parity, "only: N lines (100,000,000) through closed meshes, counted; all must be even")
        ->excludes(leaks);
    addWhole(app, "--seed", "of all cases and rays (1)", options.seed, 0, UINT64_MAX);
    addBuild(app, options, true);
    addOutput(app, options);
}

}  // namespace cleave
