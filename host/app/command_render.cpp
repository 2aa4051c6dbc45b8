#include "app/commands.h"
#include "app/picture_of.h"
#include "app/render_instances.h"
#include "app/report.h"
#include "app/report_picture.h"
#include "app/scene_trees.h"
#include "base/error.h"
#include "figures/legend.h"
#include "formats/write_file.h"

namespace cleave {

void runRender(Run& run) {
    const Options& options = run.options;
    if (options.frames) return runFrames(run);
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    const Detail detail = showsSurfaces(options.view) ? Detail::corners : Detail::triangles;
    ReadScene loaded = readScene(run, options.scenes.empty() ? defaultScene() : options.scenes.front());
    if (const auto sharing = sharingFor(run, loaded.scene))
        return renderInstances(run, InstancedSession(run, std::move(loaded), *sharing));
    Session session(run, std::move(loaded), detail);
    const DeviceSurfaces surfaces = session.surfacesOnDevice(options.view);
    SceneTrees trees(options, session, {.showsTree = countsSteps(options.view), .rays = raysOf(options)});
    trees.build(false);
    const DeviceTriangles& triangles = session.trianglesOnDevice();
    run.progress.phase("rendering");
    Renderer& renderer = run.device.renderer();
    run.device.device().transfers = {};
    PictureRequest request = requestOf(run, session);
    const Interrupt interrupt;
    SampleWatch watch(run, request.samples, &interrupt);
    const Forest forest = trees.forest(request.camera.eye);
    request.goesOn = [&](uint32_t taken) { return watch.goesOn(taken); };
    Picture picture = renderer.render(forest, triangles, surfaces, request);
    run.progress.clear();
    if (countsSteps(options.view)) drawLegend(picture);

    // The picture is written even if the check fails, so that it can be inspected.
    writeFile(options.output, bytesOf(options.output, picture, renderer));
    CheckResult check;
    if (options.check > 0) check = checkPicture(run, session, forest, surfaces, request);
    reportPicture(run, {session.scene().name, sceneJson(session), trees.json(), session.needs().line() + trees.lines(),
                        request, picture, check});
    if (watch.wasInterrupted() && picture.samples < request.samples)
        throw Error("interrupted after " + std::to_string(picture.samples) + " of " + std::to_string(request.samples) +
                    " samples; " + options.output.string() + " has these");
}

}  // namespace cleave
