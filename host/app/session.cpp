#include "app/session.h"

#include <algorithm>

#include "app/saved_tree.h"
#include "app/surfaces.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "base/warm_up.h"
#include "facade/host_builders.h"
#include "figures/timing.h"
#include "run/device_builders.h"
#include "scene/animation.h"
#include "scene/camera.h"
#include "scene/pose_again.h"
#include "scene/pose_tables.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

// Of device memory, for posing; before it is there, it is on the host.
constexpr uint64_t kMostPoseBytes = uint64_t{256} << 20;

// Where fewer triangles move the host has posed and uploaded them before a device has begun.
constexpr uint64_t kFewestToPose = 2048;

// Devices that are the CPU do not pose faster than the host does: see docs/motion.md.
bool paysOnDevice(uint64_t triangles, const Device& device) {
    return triangles >= kFewestToPose && device.properties().deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU;
}

// The timed part is from triangles in memory to a KdTree.
void buildOver(const TriangleSet& set, BuiltTree& built, const BuildSettings& settings) {
    const Stopwatch watch;
    BuildOutcome outcome = hostBuilder(built.builder.name).build(set, settings);
    built.runs.push_back(watch.milliseconds());
    built.tree = std::move(outcome.tree);
    built.peakBytes = outcome.peakBytes;
    built.memoryLimited = outcome.memoryLimited;
}

}  // namespace

ReadScene readScene(Run& run, const fs::path& file) {
    const NeedSet& keep = run.options.keep;
    const bool readsAll = (keep & (only(Need::unusedMeshes) | only(Need::unusedBuffers))).any();
    run.progress.phase("loading " + oneLine(file.filename().string()));
    const Stopwatch loading;
    Scene scene = loadGltf(file, readsAll ? Reading::everything : Reading::shown);
    return {std::move(scene), loading.milliseconds()};
}

std::vector<uint32_t> chosenAnimations(Run& run, const Scene& scene) {
    const Options& options = run.options;
    std::vector<uint32_t> chosen =
        options.animation == kAllAnimations ? allAnimations(scene) : chooseAnimation(scene, options.animation);
    if (chosen.empty() && (options.time || options.frames))
        run.warn("'" + scene.name + "' has no animation: it is the same at all times");
    if (!options.animation.empty() && !options.time && !options.frames)
        run.warn("--animation: the rest pose is shown, as no time is given");
    return chosen;
}

Session::Session(Run& run, ReadScene loaded, Detail detail)
    : run_(run),
      settings_(run.options.settings),
      needs_(run.options.keep),
      detail_(detail),
      scene_(std::move(loaded.scene)),
      loadMs_(loaded.ms) {
    const Options& options = run.options;
    for (const Need need : {Need::xAxis, Need::yAxis, Need::zAxis, Need::largeNodes})
        settings_.everything = settings_.everything || needs_.keeps(need);
    warnOnce(scene_.warnings);
    animations_ = chosenAnimations(run, scene_);
    if (options.time) {
        poseAt(*options.time);
    } else {
        poseScene({});
        restBounds_ = worldBounds();
    }
    const bool played = (options.time || options.frames) && !animations_.empty();
    if (!played && needs_.keeps(Need::animation)) readUnplayed();
    findInScene(needs_, scene_, worldBounds(), played);
}

// Their keys, for nothing.
void Session::readUnplayed() const {
    std::vector<NodeState> states = restStates(scene_);
    Warnings ignored;
    animate(scene_, {0.0, allAnimations(scene_)}, states, ignored);
}

Builder Session::chosenBuilder(bool showsTree) {
    const Builder named = run_.options.builders.front();
    if (run_.options.tree) return named;
    if (isOnDevice(named.name))
        findInBuild(needs_, set(), settings_.exactUpTo, !run_.options.namesBuilder && !showsTree);
    return needs_.isLeftOut(Need::tree) ? Builder::brute : named;
}

