// The queries of a tree, on the CPU and without one.
#include <algorithm>

#include "base/stopwatch.h"
#include "base/strided.h"
#include "facade/asked.h"
#include "facade/copied.h"
#include "facade/states.h"
#include "judge/crossings.h"
#include "judge/nearest.h"
#include "judge/overlaps.h"
#include "tree/open_edges.h"

namespace cleave::scene {
namespace {

Ray rayOf(const TraceRay& ray) { return copied<Ray>(std::span(&ray, 1)).front(); }
vec3 pointOf(const Point& point) { return {point[0], point[1], point[2]}; }

uint64_t invalidOf(std::span<const TraceRay> rays) {
    const auto isInvalid = [](const TraceRay& ray) { return !isValidRay(rayOf(ray)); };
    return static_cast<uint64_t>(std::count_if(rays.begin(), rays.end(), isInvalid));
}

}  // namespace

Twin::Twin(std::unique_ptr<State> state) : state_(std::move(state)) {}
Twin::~Twin() = default;
Twin::Twin(Twin&&) noexcept = default;

void Twin::State::requireClosed() {
    if (!openEdges) openEdges = cleave::openEdges(*world);
    requireNoOpenEdges(*openEdges);
}

AllHits Twin::all(std::span<const TraceRay> rays, uint32_t hitsPerRay) const {
    requireHitsPerRay(hitsPerRay);
    const Stopwatch watch;
    std::vector<Hit> hits(rays.size() * hitsPerRay);
    forEachStrided(rays.size(), state_->threads, [&](size_t, size_t i) {
        std::vector<Hit> found = bruteCrossings(state_->set, rayOf(rays[i]));
        found.resize(hitsPerRay, missedHit());
        std::copy(found.begin(), found.end(), hits.begin() + static_cast<ptrdiff_t>(i * hitsPerRay));
    });
    return {copied<TraceHit>(std::span<const Hit>(hits)), watch.milliseconds(), invalidOf(rays)};
}

Counts Twin::count(std::span<const TraceRay> rays, bool isSigned) const {
    const Stopwatch watch;
    std::vector<int32_t> counts(rays.size());
    forEachStrided(rays.size(), state_->threads, [&](size_t, size_t i) {
        counts[i] = isSigned ? bruteWinding(state_->set, rayOf(rays[i]))
                             : static_cast<int32_t>(bruteCrossings(state_->set, rayOf(rays[i])).size());
    });
    return {std::move(counts), watch.milliseconds(), invalidOf(rays)};
}

Nearest Twin::nearest(std::span<const Point> points, float within) const {
    requirePoints(points);
    requireWithin(within);
    const Stopwatch watch;
    std::vector<Hit> hits(points.size());
    forEachStrided(points.size(), state_->threads,
                   [&](size_t, size_t i) { hits[i] = bruteNearest(state_->set, pointOf(points[i]), within); });
    return {copied<TraceHit>(std::span<const Hit>(hits)), watch.milliseconds()};
}

Contained Twin::contains(std::span<const Point> points) const {
    requirePoints(points);
    state_->requireClosed();
    const Stopwatch watch;
    std::vector<uint8_t> isInside(points.size());
    forEachStrided(points.size(), state_->threads,
                   [&](size_t, size_t i) { isInside[i] = bruteContains(state_->set, pointOf(points[i])) ? 1 : 0; });
    return {std::move(isInside), watch.milliseconds()};
}

SignedDistances Twin::signedDistance(std::span<const Point> points) const {
    const Contained inside = contains(points);
    const Nearest found = nearest(points);
    return {signedDistances(found.hits, inside.isInside), inside.ms + found.ms};
}

Overlaps Twin::overlaps(std::span<const Box> boxes) const {
    requireBoxes(boxes);
    const Stopwatch watch;
    Overlaps result;
    const std::vector<cleave::Box> asked = copied<cleave::Box>(boxes);
    for (uint32_t i = 0; i < asked.size(); ++i)
        for (const uint32_t triangle : bruteOverlaps(state_->set, asked[i])) result.pairs.push_back({i, triangle});
    result.ms = watch.milliseconds();
    return result;
}

}  // namespace cleave::scene
