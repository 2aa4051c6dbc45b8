#include <cmath>
#include <tuple>

#include "app/build_options.h"
#include "app/command_options.h"
#include "app/option_kinds.h"
#include "app/run_options.h"

namespace cleave {
namespace {

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

// What a picture shows.
void addPicture(CLI::App& app, Options& options) {
    addScene(app, options, ".gltf or .glb; a scene of ours where left out", false);
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
        app, "--spp", "N",
        "samples per pixel of shaded (1; several: soft shadows, dark corners), normals (1), path (64)", samples,
        [&options](uint64_t n) { options.samples = static_cast<uint32_t>(n); }, "a whole number from 1 to 16777216");
    addWhole(app, "--bounces", "path: surfaces that light may be reflected by (8)", options.bounces, 0, 4096);
    const auto stops = [](const std::string& given) {
        const auto ev = parseNumber(given);
        return ev && std::abs(*ev) <= 64.0 ? ev : std::nullopt;
    };
    addParsed<double>(
        app, "--exposure", "EV", "shaded, path: brighter by so many powers of two (0)", stops,
        [&options](double ev) { options.exposure = static_cast<float>(std::exp2(ev)); }, "a number from -64 to 64");
}

}  // namespace

void addRender(CLI::App& app, Options& options) {
    addPicture(app, options);
    app.add_option("-o,--output", options.output, "the picture (out.png)")->type_name("FILE");
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
    addSplitMoving(app, options);
    addDevicePose(app, options);
    addTraversal(app, options, false);
    addInstances(app, options);
    addLazy(app, options);
    addKeepAll(app, options);
    addOutput(app, options);
}

void addView(CLI::App& app, Options& options) {
    addPicture(app, options);
    const auto read = [&options](const std::string& given) { options.script = given; };
    app.add_option_function<std::string>("--script", read, "steps that drive the window, a line each")
        ->type_name("FILE");
    addTime(app, options);
    addBuild(app, options, false);
    addNames(app, "--traversal", "how rays go (stack)", options.traversals, kTraversals, false);
    addNames(app, "--triangle-test", "how hits are decided", options.triangleTests, kTriangleTests, false);
    addOutput(app, options);
}

}  // namespace cleave
