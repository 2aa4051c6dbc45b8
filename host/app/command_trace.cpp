#include "app/commands.h"
#include "app/report.h"
#include "base/text.h"
#include "formats/npy.h"
#include "formats/write_file.h"

namespace cleave {

void runTrace(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    const std::vector<Ray> rays = readRays(options.rays);
    Session session(run, options.scenes.front());
    BuiltTree built = session.build(options.builders.front());
    const DeviceTree& tree = session.upload(built);
    run.progress.phase("tracing");
    const TraceMode mode{options.query, run.traversal(), options.triangleTests.front(), false};
    const Tracer::Result traced = run.device.tracer().trace(tree, rays, mode);

    // Hits are written even if the check fails, so that they can be inspected.
    writeFile(options.output, npyOf(traced.hits));
    Json report{
        {"scene", sceneJson(session)},
        {"build", buildJson(built)},
        {"trace", traceJson(mode.traversal, mode.test, rays.size(), traced.ms, traced.invalidRays, traced.cappedRays)}};
    CheckResult check;
    if (options.check > 0) {
        check = session.check(rays, traced.hits, options.query, options.check);
        report["check"] = checkJson(check);
    }
    writeReport(run, report);
    requireAnswered(traced.cappedRays, check, session.scene().name);

    run.print(builtLine(built) + tracedLine(rays.size(), traced.ms, traced.invalidRays) +
              (options.check > 0 ? checkedLine(check) : "") + "hits      " + options.output.string() + "\n");
}

}  // namespace cleave
