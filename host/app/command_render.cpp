#include <glm/gtc/constants.hpp>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/lighting.h"
#include "app/report.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/legend.h"
#include "formats/exr.h"
#include "formats/png.h"
#include "formats/write_file.h"
#include "scene/camera.h"

namespace cleave {
namespace {

Camera cameraOf(const Session& session, const Options& options) {
    const Box bounds = session.worldBounds();
    ViewOverrides overrides{options.eye, options.look, std::nullopt};
    if (options.fov) overrides.verticalFov = glm::radians(*options.fov);
    return overridden(chooseCamera(session.posed(), bounds, options.camera), bounds, overrides);
}

PictureRequest requestOf(Run& run, const Session& session) {
    const Options& options = run.options;
    PictureRequest request;
    request.camera = imageCamera(cameraOf(session, options), options.width, options.height, infinity());
    request.view = options.view;
    request.samples = samplesOf(options);
    request.bounces = options.bounces;
    request.exposure = options.exposure;
    if (options.view == View::path) request.lighting = lightingOf(session.scene(), session.posed());
    request.traversal = run.traversal();
    request.test = options.triangleTests.front();
    return request;
}

// Says after each sample how far a picture is, and whether it goes on: Ctrl-C and --time-limit end it with the samples
// that it has.
class SampleWatch {
  public:
    SampleWatch(Run& run, uint32_t samples) : run_(run), samples_(samples) {}

    bool goesOn(uint32_t taken) {
        const double seconds = watch_.milliseconds() / 1000.0;
        timedOut_ = run_.options.timeLimit && seconds >= *run_.options.timeLimit;
        const double left = seconds / taken * (samples_ - taken);
        run_.progress.phase("rendering, sample " + std::to_string(taken) + " of " + std::to_string(samples_) + ", " +
                            fixed(left, left < 10.0 ? 1 : 0) + " s left");
        return !timedOut_ && !interrupt_.happened();
    }
    bool wasInterrupted() const { return interrupt_.happened() && !timedOut_; }

  private:
    Run& run_;
    uint32_t samples_;
    Stopwatch watch_;
    Interrupt interrupt_;
    bool timedOut_ = false;
};

bool isExr(const std::filesystem::path& file) { return file.extension() == ".exr"; }

// The primary rays of a path are gone by the end, and rays that look through something have other hits than the
// reference finds: those through the pixels' centres are judged in their place, by which every triangle is seen.
CheckResult checked(Run& run, Session& session, const BuiltTree& built, const DeviceSurfaces& surfaces,
                    const PictureRequest& request) {
    Renderer& renderer = run.device.renderer();
    if (showsSurfaces(request.view)) {
        PictureRequest primary = request;
        primary.view = View::normals;
        primary.samples = 1;
        primary.goesOn = nullptr;
        renderer.render(*built.onDevice, session.trianglesOnDevice(), surfaces, primary);
    }
    return session.check(renderer.readRays(), renderer.readHits(), Query::closest, run.options.check);
}

}  // namespace

void runRender(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    const Detail detail = showsSurfaces(options.view) ? Detail::corners : Detail::triangles;
    Session session(run, options.scenes.empty() ? defaultScene() : options.scenes.front(), detail);
    const DeviceSurfaces surfaces = session.surfacesOnDevice(options.view);
    BuiltTree built = session.build(options.builders.front());
    const DeviceTree& tree = session.upload(built);
    const DeviceTriangles& triangles = session.trianglesOnDevice();
    run.progress.phase("rendering");
    Renderer& renderer = run.device.renderer();
    run.device.device().transfers = {};
    PictureRequest request = requestOf(run, session);
    SampleWatch watch(run, request.samples);
    request.goesOn = [&](uint32_t taken) { return watch.goesOn(taken); };
    Picture picture = renderer.render(tree, triangles, surfaces, request);
    run.progress.clear();
    const uint64_t rays = uint64_t{options.width} * options.height * picture.samples;
    if (options.view == View::steps || options.view == View::leaves) drawLegend(picture);

    // The picture is written even if the check fails, so that it can be inspected.
    writeFile(options.output, isExr(options.output) ? exrOf(picture.width, picture.height, renderer.readRadiance())
                                                    : pngOf(picture.width, picture.height, picture.pixels));
    Json report{{"scene", sceneJson(session)},
                {"build", buildJson(built)},
                {"trace", traceJson(request.traversal, request.test, rays, picture.traceMs, picture.invalidRays,
                                    picture.cappedRays)},
                {"render", {{"ms", numberJson(picture.ms)}, {"samples", picture.samples}}}};
    report["build"]["setupMs"] = numberJson(run.device.setupMilliseconds());
    CheckResult check;
    if (options.check > 0) {
        check = checked(run, session, built, surfaces, request);
        report["check"] = checkJson(check);
    }
    writeReport(run, report);
    requireAnswered(picture.cappedRays, check, session.scene().name);

    run.print(builtLine(built) + tracedLine(rays, picture.traceMs, picture.invalidRays) +
              (options.check > 0 ? checkedLine(check) : "") + "picture   " + options.output.string() +
              (request.samples > 1 ? ", " + std::to_string(picture.samples) + " samples per pixel" : "") + "\n");
    if (watch.wasInterrupted() && picture.samples < request.samples)
        throw Error("interrupted after " + std::to_string(picture.samples) + " of " + std::to_string(request.samples) +
                    " samples; " + options.output.string() + " has these");
}

}  // namespace cleave
