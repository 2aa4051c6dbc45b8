#include "app/session.h"

#include "app/text.h"
#include "error.h"
#include "kdtree/builder_names.h"
#include "scene/camera.h"
#include "twin/twin_builder.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

// The timed part is from triangles in memory to a KdTree.
void buildOnHost(BuiltTree& built, const TriangleSet& set, const BuildSettings& settings) {
    BuildReport report;
    const Stopwatch watch;
    if (built.builder == Builder::twin) {
        TwinResult result = buildTwin(set, settings);
        built.tree = std::move(result.tree);
        built.memoryLimited = result.memoryLimited;
        report.peakBytes = result.peakBytes;
    } else {
        built.tree = cpuBuilder(built.builder.name).build(set, settings, &report);
    }
    built.runs.push_back(watch.milliseconds());
    built.peakBytes = report.peakBytes;
}

}  // namespace

Session::Session(Run& run, const fs::path& file) : run_(run) {
    run_.progress.phase("loading " + oneLine(file.filename().string()));
    scene_ = loadGltf(file);
    posed_ = pose(scene_);
    for (const auto& warnings : {scene_.warnings, posed_.warnings})
        for (const std::string& warning : warnings) run_.warn(warning);
    set_ = makeTriangleSet(posed_.triangles);
    bounds_ = finiteBounds(posed_.triangles);
    run_.progress.clear();
}

std::shared_ptr<DeviceTriangles> Session::trianglesOnDevice() {
    if (!onDevice_) onDevice_ = uploadTriangles(run_.device.context(), set_);
    return onDevice_;
}

void Session::buildOnDevice(BuiltTree& built) {
    built.onDevice.reset();  // a second run must not need room for two trees
    GpuBuilder::Result result = run_.device.builder().build(trianglesOnDevice(), run_.options.settings);
    built.onDevice = std::move(result.tree);
    built.runs.push_back(result.ms);
    built.peakBytes = result.peakBytes;
    built.memoryLimited = result.memoryLimited;
}

BuiltTree Session::build(Builder builder, uint32_t runs) {
    BuiltTree built;
    built.builder = builder;
    if (builder == Builder::gpu) {
        run_.progress.phase("preparing the device");
        run_.device.builder();
        built.setupMs = run_.device.builderSetupMilliseconds();
    }
    run_.progress.phase("building (" + nameOf(builder) + ")");
    for (uint32_t i = 0; i < runs; ++i) {
        if (builder == Builder::gpu)
            buildOnDevice(built);
        else
            buildOnHost(built, set_, run_.options.settings);
    }
    if (built.onDevice) built.tree = readBack(run_.device.context(), *built.onDevice);
    built.ms = medianOf(built.runs);
    built.statistics = computeStatistics(built.tree);
    built.hash = treeHash(built.tree);
    run_.progress.clear();
    return built;
}

void Session::profile(BuiltTree& built) {
    if (built.builder != Builder::gpu) return;
    built.kernels = run_.device.builder().profile(*trianglesOnDevice(), run_.options.settings);
}

const DeviceTree& Session::upload(BuiltTree& built) {
    if (!built.onDevice) built.onDevice = uploadTree(run_.device.context(), trianglesOnDevice(), built.tree);
    return *built.onDevice;
}

CheckResult Session::check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count) {
    run_.progress.phase("checking");
    if (!reference_) reference_ = std::make_unique<Reference>(posed_.triangles, set_.included);
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

void requireAnswered(const Tracer::Result& traced, const CheckResult& check, const std::string& what) {
    if (traced.cappedRays > 0)
        throw Error("tracing " + what + ": " + grouped(traced.cappedRays) +
                    " rays were given up at the step cap; please report this scene");
    if (check.mismatches > 0)
        throw Error("check of " + what + ": " + grouped(check.mismatches) + " of " + grouped(check.rays) +
                    " rays are answered wrongly, first: " + check.first + "; please report this scene");
}

std::string builtLine(const BuiltTree& built) {
    return "build     " + fixed(built.ms, 3) + " ms (" + nameOf(built.builder) + "), SAH cost " +
           fixed(built.statistics.sahCost, 2) + ", " + grouped(built.statistics.nodes) + " nodes\n";
}

std::string tracedLine(uint64_t rays, const Tracer::Result& traced) {
    const std::string invalid = traced.invalidRays > 0 ? ", " + grouped(traced.invalidRays) + " invalid" : "";
    return "trace     " + fixed(traced.ms, 3) + " ms, " + grouped(rays) + " rays" + invalid + ", " +
           fixed(mraysPerSecond(rays, traced.ms), 2) + " Mrays/s\n";
}

std::string checkedLine(const CheckResult& check) {
    return "check     " + grouped(check.rays) + " rays, " + grouped(check.mismatches) + " wrong, " +
           grouped(check.undecided) + " undecided\n";
}

}  // namespace cleave
