#include "app/run_options.h"

#include "app/option_kinds.h"

namespace cleave {
namespace {

constexpr std::array<std::pair<const char*, Choice>, 3> kChoices = {
    {{"auto", Choice::automatic}, {"on", Choice::on}, {"off", Choice::off}}};

}  // namespace

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

void addMachine(CLI::App& app, Options& options) {
    app.add_option("--device", options.device, "Vulkan device, by index or a part of its name (see: cleave devices)")
        ->type_name("NAME|INDEX");
    addWhole(app, "--threads", "threads of CPU work (2)", options.settings.threads, 1, 1024);
}

void addTree(CLI::App& app, Options& options) {
    app.add_option("--tree", options.tree, "walk a tree that info --save-tree kept, instead of building one")
        ->type_name("FILE")
        ->excludes("--builder");
}

void addSplitMoving(CLI::App& app, Options& options) {
    addNamed(app, "--split-moving", "a tree of its own for what moves, so that the rest is built once",
             options.splitMoving, kChoices);
    app.get_option("--tree")->excludes("--split-moving");
}

void addDevicePose(CLI::App& app, Options& options) {
    addNamed(app, "--device-pose", "what moves is posed on the device; auto: where that pays", options.devicePose,
             kChoices);
    app.get_option("--device-pose")->needs("--frames");
}

void addInstances(CLI::App& app, Options& options) {
    addNamed(app, "--instances", "one tree for a mesh that stands in many places; auto: where it saves memory",
             options.instances, kChoices);
}

void addLazy(CLI::App& app, Options& options) {
    addNamed(app, "--lazy", "build what rays come to, while they wait; auto: where that saves time", options.lazy,
             kChoices);
}

void addKeepAll(CLI::App& app, Options& options) {
    app.add_flag_callback(
        "--keep-all", [&options] { options.keep.set(); }, "leave nothing out that the scene has no need of");
}

void addTraversal(CLI::App& app, Options& options, bool several) {
    addNames(app, "--traversal", "how rays go (stack)", options.traversals, kTraversals, several);
    addNames(app, "--triangle-test", "how hits are decided", options.triangleTests, kTriangleTests, several);
    addWhole(app, "--check", "judge so many of the rays by the reference", options.check, 1, uint64_t{1} << 32);
}

void addOutput(CLI::App& app, Options& options) {
    app.add_option("--json", options.json, "write all figures to this file")->type_name("FILE");
    app.add_flag("--quiet", options.quiet, "print nothing but errors");
    app.set_version_flag("--version", "cleave " CLEAVE_VERSION, "print the version and end");
}

}  // namespace cleave
