#include "app/render_instances.h"

#include "app/picture_of.h"
#include "app/report_picture.h"
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
    reportPicture(run, {session.scene().name, sceneJson(session.facts(built)), instancesBuildJson(session, built),
                        session.needs().line() + instancesLine(session, built), request, picture, check});
}

}  // namespace cleave
