#include "app/bench_rays.h"

#include "figures/timing.h"

namespace cleave {

void makeSecondaryRays(RaySets& sets, const Session& session, uint32_t size) {
    const Box bounds = session.worldBounds();
    const std::vector<SurfacePoint> points =
        surfacePoints(session.posed().triangles, bounds, sets[0].rays, sets[0].hits);
    sets[1] = {diffuseRays(points, size), Query::closest, {}};
    sets[2] = {shadowRays(points, bounds, size), Query::any, {}};
}

SetFigures measureSet(Run& run, Session& session, const DeviceTree& tree, const RaySet& set, TraceMode mode,
                      const std::string& name, uint32_t runs, uint64_t judged, std::vector<Hit>* hits) {
    SetFigures figures;
    figures.rays = set.rays.size();
    figures.hitsHash = hitsHash({}, set.query);
    if (set.rays.empty()) return figures;
    run.progress.phase("tracing " + name + " rays");
    Tracer& tracer = run.device.tracer();
    Tracer::Result traced = tracer.trace(tree, set.rays, mode);
    run.progress.phase("timing " + name + " rays");
    figures.runs = tracer.time(tree, set.rays, mode, runs);
    figures.ms = medianOf(figures.runs);
    figures.invalidRays = traced.invalidRays;
    figures.cappedRays = traced.cappedRays;
    figures.hitsHash = hitsHash(traced.hits, set.query);
    figures.check = session.check(set.rays, traced.hits, set.query, judged);
    if (mode.test != TriangleTest::plain)
        requireAnswered(traced.cappedRays, figures.check, session.scene().name + ", " + name + " rays");
    TraceMode counting = mode;
    counting.countSteps = true;
    if (run.options.work || run.options.triangleTests.size() > 1)
        figures.work = workOf(tracer.trace(tree, set.rays, counting).steps, run.device.device().subgroupSize());
    if (hits != nullptr) *hits = std::move(traced.hits);
    return figures;
}

}  // namespace cleave
