#include <algorithm>

#include "app/commands.h"
#include "app/instanced_session.h"
#include "app/report.h"
#include "app/scene_trees.h"
#include "base/text.h"
#include "figures/timing.h"
#include "formats/npy.h"
#include "formats/write_file.h"

namespace cleave {
namespace {

// What a query leaves to be reported.
struct Traced {
    Json json;
    double ms = 0.0;
    uint64_t invalidRays = 0;
    uint64_t cappedRays = 0;
    CheckResult check;
    std::string told;  // the line about the output
};

// `trees`: the Forest of a Session, or the DeviceInstances of an InstancedSession.
template <typename AnySession, typename Trees>
Traced traceHits(Run& run, AnySession& session, const Trees& trees, const std::vector<Ray>& rays, Traversal traversal) {
    const Options& options = run.options;
    const TraceMode mode{options.query, traversal, options.triangleTests.front(), false};
    const Tracer::Result found = run.device.tracer().trace(trees, rays, mode);
    // Hits are written even if the check fails, so that they can be inspected.
    writeFile(options.output, npyOf(found.hits));
    Traced traced{{}, found.ms, found.invalidRays, found.cappedRays, {}, {}};
    traced.json = traceJson(mode.traversal, mode.test, rays.size(), found.ms, found.invalidRays, found.cappedRays);
    if (options.check > 0) {
        traced.check = session.check(rays, found.hits, options.query, options.check);
        traced.told = checkedLine(traced.check);
    }
    traced.told += "hits      " + options.output.string() + "\n";
    return traced;
}

// The figures of queries that choose their own traversal.
Json onceJson(size_t rays, double ms, uint64_t invalidRays) {
    return {{"traversal", nameOf(Traversal::shortStack)},
            {"rays", rays},
            {"ms", numberJson(ms)},
            {"mraysPerSecond", numberJson(mraysPerSecond(rays, ms))},
            {"invalidRays", invalidRays}};
}

Traced traceAll(Run& run, const DeviceTree& tree, const std::vector<Ray>& rays) {
    const Options& options = run.options;
    const Tracer::Result found = run.device.tracer().all(tree, rays, options.hitsPerRay);
    writeFile(options.output, npyOf(found.hits, options.hitsPerRay));
    const auto hits = static_cast<uint64_t>(
        std::count_if(found.hits.begin(), found.hits.end(), [](const Hit& hit) { return hit.prim != kNone; }));
    Json json = onceJson(rays.size(), found.ms, found.invalidRays);
    json["hitsPerRay"] = options.hitsPerRay;
    json["hits"] = hits;
    return {json, found.ms, found.invalidRays, 0, {}, grouped(hits) + " hits in " + options.output.string() + "\n"};
}

Traced traceCount(Run& run, const DeviceTree& tree, const std::vector<Ray>& rays) {
    const Options& options = run.options;
    const Tracer::Counts found = run.device.tracer().count(tree, rays, options.query == Query::signedCount);
    writeFile(options.output, npyOfCounts(found.counts));
    int64_t sum = 0;
    uint64_t odd = 0;
    for (const int32_t count : found.counts) {
        sum += count;
        odd += (count & 1) != 0 ? 1 : 0;
    }
    Json json = onceJson(rays.size(), found.ms, found.invalidRays);
    json["hits"] = sum;
    json["oddCounts"] = odd;
    return {json, found.ms, found.invalidRays, 0, {}, "counts    " + options.output.string() + "\n"};
}

Traced answered(Run& run, Session& session, const Forest& forest, const std::vector<Ray>& rays) {
    run.progress.phase("tracing");
    const Query query = run.options.query;
    if (query == Query::all) return traceAll(run, *forest.trees.front(), rays);
    if (query == Query::count || query == Query::signedCount) return traceCount(run, *forest.trees.front(), rays);
    return traceHits(run, session, forest, rays, run.traversal());
}

void report(Run& run, Json scene, Json build, const Traced& traced) {
    Json report{{"scene", std::move(scene)}, {"build", std::move(build)}, {"trace", traced.json}};
    if (run.options.check > 0) report["check"] = checkJson(traced.check);
    writeReport(run, report);
}

void traceInstanced(Run& run, InstancedSession session, const std::vector<Ray>& rays) {
    const BuiltInstances built = session.build(run.options.builders.front());
    const Traversal traversal = instancedTraversal(run);
    findInTracing(session.needs(), {.query = run.options.query, .traversal = traversal, .instances = true});
    run.progress.phase("tracing");
    const Traced traced = traceHits(run, session, built.onDevice, rays, traversal);
    report(run, sceneJson(session.facts(built)), instancesBuildJson(session, built), traced);
    requireAnswered(traced.cappedRays, traced.check, session.scene().name);
    run.print(session.needs().line() + instancesLine(session, built) +
              tracedLine(rays.size(), traced.ms, traced.invalidRays) + traced.told);
}

}  // namespace

void runTrace(Run& run) {
    const Options& options = run.options;
    requireWritable(options.output);
    if (options.json) requireWritable(*options.json);
    const std::vector<Ray> rays = readRays(options.rays);
    ReadScene loaded = readScene(run, options.scenes.front());
    if (const auto sharing = sharingFor(run, loaded.scene))
        return traceInstanced(run, InstancedSession(run, std::move(loaded), *sharing), rays);
    Session session(run, std::move(loaded));
    SceneTrees trees(options, session, {.rays = rays.size()});
    trees.build(false);
    findInTracing(session.needs(), {options.query, run.traversal()});
    const Traced traced = answered(run, session, trees.forest(), rays);

    report(run, sceneJson(session), trees.json(), traced);
    requireAnswered(traced.cappedRays, traced.check, session.scene().name);
    run.print(session.needs().line() + trees.lines() + tracedLine(rays.size(), traced.ms, traced.invalidRays) +
              traced.told);
}

}  // namespace cleave