void Session::poseAt(double seconds) {
    if (isPlaying_) return poseWhatMoves({seconds, animations_});
    poseScene({seconds, animations_});
    isPlaying_ = true;
    moving_ = runsThat(true, posed_, movingNodes());
}

void Session::poseScene(const PoseTime& time) {
    forgetPose();
    onDevice_.reset();
    posed_ = {};  // two poses need not be in memory together
    const Stopwatch watch;
    posed_ = pose(scene_, time, kMostTriangles, detail_);
    poseMs_ = watch.milliseconds();
    warnOnce(posed_.warnings);
    run_.progress.clear();
}

const PosedScene& Session::posed() const {
    if (later_) poseAgain(posed_, scene_, *std::exchange(later_, std::nullopt), movingNodes_, detail_);
    return posed_;
}

void Session::mayPoseOnDevice(bool always) {
    mayPoseOnDevice_ = detail_ == Detail::triangles;
    alwaysPoseOnDevice_ = always;
}

// Makes what the device poses by; false where the host shall.
bool Session::preparePose() {
    if (pose_) return true;
    if (!std::exchange(mayPoseOnDevice_, false) || !onDevice_) return false;
    Device& device = run_.device.device();
    if (!alwaysPoseOnDevice_ && !paysOnDevice(countMoving(posed_, movingNodes()), device)) return false;
    const uint64_t asked = run_.options.settings.memory;
    const uint64_t most = asked == 0 ? kMostPoseBytes : std::min(asked, kMostPoseBytes);
    const auto tables = poseTables(scene_, posed_, movingNodes(), most);
    if (!tables) return false;
    run_.device.poser();
    pose_ = std::make_unique<DevicePose>(
        device, PoseArrays{tables->parts, tables->positions, tables->morphs, tables->deltas, tables->influences,
                           tables->corners, tables->numbers, tables->vertices});
    return true;
}

void Session::poseOnDevice(const PoseTime& time) {
    const Stopwatch watch;
    PosedScene rest = posePart(scene_, time, std::vector<bool>(scene_.nodes.size()));
    const PoseMotion motion = poseMotion(scene_, time, movingNodes());
    run_.device.poser().pose(*pose_, motion.maps, motion.weights, *onDevice_);
    later_ = time;
    posed_.cameras = std::move(rest.cameras);
    posed_.lights = std::move(rest.lights);
    isPosedAgain_ = true;
    poseMs_ = watch.milliseconds();
    warnOnce(rest.warnings);
    run_.progress.clear();
}

// Trees tell of triangles that the host has not seen.
void Session::warnOfNonFinite(const TreeHeader& header) {
    if (header.nonFinite == 0 || !later_) return;
    warnOnce(posed().warnings);
}

void Session::poseWhatMoves(const PoseTime& time) {
    forgetPose();
    if (preparePose()) return poseOnDevice(time);
    const Stopwatch watch;
    isPosedAgain_ = poseAgain(posed_, scene_, time, movingNodes(), detail_);
    poseMs_ = watch.milliseconds();
    warnOnce(posed_.warnings);
    if (!isPosedAgain_) {
        onDevice_.reset();
        moving_ = runsThat(true, posed_, movingNodes());
    } else if (onDevice_) {
        const Stopwatch uploading;
        for (const TriangleRun& run : moving_) onDevice_->move(posed_.triangles, run.first, run.count);
        uploadMs_ = uploading.milliseconds();
    }
    run_.progress.clear();
}

// What was found out of the pose before.
void Session::forgetPose() {
    later_.reset();
    reference_.reset();
    set_.reset();
    bounds_.reset();
    uploadMs_ = 0.0;
}

const TriangleSet& Session::set() const {
    if (!set_) set_ = makeTriangleSet(posed().triangles);
    return *set_;
}

const std::vector<bool>& Session::movingNodes() {
    if (movingNodes_.empty()) movingNodes_ = cleave::movingNodes(scene_, animations_);
    return movingNodes_;
}

