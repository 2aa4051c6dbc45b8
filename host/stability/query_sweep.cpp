#include "stability/query_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "base/strided.h"
#include "base/text.h"
#include "judge/crossings.h"
#include "judge/nearest.h"
#include "judge/oracle.h"
#include "judge/separation.h"
#include "shared/overlap.h"
#include "stability/random.h"
#include "stability/ray_families.h"
#include "tree/open_edges.h"

namespace cleave {
namespace {

constexpr uint32_t kHitsPerRay = 12;  // more than one walk collects

// Of each family that needs no tree, some.
std::vector<Ray> raysOf(std::span<const Triangle> world, const TriangleSet& set, uint64_t count, uint64_t seed) {
    const auto closest = [&](std::span<const Ray> rays) {
        std::vector<Hit> hits;
        for (const Ray& ray : rays) hits.push_back(bruteForce(set, ray, Query::closest));
        return hits;
    };
    std::vector<Ray> rays;
    for (const RayFamily& family : rayFamilies()) {
        if (family.needsTree) continue;
        const uint64_t some = (count + 9) / 10;
        const std::vector<Ray> made = family.make({world, set, nullptr, some, seedFor(seed, family.name), closest});
        rays.insert(rays.end(), made.begin(), made.end());
    }
    return rays;
}

// At vertices, on edges and faces, and anywhere in and about the scene.
std::vector<vec3> pointsOf(std::span<const Triangle> world, const TriangleSet& set, uint64_t count, uint64_t seed) {
    std::vector<vec3> points;
    if (set.included.empty()) return points;
    Random random(seedFor(seed, "points"));
    const double scale = std::exp2(set.exponent);
    const dvec3 lo = dvec3(set.bounds.lo) * scale, extent = dvec3(set.bounds.hi) * scale - lo;
    while (points.size() < count) {
        const Triangle& t = world[set.included[random.below(set.included.size())]];
        const uint32_t kind = random.below(5);
        const auto u = static_cast<float>(random.unit()), v = static_cast<float>(random.unit()) * (1.0f - u);
        vec3 p = kind == 0 ? t.a : kind == 1 ? t.a + u * (t.b - t.a) : t.a + u * (t.b - t.a) + v * (t.c - t.a);
        if (kind > 2) p = vec3(random.inBox(lo - 0.25 * extent, lo + 1.25 * extent));
        if (isFinite3(p)) points.push_back(p);
    }
    return points;
}

// From a point on, of any size from none to the scene's.
std::vector<Box> boxesAt(std::span<const vec3> points, const TriangleSet& set, uint64_t seed) {
    Random random(seedFor(seed, "boxes"));
    const double scale = std::exp2(set.exponent);
    std::vector<Box> boxes;
    for (const vec3& p : points) {
        Box box{p, p};
        for (int axis = 0; axis < 3; ++axis)
            if (random.below(4) > 0)
                box.hi[axis] += static_cast<float>(scale * std::exp2(-static_cast<double>(random.below(24))));
        if (isFinite3(box.hi)) boxes.push_back(box);
    }
    return boxes;
}

std::vector<uint32_t> numbersOf(std::span<const Hit> hits) {
    std::vector<uint32_t> numbers;
    for (const Hit& hit : hits)
        if (hit.prim != kNone) numbers.push_back(hit.prim);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

// To a rounding; t below the smallest normal number are 0.
bool isSameT(float t, float exact) {
    return std::fabs(double{t} - exact) <= 2.4e-7 * std::fabs(exact) + double{kSmallestNormal};
}

// Two t that round to the same float may come in either order, and of these either may be the last; otherwise t and
// numbers are the exact ones, t to a rounding.
bool isAsExact(std::span<const Hit> row, std::span<const Hit> exact) {
    const size_t count = std::min(row.size(), exact.size());
    for (size_t k = 0; k < count; ++k) {
        if (!isSameT(row[k].t, exact[k].t)) return false;
        const auto isIt = [&](const Hit& hit) { return hit.prim == row[k].prim; };
        const auto it = std::find_if(exact.begin(), exact.end(), isIt);
        if (it == exact.end() || !isSameT(row[k].t, it->t)) return false;
        if (k > 0 && !isCloser(row[k - 1], row[k])) return false;
    }
    for (size_t k = count; k < row.size(); ++k)
        if (row[k].prim != kNone) return false;
    return exact.size() > row.size() || numbersOf(row) == numbersOf(exact);
}

std::string textOf(const vec3& p) {
    std::ostringstream text;
    text.precision(9);
    text << "(" << p.x << ", " << p.y << ", " << p.z << ")";
    return text.str();
}
std::string textOf(const Ray& ray) {
    std::ostringstream text;
    text.precision(9);
    text << "ray from " << textOf(ray.origin) << " along " << textOf(ray.direction) << ", t in [" << ray.tMin << ", "
         << ray.tMax << "]";
    return text.str();
}
std::string textOf(const Box& box) { return "box from " + textOf(box.lo) + " to " + textOf(box.hi); }

// `what` tells of the item.
template <class What>
void add(QueryCell& cell, bool isRight, const What& what) {
    ++cell.asked;
    if (isRight) return;
    if (cell.differing == 0) cell.first = textOf(what);
    ++cell.differing;
}

}  // namespace

QueriesUnderTest queriesOf(const std::string& builder, const DeviceTree& tree, Tracer& tracer, Searcher& searcher) {
    QueriesUnderTest tested{builder, {}, {}, {}, {}, {}};
    tested.all = [&](std::span<const Ray> rays, uint32_t most) { return tracer.all(tree, rays, most).hits; };
    tested.count = [&](std::span<const Ray> rays, bool isSigned) { return tracer.count(tree, rays, isSigned).counts; };
    tested.contains = [&](std::span<const vec3> points) { return searcher.contains(tree, points).isInside; };
    tested.nearest = [&](std::span<const vec3> points) { return searcher.nearest(tree, points, infinity()).hits; };
    tested.overlaps = [&](std::span<const Box> boxes) { return searcher.overlaps(tree, boxes).pairs; };
    return tested;
}

QuerySweep::QuerySweep(std::string scene, std::span<const Triangle> world, const TriangleSet& set,
                       const QuerySweepSettings& settings)
    : scene_(std::move(scene)), world_(world), set_(set), isClosed_(openEdges(world) == 0) {
    const uint64_t seed = seedFor(settings.seed, scene_);
    const uint64_t count = std::min(settings.items, settings.work / std::max<uint64_t>(1, world.size()));
    rays_ = count == 0 ? std::vector<Ray>{} : raysOf(world, set, count, seed);
    points_ = pointsOf(world, set, count, seed);
    boxes_ = boxesAt(points_, set, seed);
    double largest = 0.0;
    for (const vec3& corner : {set.bounds.lo, set.bounds.hi})
        for (int axis = 0; axis < 3 && !set.included.empty(); ++axis)
            largest = std::max(largest, std::fabs(double{corner[axis]}));
    for (const vec3& p : points_)
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::fabs(double{p[axis]}) * std::exp2(-set.exponent));
    tolerance_ = 8.0 * 0x1p-24 * 2.0 * largest * std::exp2(set.exponent) + double{kSmallestNormal};

