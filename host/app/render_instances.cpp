#include "app/render_instances.h"

#include "app/picture_of.h"
#include "figures/legend.h"
#include "formats/write_file.h"

namespace cleave {

void renderInstances(Run& run, InstancedSession session) {
    const Options& options = run.options;
    const BuiltInstances built = session.build(options.builders.front());
    run.progress.phase("rendering");
    Renderer& renderer = run.device.renderer();
    run.device.device().transfers = {};
    PictureRequest request = requestOf(run, {session.scene(), session.posed(), session.restBounds(), session.needs()});
    request.traversal = instancedTraversal(run);
    Picture picture = renderer.render(built.onDevice, request);
    run.progress.clear();
    if (countsSteps(request.view)) drawLegend(picture);
    // The picture is written even if the check fails, so that it can be inspected.
    writeFile(options.output, bytesOf(options.output, picture, renderer));
    CheckResult check;
    if (options.check > 0)
        check = session.check(renderer.readRays(), renderer.readHits(), Query::closest, options.check);
    const uint64_t rays = uint64_t{options.width} * options.height;
    Json report{{"scene", sceneJson(session.facts(built))},
                {"build", instancesBuildJson(session, built)},
                {"trace", traceJson(request.traversal, request.test, rays, picture.traceMs, picture.invalidRays,
                                    picture.cappedRays)},
                {"render", {{"ms", numberJson(picture.ms)}, {"samples", picture.samples}}}};
    report["build"]["setupMs"] = numberJson(run.device.setupMilliseconds());
    if (options.check > 0) report["check"] = checkJson(check);
    writeReport(run, report);
    requireAnswered(picture.cappedRays, check, session.scene().name);
    run.print(session.needs().line() + instancesLine(session, built) +
              tracedLine(rays, picture.traceMs, picture.invalidRays) + (options.check > 0 ? checkedLine(check) : "") +
              "picture   " + options.output.string() + "\n");
}

}  // namespace cleave