const Box& Session::worldBounds() const {
    if (!bounds_) bounds_ = finiteBounds(posed().triangles);
    return *bounds_;
}

void Session::warnOnce(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        if (warned_.insert(warning).second) run_.warn(warning);
}

const Box& Session::restBounds() {
    if (!restBounds_) restBounds_ = finiteBounds(pose(scene_).triangles);
    return *restBounds_;
}

const DeviceTriangles& Session::trianglesOnDevice() {
    if (onDevice_) return *onDevice_;
    Device& device = run_.device.device();
    const Stopwatch uploading;
    onDevice_ = std::make_unique<DeviceTriangles>(device, posed().triangles);
    uploadMs_ = uploading.milliseconds();
    return *onDevice_;
}

DeviceSurfaces Session::surfacesOnDevice(View view) {
    run_.progress.phase("reading images");
    Device& device = run_.device.device();
    uint64_t most = device.largestAllocation();
    if (run_.options.settings.memory != 0) most = std::min(most, run_.options.settings.memory);
    const SurfaceData data = surfacesOf(
        scene_, posed(), view, most, [this](const std::string& warning) { run_.warn(warning); }, needs_);
    run_.progress.clear();
    return DeviceSurfaces(device, data);
}

void Session::moveSurfaces(DeviceSurfaces& surfaces) {
    if (!isPosedAgain_) return surfaces.move(run_.device.device(), posedSurfaces(posed(), needs_));
    if (detail_ == Detail::triangles) return;  // there is nothing that moves
    for (const TriangleRun& run : moving_) surfaces.move(run.first, posedSurfaces(posed(), run, needs_));
}

void Session::buildOnHost(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list) {
    if (list.empty()) return buildOver(set(), built, settings);
    const TriangleSet part = makeTriangleSet(trianglesOf(posed().triangles, list));
    buildOver(part, built, settings);
    built.onDevice = uploadTree(run_.device.device(), part, built.tree, list);
    for (uint32_t& triangle : built.tree.leafTriangles) triangle = list[triangle];
}

void Session::buildOnDevice(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list) {
    built.onDevice.reset();  // a second run must not need memory for two trees
    GpuBuilder::Result result =
        run_.device.builder().build(trianglesOnDevice(), settingsFor(built.builder.name, settings), list);
    built.onDevice = std::move(result.tree);
    warnOfNonFinite(built.onDevice->header);
    built.runs.push_back(result.ms);
    built.peakBytes = result.peakBytes;
    built.memoryLimited = result.memoryLimited;
    built.attempts = std::max(built.attempts, result.attempts);
}

BuiltTree Session::prepared(Builder builder) {
    BuiltTree built;
    built.builder = run_.options.tree ? Builder{"saved"} : builder;
    if (run_.options.tree) {
        run_.progress.phase("loading the tree");
        return built;
    }
    if (isOnDevice(builder.name)) {
        run_.progress.phase("preparing the device");
        run_.device.builder().prepare(settingsFor(builder.name, {}));
        built.setupMs = run_.device.builderSetupMilliseconds();
    }
    run_.progress.phase("building (" + nameOf(builder) + ")");
    return built;
}

void Session::loadSaved(BuiltTree& built) {
    const Stopwatch watch;
    built.tree = readTree(*run_.options.tree, posed().triangles, set());
    built.runs.push_back(watch.milliseconds());
}

void Session::buildOnce(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list) {
    if (run_.options.tree)
        loadSaved(built);
    else if (isOnDevice(built.builder.name))
        buildOnDevice(built, settings, list);
    else
        buildOnHost(built, settings, list);
}

void Session::finish(BuiltTree& built, const BuildSettings& settings) {
    if (isOnDevice(built.builder.name)) built.tree = readBack(*built.onDevice);
    tell(built, settings);
}

