#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/frame_files.h"
#include "app/option_values.h"
#include "base/error.h"
#include "base/text.h"
#include "facade/host_builders.h"
#include "stability/cases.h"

namespace cleave {
namespace {

constexpr std::array<std::pair<const char*, Command>, 8> kCommands = {{{"render", Command::render},
                                                                       {"trace", Command::trace},
                                                                       {"query", Command::query},
                                                                       {"info", Command::info},
                                                                       {"bench", Command::bench},
                                                                       {"report", Command::report},
                                                                       {"stability", Command::stability},
                                                                       {"devices", Command::devices}}};
constexpr std::array<std::pair<const char*, View>, 6> kViews = {{{"shaded", View::shaded},
                                                                 {"path", View::path},
                                                                 {"normals", View::normals},
                                                                 {"depth", View::depth},
                                                                 {"steps", View::steps},
                                                                 {"leaves", View::leaves}}};
constexpr std::array<std::pair<const char*, StopRule>, 2> kStopRules = {
    {{"sah", StopRule::cost}, {"sa-n", StopRule::equation41}}};
constexpr std::array<std::pair<const char*, SmallNodes>, 2> kSmallNodes = {
    {{"count", SmallNodes::count}, {"sort", SmallNodes::sort}}};
constexpr std::array<std::pair<const char*, bool>, 2> kSwitch = {{{"on", true}, {"off", false}}};

template <typename Table>
std::string namesIn(const Table& table) {
    std::string names;
    for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

template <typename Value, size_t n>
Value lookUp(const std::array<std::pair<const char*, Value>, n>& table, const std::string& option,
             const std::string& name) {
    for (const auto& [known, value] : table)
        if (name == known) return value;
    throw CLI::ValidationError(option, "'" + name + "' is not known; there is: " + namesIn(table));
}

// The device's builder, then those of the CPU.
std::vector<std::pair<std::string_view, std::string_view>> builderDescriptions() {
    std::vector<std::pair<std::string_view, std::string_view>> builders{
        {Builder::gpu.name, "min-max binning on the device (Shevtsov et al. 2007), the default"}};
    for (const TreeBuilder& builder : hostBuilders()) builders.emplace_back(builder.name, builder.description);
    return builders;
}

Builder builderNamed(const std::string& name) {
    for (const auto& [known, description] : builderDescriptions())
        if (name == known) return {known};
    throw CLI::ValidationError("--builder", "'" + name + "' is not known; there is: " + namesIn(builderDescriptions()));
}

// Adds an option whose text goes through `parse`; where that gives nothing, the use is wrong and `wanted` says why.
template <typename Value>
CLI::Option* addParsed(CLI::App& app, const std::string& name, const std::string& type, const std::string& text,
                       std::function<std::optional<Value>(const std::string&)> parse, std::function<void(Value)> set,
                       const std::string& wanted) {
    const auto read = [=](const std::string& given) {
        const std::optional<Value> value = parse(given);
        if (!value) throw CLI::ValidationError(name, "'" + given + "' is not " + wanted);
        set(*value);
    };
    return app.add_option_function<std::string>(name, read, text)->type_name(type);
}

template <typename Number>
void addWhole(CLI::App& app, const std::string& name, const std::string& text, Number& target, uint64_t least,
              uint64_t most) {
    addParsed<uint64_t>(
        app, name, "N", text, [=](const std::string& given) { return parseWhole(given, least, most); },
        [&target](uint64_t value) { target = static_cast<Number>(value); },
        "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

// A number from `least` to `most`, whose texts the refusal shows; the target is the default.
void addNumber(CLI::App& app, const std::string& name, const std::string& text, float& target,
               std::pair<double, const char*> least, std::pair<double, const char*> most) {
    const auto parse = [=](const std::string& given) {
        const std::optional<double> value = parseNumber(given);
        return value && *value >= least.first && *value <= most.first ? value : std::nullopt;
    };
    const std::string fallback = fixed(target, target == std::floor(target) ? 0 : 1);
    addParsed<double>(
        app, name, "X", text + " (" + fallback + ")", parse,
        [&target](double value) { target = static_cast<float>(value); },
        std::string("a number from ") + least.second + " to " + most.second);
}

template <typename Value, size_t n>
void addNamed(CLI::App& app, const std::string& name, const std::string& text, Value& target,
              const std::array<std::pair<const char*, Value>, n>& table) {
    app.add_option_function<std::string>(
           name, [&table, &target, name](const std::string& given) { target = lookUp(table, name, given); },
           text + " (" + namesIn(table) + ")")
        ->type_name("NAME");
}

void addHeuristic(CLI::App& app, BuildSettings& settings) {
    SahCosts& costs = settings.costs;
    addNumber(app, "--cost-traverse", "SAH cost of an inner node", costs.traverse, {0.001, "0.001"}, {1000, "1000"});
    addNumber(app, "--cost-intersect", "SAH cost of a triangle test", costs.intersect, {0.001, "0.001"},
              {1000, "1000"});
    addNumber(app, "--cost-leaf", "SAH cost of a leaf", costs.leaf, {0, "0"}, {1000, "1000"});
    addNumber(app, "--empty-bonus", "factor on the SAH cost of a split that leaves a side empty; 1: none",
              costs.emptyBonus, {0.001, "0.001"}, {1, "1"});
    addNamed(app, "--stop", "SAH builders split where that costs less, or where areas times triangles shrink",
             settings.stop, kStopRules);
}

// The same for a list, each name once; of one name unless `several`.
template <typename Value, size_t n>
void addNames(CLI::App& app, const std::string& name, const std::string& text, std::vector<Value>& target,
              const std::array<std::pair<const char*, Value>, n>& table, bool several) {
    const auto read = [&table, &target, name, several](const std::string& given) {
        target.clear();
        for (const std::string& one : several ? CLI::detail::split(given, ',') : std::vector<std::string>{given}) {
            const Value value = lookUp(table, name, one);
            if (std::find(target.begin(), target.end(), value) != target.end())
                throw CLI::ValidationError(name, "'" + one + "' is given twice");
            target.push_back(value);
        }
    };
    app.add_option_function<std::string>(name, read, text + " (" + namesIn(table) + ")")
        ->type_name(several ? "NAME,..." : "NAME");
}

void addBuilders(CLI::App& app, Options& options, bool several) {
    const auto read = [&options, several](const std::string& given) {
        options.builders.clear();
        std::vector<std::string> names = several ? CLI::detail::split(given, ',') : std::vector<std::string>{given};
        for (const std::string& name : names) {
            const Builder builder = builderNamed(name);
            for (const Builder other : options.builders)
                if (other == builder) throw CLI::ValidationError("--builder", "'" + name + "' is given twice");
            options.builders.push_back(builder);
        }
    };
    app.add_option_function<std::string>("--builder", read,
                                         std::string("who builds the tree") +
                                             (several ? ", or several: gpu,exact" : "") + " (" +
                                             namesIn(builderDescriptions()) + ")")
        ->type_name(several ? "NAME,..." : "NAME");
    std::string footer = "Builders:";
    for (const auto& [name, description] : builderDescriptions())
        footer += "\n  " + std::string(name) + ": " + std::string(description);
    app.footer(footer);
}

void addOutput(CLI::App& app, Options& options) {
    app.add_option("--json", options.json, "write all figures to this file")->type_name("FILE");
    app.add_flag("--quiet", options.quiet, "print nothing but errors");
    app.set_version_flag("--version", "cleave " CLEAVE_VERSION, "print the version and end");
}

void addMachine(CLI::App& app, Options& options) {
    app.add_option("--device", options.device, "Vulkan device, by index or a part of its name (see: cleave devices)")
        ->type_name("NAME|INDEX");
    addWhole(app, "--threads", "threads of CPU work (2)", options.settings.threads, 1, 1024);
}

void addBuild(CLI::App& app, Options& options, bool several) {
    BuildSettings& settings = options.settings;
    addBuilders(app, options, several);
    addMachine(app, options);
    addParsed<uint64_t>(
        app, "--memory", "SIZE", "bytes that a build may use, for example 512M or 2G", parseBytes,
        [&settings](uint64_t bytes) { settings.memory = bytes; }, "a size, for example 512M or 2G");
    addHeuristic(app, settings);
    addWhole(app, "--bins",
             "bins per axis (" + std::to_string(kBins) + "; shevtsov up to " + std::to_string(kMostBins) + ")",
             settings.bins, 2, kMostBins);
    addNamed(app, "--subsample", "bin every l-th reference of large nodes, l = max(1, floor(log10 n))",
             settings.subsample, kSwitch);
    addNamed(app, "--snap", "move sampled and binned planes to a face of a box beside them", settings.snap, kSwitch);
    addNamed(app, "--other-axes", "hunt-one: try the other axes where the longest has no split", settings.otherAxes,
             kSwitch);
    addNamed(app, "--small-nodes", "exact, exact-nlog2n: how planes of nodes of up to 64 references are found",
             settings.smallNodes, kSmallNodes);
    addWhole(app, "--exact-up-to",
             "exact SAH in nodes of at most so many references (" + std::to_string(kExactUpTo) + ")",
             settings.exactUpTo, 0, kMostExactUpTo);
    addWhole(app, "--max-depth", "deepest leaf (by the number of triangles)", settings.maxDepth, 1, kMaxDepth);
    addWhole(app, "--leaf-size", "medians: no split of nodes with at most so many references (4)", settings.leafSize, 1,
             1u << 20);
    addNamed(app, "--axes", "medians: axes that a node is cut along", settings.axes, kAxes);
    addNamed(app, "--clip", "clip triangles to the cells", settings.clip, kSwitch);
}

void addTraversal(CLI::App& app, Options& options, bool several) {
    addNames(app, "--traversal", "how rays go (stack)", options.traversals, kTraversals, several);
    addNames(app, "--triangle-test", "how hits are decided", options.triangleTests, kTriangleTests, several);
    addWhole(app, "--check", "judge so many of the rays by the reference", options.check, 1, uint64_t{1} << 32);
}

// One scene. (A list limited to one would take the next argument too, and complain.)
void addScene(CLI::App& app, Options& options, const std::string& text, bool needed) {
    const auto read = [&options](const std::string& given) { options.scenes = {given}; };
    app.add_option_function<std::string>("SCENE", read, text)->type_name("FILE")->required(needed);
}

CLI::Option* addTime(CLI::App& app, Options& options) {
    CLI::Option* time = addParsed<double>(
        app, "--time", "S", "the scene after so many seconds of its animation (its rest pose)", parseNumber,
        [&options](double seconds) { options.time = seconds; }, "a number of seconds");
    app.add_option("--animation", options.animation, "what is played: an animation of the scene, or all (the first)")
        ->type_name("NAME|INDEX");
    return time;
}

// After addBuild(): a saved tree has been built.
void addTree(CLI::App& app, Options& options) {
    app.add_option("--tree", options.tree, "walk a tree that info --save-tree kept, instead of building one")
        ->type_name("FILE")
        ->excludes("--builder");
}

// The parts of a range of frames, which are given in any order.
FrameRange& framesOf(Options& options) {
    if (!options.frames) options.frames.emplace();
    return *options.frames;
}

void addFrames(CLI::App& app, Options& options, CLI::Option* time) {
    using Pair = std::pair<uint64_t, uint64_t>;
    CLI::Option* frames = addParsed<Pair>(
        app, "--frames", "A:B", "a picture for each of the frames A to B: out_0001.png and so on", parseFrames,
        [&options](Pair range) { std::tie(framesOf(options).first, framesOf(options).last) = range; },
        "A:B, the first and the last frame, whole numbers from 0 on, A not above B");
    const auto rate = [](const std::string& given) {
        const auto fps = parseNumber(given);
        return fps && *fps > 0.0 ? fps : std::nullopt;
    };
    CLI::Option* fps = addParsed<double>(
        app, "--fps", "F", "frames per second: frame n shows the time n / F", rate,
        [&options](double f) { framesOf(options).fps = f; }, "a number above 0");
    CLI::Option* part = addParsed<Pair>(
        app, "--part", "I/N", "only the frames A + I, A + I + N, A + I + 2 N, ...", parsePart,
        [&options](Pair one) { std::tie(framesOf(options).part, framesOf(options).parts) = one; },
        "I/N, two whole numbers with I from 0 to N - 1");
    CLI::Option* skip = app.add_flag_callback(
        "--skip-existing", [&options] { framesOf(options).skipExisting = true; },
        "leave frames out whose pictures are there");
    frames->needs(fps)->excludes(time);
    for (CLI::Option* option : {fps, part, skip}) option->needs(frames);
}

void addRender(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb; a scene of ours where left out", false);
    app.add_option("-o,--output", options.output, "the picture (out.png)")->type_name("FILE");
    addParsed<glm::uvec2>(
        app, "--size", "WxH", "pixels (1280x720)", parseSize,
        [&options](glm::uvec2 size) {
            options.width = size.x;
            options.height = size.y;
        },
        "WIDTHxHEIGHT, sides up to 16384 and up to 2^26 pixels, for example 1280x720");
    app.add_option("--camera", options.camera, "a camera of the scene (the first)")->type_name("NAME|INDEX");
    const std::string point = "x,y,z, three finite numbers";
    addParsed<glm::dvec3>(
        app, "--eye", "X,Y,Z", "look from here", parsePoint, [&options](glm::dvec3 p) { options.eye = p; }, point);
    addParsed<glm::dvec3>(
        app, "--look", "X,Y,Z", "look at this point", parsePoint, [&options](glm::dvec3 p) { options.look = p; },
        point);
    const auto field = [](const std::string& text) {
        const auto degrees = parseNumber(text);
        return degrees && *degrees > 0.0 && *degrees < 180.0 ? degrees : std::nullopt;
    };
    addParsed<double>(
        app, "--fov", "DEGREES", "vertical field of view (45, or the camera's)", field,
        [&options](double degrees) { options.fov = degrees; }, "an angle above 0 and below 180 degrees");
    addNamed(app, "--view", "what is shown", options.view, kViews);
    const auto samples = [](const std::string& given) { return parseWhole(given, 1, 1u << 24); };
    addParsed<uint64_t>(
        app, "--spp", "N", "samples per pixel of shaded, normals (1) and path (64)", samples,
        [&options](uint64_t n) { options.samples = static_cast<uint32_t>(n); }, "a whole number from 1 to 16777216");
    addWhole(app, "--bounces", "path: surfaces that light may be reflected by (8)", options.bounces, 0, 4096);
    const auto stops = [](const std::string& given) {
        const auto ev = parseNumber(given);
        return ev && std::abs(*ev) <= 64.0 ? ev : std::nullopt;
    };
    addParsed<double>(
        app, "--exposure", "EV", "shaded, path: brighter by so many powers of two (0)", stops,
        [&options](double ev) { options.exposure = static_cast<float>(std::exp2(ev)); }, "a number from -64 to 64");
    const auto seconds = [](const std::string& given) {
        const auto s = parseNumber(given);
        return s && *s > 0.0 ? s : std::nullopt;
    };
    addParsed<double>(
        app, "--time-limit", "S", "take no more samples (of a frame) after so many seconds", seconds,
        [&options](double s) { options.timeLimit = s; }, "a number of seconds above 0");
    addFrames(app, options, addTime(app, options));
    addBuild(app, options, false);
    addTree(app, options);
    app.get_option("--tree")->excludes("--frames");
    addTraversal(app, options, false);
    addOutput(app, options);
}

constexpr uint64_t kMostHitsPerRay = 1u << 20;

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
    addTraversal(app, options, false);
    CLI::Option* const own[] = {any, all, count};
    for (CLI::Option* one : own)
        for (CLI::Option* other : own)
            if (one != other) one->excludes(other);
    for (const char* fixed : {"--traversal", "--triangle-test", "--check"}) {
        all->excludes(fixed);
        count->excludes(fixed);
    }
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
    addOutput(app, options);
}

void addInfo(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb", true);
    app.add_flag("--validate", options.validate, "check the tree against its triangles");
    addTime(app, options);
    addBuild(app, options, false);
    addTree(app, options);
    app.add_option("--save-tree", options.saveTree, "keep the tree in this file, for --tree")->type_name("FILE");
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
    for (const char* other : {"--traversal", "--triangle-test", "--peers", "--work", "--check"})
        queries->excludes(other);
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

std::unique_ptr<CLI::App> makeApp(Options& options) {
    auto app =
        std::make_unique<CLI::App>("cleave: ray queries on any Vulkan device, through kd-trees built there", "cleave");
    app->set_version_flag("--version", "cleave " CLEAVE_VERSION, "print the version and end");
    app->require_subcommand(1);
    addRender(*app->add_subcommand("render", "make a picture of a scene"), options);
    addTrace(*app->add_subcommand("trace", "answer the rays of a file"), options);
    addQuery(*app->add_subcommand("query", "ask about the points or boxes of a file"), options);
    addInfo(*app->add_subcommand("info", "describe a scene and its tree"), options);
    addBench(*app->add_subcommand("bench", "time builds and rays, after checking them"), options);
    addReport(*app->add_subcommand("report", "error against run time, as one page"), options);
    addStability(
        *app->add_subcommand("stability", "look for wrong answers: stiff cases, all builders, all kinds of rays"),
        options);
    addOutput(*app->add_subcommand("devices", "list what Vulkan offers here and what would be used"), options);
    return app;
}

std::string optionsOf(const CLI::App& command) {
    std::string names;
    for (const CLI::Option* option : command.get_options())
        if (option->nonpositional()) names += (names.empty() ? "" : ", ") + option->get_name();
    return names;
}

// Looked up before CLI11 does, whose message would not name what there is.
Command commandOf(const std::string& name) {
    for (const auto& [known, command] : kCommands)
        if (name == known) return command;
    throw UsageError("'" + name + "' is no command; there are: " + namesIn(kCommands));
}

const char* defaultOutput(Command command) {
    if (command == Command::trace) return "hits.npy";
    if (command == Command::query) return "out.npy";
    return command == Command::report ? "report" : "out.png";
}

void complete(Options& options) {
    if (samplesOf(options) > 1 && !takesSamples(options.view))
        throw UsageError(
            "--spp: a pixel of depth, steps and leaves shows one ray; several are for shaded, normals, path");
    if (options.output.empty()) options.output = defaultOutput(options.command);
    for (size_t i = 0; options.command == Command::report && i < options.scenes.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (options.scenes[i].lexically_normal() == options.scenes[j].lexically_normal())
                throw UsageError("SCENE: '" + options.scenes[i].string() + "' is given twice");
    const auto hasFewBins = [](Builder builder) { return builder == Builder::gpu || builder == Builder::twin; };
    if (options.settings.bins > kBins &&
        (options.builders.empty() || std::any_of(options.builders.begin(), options.builders.end(), hasFewBins)))
        throw UsageError("--bins: gpu and twin have at most " + std::to_string(kBins) + "; for " +
                         std::to_string(options.settings.bins) + " name another --builder");
    const bool writes =
        options.command == Command::render || options.command == Command::trace || options.command == Command::query;
    if (writes && options.json && options.json->lexically_normal() == options.output.lexically_normal())
        throw UsageError("--json and -o name the same file");
    if (options.frames && !std::isfinite(static_cast<double>(options.frames->last) / options.frames->fps))
        throw UsageError("--fps: at so few frames per second the time of the last frame is no finite number");
    if (options.frames && options.json && isFrameFile(options.output, *options.json))
        throw UsageError("--json: '" + options.json->string() + "' is what a frame is called; choose another name");
}

constexpr uint32_t kQuickRuns = 2;

// To be typed again in a shell; the program by its name.
std::string lineOf(int argc, const char* const* argv) {
    std::string line = "cleave";
    for (const std::string_view word : std::span(argv + 1, static_cast<size_t>(argc - 1))) {
        const bool plain = !word.empty() && word.find_first_not_of(
                                                "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                "0123456789-_=+,./:@%") == std::string_view::npos;
        line += plain ? " " + std::string(word) : " '";
        if (plain) continue;
        for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
        line += "'";
    }
    return line;
}

}  // namespace

uint32_t samplesOf(const Options& options) { return options.samples.value_or(options.view == View::path ? 64 : 1); }

uint64_t raysToJudge(const Options& options) { return options.check > 0 ? options.check : 2048; }

Request parseCommandLine(int argc, const char* const* argv) {
    const std::string first = argc > 1 ? argv[1] : "";
    if (argc < 2) throw UsageError("no command; there are: " + namesIn(kCommands) + " (see: cleave --help)");
    Options options;
    const std::unique_ptr<CLI::App> app = makeApp(options);
    if (!first.starts_with("-")) options.command = commandOf(first);
    try {
        app->parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return app->help();
    } catch (const CLI::CallForAllHelp&) {
        return app->help();
    } catch (const CLI::CallForVersion& version) {
        return std::string(version.what()) + "\n";
    } catch (const CLI::ExtrasError& error) {
        const CLI::App* command = first.starts_with("-") ? app.get() : app->get_subcommand(first);
        throw UsageError(std::string(error.what()) + "; there is: " + optionsOf(*command));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see: cleave " + (first.starts_with("-") ? "" : first + " ") +
                         "--help)");
    }
    if (options.command == Command::stability && app->get_subcommand("stability")->count("--builder") == 0)
        options.builders.clear();
    if (options.command == Command::report && options.quick && app->get_subcommand("report")->count("--runs") == 0)
        options.runs = kQuickRuns;
    options.line = lineOf(argc, argv);
    complete(options);
    return options;
}

}  // namespace cleave