    crossings_.resize(rays_.size());
    windings_.resize(rays_.size());
    forEachStrided(rays_.size(), settings.threads, [&](size_t, size_t i) {
        crossings_[i] = referenceCrossings(world_, rays_[i]);
        for (const Hit& hit : crossings_[i]) windings_[i] += crossesOnce(rays_[i], world_[hit.prim]);
    });
    isInside_.resize(points_.size());
    distances_.resize(points_.size(), std::numeric_limits<double>::infinity());
    forEachStrided(points_.size(), settings.threads, [&](size_t, size_t i) {
        bool touches = false;
        for (const uint32_t prim : set_.included) {
            distances_[i] = std::min(distances_[i], referenceDistance(world_[prim], points_[i]));
            touches = touches || meets(world_[prim], {points_[i], points_[i]}, Contact::closed);
        }
        if (!isClosed_) return;
        const Ray line{points_[i], 0.0f, {-0.25f, 0.5f, 1.0f}, infinity()};  // another than the device looks along
        isInside_[i] = touches || referenceCrossings(world_, line).size() % 2 == 1 ? 1 : 0;
    });
    met_.resize(boxes_.size());
    forEachStrided(boxes_.size(), settings.threads, [&](size_t, size_t i) {
        for (const uint32_t prim : set_.included)
            if (meets(world_[prim], boxes_[i], Contact::closed)) met_[i].push_back(prim);
    });
}

bool QuerySweep::isNear(const vec3& point, const Hit& hit, double wanted) const {
    return hit.prim < world_.size() && std::fabs(double{hit.t} - wanted) <= tolerance_ &&
           std::fabs(referenceDistance(world_[hit.prim], point) - wanted) <= tolerance_;
}

std::vector<QueryCell> QuerySweep::run(const QueriesUnderTest& tested) const {
    std::vector<QueryCell> cells;
    cells.reserve(5);  // so that references stay
    const auto cell = [&](const char* query) -> QueryCell& {
        return cells.emplace_back(QueryCell{scene_, tested.builder, query, 0, 0, ""});
    };
    QueryCell& all = cell("all");
    const std::vector<Hit> hits = tested.all(rays_, kHitsPerRay);
    for (size_t i = 0; i < rays_.size(); ++i)
        add(all, isAsExact(std::span(hits).subspan(i * kHitsPerRay, kHitsPerRay), crossings_[i]), rays_[i]);
    QueryCell& count = cell("count");
    const std::vector<int32_t> counts = tested.count(rays_, false), windings = tested.count(rays_, true);
    for (size_t i = 0; i < rays_.size(); ++i)
        add(count, counts[i] == static_cast<int32_t>(crossings_[i].size()) && windings[i] == windings_[i], rays_[i]);
    QueryCell& contains = cell("contains");
    const std::vector<uint8_t> isInside = isClosed_ ? tested.contains(points_) : std::vector<uint8_t>{};
    for (size_t i = 0; i < isInside.size(); ++i) add(contains, isInside[i] == isInside_[i], points_[i]);
    QueryCell& nearest = cell("nearest");
    const std::vector<Hit> near = tested.nearest(points_);
    for (size_t i = 0; i < points_.size(); ++i) add(nearest, isNear(points_[i], near[i], distances_[i]), points_[i]);
    QueryCell& overlaps = cell("overlaps");
    std::vector<std::vector<uint32_t>> met(boxes_.size());
    for (const uvec2& pair : tested.overlaps(boxes_)) met.at(pair.x).push_back(pair.y);
    for (size_t i = 0; i < boxes_.size(); ++i) add(overlaps, met[i] == met_[i], boxes_[i]);
    return cells;
}

void requireAsBruteForce(std::span<const QueryCell> cells) {
    const auto differs = [](const QueryCell& cell) { return cell.differing > 0; };
    const auto first = std::find_if(cells.begin(), cells.end(), differs);
    if (first == cells.end()) return;
    throw Error("stability: " + grouped(static_cast<uint64_t>(std::count_if(first, cells.end(), differs))) + " of " +
                grouped(cells.size()) + " cells of queries differ from brute force, first: " + first->scene + ", " +
                first->builder + ", " + first->query + ": " + grouped(first->differing) + " of " +
                grouped(first->asked) + ", first " + first->first + "; please report this case");
}

}  // namespace cleave