void Session::tell(BuiltTree& built, const BuildSettings& settings) {
    built.ms = medianOf(built.runs);
    built.statistics = computeStatistics(built.tree, settings.costs);
    built.hash = treeHash(built.tree);
    run_.progress.clear();
}

BuiltTree Session::buildPlain(Builder builder, std::span<const uint32_t> list) {
    BuiltTree built = prepared(builder);
    buildOnce(built, settings_, list);
    built.ms = medianOf(built.runs);
    run_.progress.clear();
    return built;
}

std::unique_ptr<LazyTree> Session::buildLazily() {
    run_.progress.phase("preparing the device");
    GpuBuilder& builder = run_.device.lazyBuilder();
    run_.progress.phase("building (gpu, lazily)");
    const DeviceTriangles& triangles = trianglesOnDevice();
    auto lazy = builder.buildLazily(triangles, settings_, kOpenUpTo);
    warnOfNonFinite(lazy->tree().header);
    run_.progress.clear();
    return lazy;
}

BuiltTree Session::figuresOf(const LazyTree& lazy) {
    BuiltTree built;
    built.builder = Builder::gpu;
    built.setupMs = run_.device.builderSetupMilliseconds();
    built.runs = {lazy.figures().ms};
    built.peakBytes = lazy.figures().peakBytes;
    built.memoryLimited = lazy.figures().memoryLimited;
    built.tree = readBack(lazy.tree());
    tell(built, settings_);
    return built;
}

BuiltTree Session::build(Builder builder, const BuildSettings& settings, std::span<const uint32_t> list) {
    BuiltTree built = prepared(builder);
    buildOnce(built, settings, list);
    finish(built, settings);
    return built;
}

void Session::buildRuns(BuiltTree& built, uint32_t runs, const BuildSettings& settings) {
    if (isOnDevice(built.builder.name)) warmUp([&] { buildOnce(built, settings); });
    built.runs.clear();
    for (uint32_t i = 0; i < runs; ++i) buildOnce(built, settings);
}

BuiltTree Session::buildTimed(Builder builder, uint32_t runs, const BuildSettings& settings) {
    BuiltTree built = prepared(builder);
    buildRuns(built, runs, settings);
    if (isOnDevice(builder.name))
        built.profile = run_.device.builder().profile(trianglesOnDevice(), settingsFor(builder.name, settings));
    finish(built, settings);
    return built;
}

std::vector<double> Session::timeBuilds(Builder builder, uint32_t runs, const BuildSettings& settings) {
    BuiltTree built = prepared(builder);
    buildRuns(built, runs, settings);
    run_.progress.clear();
    return built.runs;
}

const DeviceTree& Session::upload(BuiltTree& built) {
    if (!built.onDevice) built.onDevice = uploadTree(run_.device.device(), set(), built.tree);
    return *built.onDevice;
}

CheckResult Session::check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count) {
    run_.progress.phase("checking");
    if (!reference_) reference_ = std::make_unique<Reference>(posed().triangles, set().included);
    CheckResult result = cleave::check(*reference_, rays, hits, query, count, run_.options.settings.threads);
    run_.progress.clear();
    return result;
}

fs::path defaultScene() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share" / "cleave" / "scenes";
    for (const fs::path& folder : {fs::path(CLEAVE_SCENES), installed})
        if (fs::exists(folder / "default.glb", ignored)) return folder / "default.glb";
    throw Error("cannot find the default scene in " + std::string(CLEAVE_SCENES) + " or " + installed.string() +
                "; name a scene");
}

void requireAnswered(uint64_t cappedRays, const CheckResult& check, const std::string& what) {
    if (cappedRays > 0)
        throw Error("tracing " + what + ": " + grouped(cappedRays) +
                    " rays were given up at the step cap; please report this scene");
    if (check.mismatches > 0)
        throw Error("check of " + what + ": " + grouped(check.mismatches) + " of " + grouped(check.rays) +
                    " rays are answered wrongly, first: " + check.first + "; please report this scene");
}

}  // namespace cleave
