#include "app/report_picture.h"

#include "app/report.h"

namespace cleave {
namespace {

Json passesJson(const Picture& picture) {
    Json passes = Json::object();
    for (const PassTime& pass : picture.passes) passes[pass.name] = numberJson(pass.ms);
    return passes;
}

}  // namespace

void reportPicture(Run& run, FinishedPicture finished) {
    const Options& options = run.options;
    const Picture& picture = finished.picture;
    const PictureRequest& request = finished.request;
    const uint64_t rays = uint64_t{options.width} * options.height * picture.samples;
    Json report{
        {"scene", std::move(finished.scene)},
        {"build", std::move(finished.build)},
        {"trace",
         traceJson(request.traversal, request.test, rays, picture.traceMs, picture.invalidRays, picture.cappedRays)},
        {"render", {{"ms", numberJson(picture.ms)}, {"samples", picture.samples}, {"passesMs", passesJson(picture)}}}};
    report["build"]["setupMs"] = numberJson(run.device.setupMilliseconds());
    if (options.check > 0) report["check"] = checkJson(finished.check);
    writeReport(run, report);
    requireAnswered(picture.cappedRays, finished.check, finished.sceneName);
    run.print(finished.before + tracedLine(rays, picture.traceMs, picture.invalidRays) +
              (options.check > 0 ? checkedLine(finished.check) : "") + "picture   " + options.output.string() +
              (request.samples > 1 ? ", " + std::to_string(picture.samples) + " samples per pixel" : "") + "\n");
}

}  // namespace cleave
