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
    return overridden(chooseCamera(session.scene(), bounds, options.camera), bounds, overrides);
}

}  // namespace

void runRender(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    Session session(run, options.scenes.empty() ? defaultScene() : options.scenes.front());
    const std::vector<Ray> rays = cameraRays(cameraOf(session, options), options.width, options.height);
    BuiltTree built = session.build(options.builders.front());
    const DeviceTree& tree = session.upload(built);
    run.progress.phase("rendering");
    Picture picture = run.device.renderer().render(tree, session.scene(), rays, options.width, options.height,
                                                   options.view, traceMode(options));
    if (options.view == View::steps || options.view == View::leaves) drawLegend(picture);

    // The picture is written even if the check fails, so that it can be inspected.
    writeFile(options.output, pngOf(picture.width, picture.height, picture.pixels));
    const Tracer::Result& primary = picture.primary;
    Json report{{"scene", sceneJson(session)},
                {"build", buildJson(built)},
                {"trace", traceJson(options.traversals.front(), options.triangleTests.front(), rays.size(), primary.ms,
                                    primary.invalidRays, primary.cappedRays)},
                {"render", {{"ms", numberJson(picture.ms)}}}};
    CheckResult check;
    if (options.check > 0) {
        check = session.check(rays, primary.hits, Query::closest, options.check);
        report["check"] = checkJson(check);
    }
    writeReport(run, report);
    requireAnswered(primary, check, session.scene().name);

    run.print(builtLine(built) + tracedLine(rays.size(), primary) + (options.check > 0 ? checkedLine(check) : "") +
              "picture   " + options.output.string() + "\n");
}

}  // namespace cleave
