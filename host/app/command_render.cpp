#include <glm/gtc/constants.hpp>

#include "app/commands.h"
#include "app/report.h"
#include "base/text.h"
#include "figures/legend.h"
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
    request.traversal = run.traversal();
    request.test = options.triangleTests.front();
    return request;
}

}  // namespace

void runRender(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    Session session(run, options.scenes.empty() ? defaultScene() : options.scenes.front());
    const DeviceMaterials& materials = session.materialsOnDevice();
    BuiltTree built = session.build(options.builders.front());
    const DeviceTree& tree = session.upload(built);
    const DeviceTriangles& triangles = session.trianglesOnDevice();
    run.progress.phase("rendering");
    Renderer& renderer = run.device.renderer();
    run.device.device().transfers = {};
    const PictureRequest request = requestOf(run, session);
    Picture picture = renderer.render(tree, triangles, materials, request);
    const uint64_t rays = uint64_t{options.width} * options.height;
    if (options.view == View::steps || options.view == View::leaves) drawLegend(picture);

    // The picture is written even if the check fails, so that it can be inspected.
    writeFile(options.output, pngOf(picture.width, picture.height, picture.pixels));
    Json report{{"scene", sceneJson(session)},
                {"build", buildJson(built)},
                {"trace", traceJson(request.traversal, request.test, rays, picture.traceMs, picture.invalidRays,
                                    picture.cappedRays)},
                {"render", {{"ms", numberJson(picture.ms)}}}};
    report["build"]["setupMs"] = numberJson(run.device.setupMilliseconds());
    CheckResult check;
    if (options.check > 0) {
        check = session.check(renderer.readRays(), renderer.readHits(), Query::closest, options.check);
        report["check"] = checkJson(check);
    }
    writeReport(run, report);
    requireAnswered(picture.cappedRays, check, session.scene().name);

    run.print(builtLine(built) + tracedLine(rays, picture.traceMs, picture.invalidRays) +
              (options.check > 0 ? checkedLine(check) : "") + "picture   " + options.output.string() + "\n");
}

}  // namespace cleave
