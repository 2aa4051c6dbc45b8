// cleave bench --queries: what the other queries cost, beside what one would do without them.
#include <algorithm>
#include <functional>

#include "app/commands.h"
#include "app/report.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "figures/timing.h"
#include "peers/nearest_walk.h"
#include "scene/ray_sets.h"

namespace cleave {
namespace {

constexpr uint32_t kHits = 8;
constexpr uint32_t kPoints = 1u << 20;
constexpr uint32_t kSeed = 1;

struct Row {
    std::string query, items;
    uint64_t count = 0;
    double ms = 0.0;
    uint64_t found = 0;
};

double medianOfRuns(uint32_t runs, const std::function<double()>& once) {
    once();
    std::vector<double> ms;
    for (uint32_t i = 0; i < runs; ++i) ms.push_back(once());
    return medianOf(ms);
}

// Queries that are compared take turns, so that what else the machine does slows all of them.
struct Contender {
    Row row;
    std::function<double(Row&)> once;
    std::vector<double> ms{};
};
std::vector<Row> mediansOfTurns(uint32_t runs, std::vector<Contender> contenders) {
    for (Contender& c : contenders) c.once(c.row);
    for (uint32_t i = 0; i < runs; ++i)
        for (Contender& c : contenders) c.ms.push_back(c.once(c.row));
    std::vector<Row> rows;
    for (Contender& c : contenders) {
        c.row.ms = medianOf(c.ms);
        rows.push_back(std::move(c.row));
    }
    return rows;
}

// As one does without all hits: the closest hit again and again, from just behind the last one, for the rays that still
// have one. Hits at the same t, and so one of two at a shared edge, are lost.
double repeatedClosest(Run& run, const DeviceTree& tree, const std::vector<Ray>& rays, Row& row) {
    const TraceMode mode{Query::closest, run.traversal(), TriangleTest::watertight, false};
    std::vector<Ray> left = rays;
    double ms = 0.0;
    row.found = 0;
    for (uint32_t k = 0; k < kHits && !left.empty(); ++k) {
        const Tracer::Result traced = run.device.tracer().trace(tree, left, mode);
        ms += traced.ms;
        std::vector<Ray> next;
        for (size_t i = 0; i < left.size(); ++i) {
            if (traced.hits[i].prim == kNone) continue;
            next.push_back(left[i]);
            next.back().tMin = nextFloat(traced.hits[i].t, true);
            ++row.found;
        }
        left = std::move(next);
    }
    return ms;
}

double allHits(Run& run, const DeviceTree& tree, const std::vector<Ray>& rays, Row& row) {
    const Tracer::Result traced = run.device.tracer().all(tree, rays, kHits);
    const auto isHit = [](const Hit& hit) { return hit.prim != kNone; };
    row.found = static_cast<uint64_t>(std::count_if(traced.hits.begin(), traced.hits.end(), isHit));
    return traced.ms;
}

double counted(Run& run, const DeviceTree& tree, const std::vector<Ray>& rays, Row& row) {
    const Tracer::Counts traced = run.device.tracer().count(tree, rays);
    row.found = 0;
    for (const int32_t count : traced.counts) row.found += static_cast<uint64_t>(count);
    return traced.ms;
}

// In this order: one after the other, all at once, counted.
std::vector<Row> rayRows(Run& run, const DeviceTree& tree, const std::string& items, const std::vector<Ray>& rays) {
    const auto contender = [&](const std::string& query, const auto& once) {
        return Contender{{query, items, rays.size(), 0.0, 0}, [&](Row& row) { return once(run, tree, rays, row); }};
    };
    const std::string hits = std::to_string(kHits);
    return mediansOfTurns(run.options.runs, {contender("closest, " + hits + " times", repeatedClosest),
                                             contender("all, " + hits, allHits), contender("count", counted)});
}

// Anywhere in the scene's box, a quarter larger on each side.
std::vector<vec3> pointsIn(const Box& bounds) {
    std::vector<vec3> points;
    for (uint32_t i = 0; i < kPoints; ++i) {
        vec3 p;
        for (uint32_t k = 0; k < 3; ++k) {
            const double lo = bounds.lo[static_cast<int>(k)], extent = double{bounds.hi[static_cast<int>(k)]} - lo;
            p[static_cast<int>(k)] = static_cast<float>(lo + (1.5 * rnd(kSeed, i, k) - 0.25) * extent);
        }
        points.push_back(p);
    }
    return points;
}

std::vector<Row> nearestRows(Run& run, const Session& session, const BuiltTree& built, const DeviceTree& tree,
                             const std::vector<vec3>& points) {
    Row device{"nearest", "points", points.size(), 0.0, 0}, walk{"nearest, a walk on the CPU", "points", 0, 0.0, 0};
    std::vector<Hit> ours;
    device.ms = medianOfRuns(run.options.runs, [&] {
        Searcher::Nearest found = run.device.searcher().nearest(tree, points, infinity());
        ours = std::move(found.hits);
        return found.ms;
    });
    device.found = points.size();
    const std::span<const vec3> some = std::span(points).first(points.size() / 16);
    const Stopwatch watch;
    const std::vector<Hit> theirs = nearestWalk(built.tree, session.set(), some);
    walk.ms = watch.milliseconds();
    walk.count = walk.found = some.size();
    const float tolerance = 1e-6f * largestComponent(session.worldBounds().hi - session.worldBounds().lo);
    for (size_t i = 0; i < some.size(); ++i)
        if (!(std::fabs(ours[i].t - theirs[i].t) <= tolerance))
            throw Error("bench of " + session.scene().name + ": the nearest triangle of point " + std::to_string(i) +
                        " is " + std::to_string(double{theirs[i].t}) + " away, and not " +
                        std::to_string(double{ours[i].t}) + "; please report this scene");
    return {device, walk};
}

Row contained(Run& run, const DeviceTree& tree, const std::vector<vec3>& points) {
    Row row{"contains", "points", points.size(), 0.0, 0};
    row.ms = medianOfRuns(run.options.runs, [&] {
        const Searcher::Contained found = run.device.searcher().contains(tree, points);
        row.found = static_cast<uint64_t>(std::count(found.isInside.begin(), found.isInside.end(), uint8_t{1}));
        return found.ms;
    });
    return row;
}

Row overlapping(Run& run, const DeviceTree& tree, const Box& bounds, const std::vector<vec3>& points) {
    const vec3 half = 0.005f * (bounds.hi - bounds.lo);
    std::vector<Box> boxes;
    for (size_t i = 0; i < points.size() / 8; ++i) boxes.push_back({points[i] - half, points[i] + half});
    Row row{"overlaps", "boxes of 1 %", boxes.size(), 0.0, 0};
    row.ms = medianOfRuns(run.options.runs, [&] {
        const Searcher::Overlaps found = run.device.searcher().overlaps(tree, boxes);
        row.found = found.pairs.size();
        return found.ms;
    });
    return row;
}

Json benchScene(Run& run, const std::filesystem::path& file) {
    Session session(run, file);
    BuiltTree built = session.build(run.options.builders.front());
    const DeviceTree& tree = session.upload(built);
    std::vector<Row> rows;
    std::vector<std::pair<std::string, double>> speedups;  // of all hits at once over one after the other
    const Box bounds = session.worldBounds();
    if (!isEmpty(bounds)) {
        run.progress.phase("timing queries");
        const std::pair<const char*, std::vector<Ray>> sets[] = {{"primary", primaryRays(bounds, run.options.interior)},
                                                                 {"lines", uniformLines(bounds, 1u << 18, kSeed)}};
        for (const auto& [name, rays] : sets) {
            const std::vector<Row> timed = rayRows(run, tree, name, rays);
            speedups.push_back({name, timed[0].ms / timed[1].ms});
            rows.insert(rows.end(), timed.begin(), timed.end());
        }
        const std::vector<vec3> points = pointsIn(bounds);
        for (Row& row : nearestRows(run, session, built, tree, points)) rows.push_back(std::move(row));
        rows.push_back(contained(run, tree, points));
        rows.push_back(overlapping(run, tree, bounds, points));
        run.progress.clear();
    }
    std::vector<std::vector<std::string>> table{{"query", "items", "number", "ms", "M/s", "found"}};
    Json queries = Json::array();
    for (const Row& row : rows) {
        table.push_back({row.query, row.items, grouped(row.count), fixed(row.ms, 1),
                         fixed(mraysPerSecond(row.count, row.ms), 3), grouped(row.found)});
        queries.push_back({{"query", row.query},
                           {"items", row.items},
                           {"number", row.count},
                           {"ms", numberJson(row.ms)},
                           {"mqueriesPerSecond", numberJson(mraysPerSecond(row.count, row.ms))},
                           {"found", row.found}});
    }
    run.print(oneLine(file.filename().string()) + ": " + grouped(session.posed().triangles.size()) + " triangles, " +
              oneLine(run.device.name().value_or("")) + ", median of " + std::to_string(run.options.runs) + "\n" +
              alignedTable(table, "llrrrr"));
    Json faster = Json::object();
    for (const auto& [items, speedup] : speedups) {
        run.print("all, " + std::to_string(kHits) + ", of " + items + ": " + fixed(speedup, 2) +
                  " times as fast as closest, " + std::to_string(kHits) + " times\n");
        faster[items] = numberJson(speedup);
    }
    run.print("\n");
    return {{"scene", sceneJson(session)}, {"build", buildJson(built)}, {"queries", queries}, {"allSpeedup", faster}};
}

}  // namespace

void runQueryBench(Run& run) {
    Json scenes = Json::array();
    for (const std::filesystem::path& file : run.options.scenes) scenes.push_back(benchScene(run, file));
    writeReport(run, scenes.size() == 1 ? scenes.front() : Json{{"scenes", scenes}});
}

}  // namespace cleave
