#include <algorithm>

#include "app/build_options.h"
#include "app/command_options.h"
#include "app/option_kinds.h"
#include "app/run_options.h"

namespace cleave {
namespace {

constexpr uint64_t kMostHitsPerRay = 1u << 20;

}  // namespace

void addTrace(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb", true);
    app.add_option("RAYS", options.rays, "rays as .npy: float32 (N, 8): origin, tMin, direction, tMax")
        ->type_name("FILE")
        ->required();
    app.add_option("-o,--output", options.output, "the hits (hits.npy)")->type_name("FILE");
    CLI::Option* any = app.add_flag_callback(
        "--any", [&options] { options.query = Query::any; }, "any hit will do, not the closest");
    const auto first = [](const std::string& given) { return parseWhole(given, 1, kMostHitsPerRay); };
    CLI::Option* all = addParsed<uint64_t>(
        app, "--all", "K", "the first K hits, edges and vertices of closed surfaces once", first,
        [&options](uint64_t k) {
            options.query = Query::all;
            options.hitsPerRay = static_cast<uint32_t>(k);
        },
        "a whole number from 1 to " + std::to_string(kMostHitsPerRay));
    CLI::Option* count = app.add_flag_callback(
        "--count", [&options] { options.query = Query::count; }, "how many hits there are, counted in the same way");
    app.add_flag_callback(
           "--signed", [&options] { options.query = Query::signedCount; },
           "of --count: hits from behind a triangle less those from its front")
        ->needs(count);
    addTime(app, options);
    addBuild(app, options, false);
    addTree(app, options);
    addSplitMoving(app, options);
    addTraversal(app, options, false);
    addInstances(app, options);
    addLazy(app, options);
    CLI::Option* const own[] = {any, all, count};
    for (CLI::Option* one : own)
        for (CLI::Option* other : own)
            if (one != other) one->excludes(other);
    for (const char* fixed : {"--traversal", "--triangle-test", "--check"}) {
        all->excludes(fixed);
        count->excludes(fixed);
    }
    addKeepAll(app, options);
    addOutput(app, options);
}

void addQuery(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb", true);
    app.add_option("DATA", options.rays, "points (N, 3), or boxes (N, 2, 3), as .npy of float32")
        ->type_name("FILE")
        ->required();
    app.add_option("-o,--output", options.output, "the answers (out.npy)")->type_name("FILE");
    CLI::App* kind = app.add_option_group("QUESTION", "what is asked, one of");
    CLI::Option* nearest = kind->add_flag_callback(
        "--nearest", [&options] { options.question = Question::nearest; }, "of each point: the nearest triangle");
    kind->add_flag_callback(
        "--contains", [&options] { options.question = Question::contains; },
        "of each point: whether it is inside of the scene, which must be closed");
    kind->add_flag_callback(
        "--overlaps", [&options] { options.question = Question::overlaps; },
        "of each box: the triangles that meet it, as pairs of numbers");
    kind->require_option(1);
    const auto radius = [](const std::string& given) {
        const auto r = parseNumber(given);
        return r && *r >= 0.0 ? r : std::nullopt;
    };
    addParsed<double>(
        app, "--within", "R", "of --nearest: look no farther than this", radius,
        [&options](double r) { options.within = static_cast<float>(std::min(r, double{kLargestFloat})); },
        "a number of 0 or more")
        ->needs(nearest);
    addTime(app, options);
    addBuild(app, options, false);
    addTree(app, options);
    addKeepAll(app, options);
    addOutput(app, options);
}

}  // namespace cleave
