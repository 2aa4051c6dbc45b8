#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <thread>

#include "error.h"
#include "kdtree/oracle.h"
#include "kdtree/reference_bvh.h"
#include "kdtree/reference_triangle.h"

namespace cleave {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-6;        // of t, relative
constexpr double kEndTolerance = 0x1p-23;  // of an end of the interval: t is compared with it after rounding to float
constexpr double kLargestT = 0x1.fffffep127;
constexpr double kSmallestT = 0x1p-126;  // what is smaller is flushed

// What the reference knows about a ray. A hit is doubtful where its t is so close to an end of the ray's interval that
// the rounding of t to float decides whether it counts, or where it is beyond the range of float.
struct Answer {
    double t = kNever;
    double slack = 0.0;
    uint32_t prim = kNone;
    double doubtfulT = kNever;
};

enum class Range { inside, doubtful, outside };

Range rangeOf(const LineHit& hit, const Ray& ray) {
    const double lo = ray.tMin, hi = ray.tMax;
    const double loMargin = kEndTolerance * lo + hit.slack;
    const double hiMargin = std::isinf(hi) ? 0.0 : kEndTolerance * hi + hit.slack;
    if (hit.t < lo - loMargin || hit.t > hi + hiMargin) return Range::outside;
    if (hit.t >= kLargestT) return Range::doubtful;
    if (hit.t == lo && lo == 0.0 && hit.slack == 0.0) return Range::inside;
    return hit.t < lo + loMargin || (hiMargin > 0.0 && hit.t > hi - hiMargin) ? Range::doubtful : Range::inside;
}

bool isSameT(double t, double reference, double slack) {
    return std::fabs(t - reference) <= std::max(kTolerance * reference, std::max(slack, kSmallestT));
}

struct Tally {
    uint64_t mismatches = 0;
    uint64_t undecided = 0;
    double maxRelativeTError = 0.0;
    uint64_t firstMismatch = std::numeric_limits<uint64_t>::max();  // an index of a ray
};

std::string described(uint64_t index, const Ray& ray, const Hit& hit) {
    std::ostringstream text;
    text.precision(9);
    text << "ray " << index << ", origin (" << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z
         << "), direction (" << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z << "), t in ["
         << ray.tMin << ", " << ray.tMax << "]: ";
    if (hit.prim == kNone)
        text << "answered with a miss";
    else
        text << "answered with triangle " << hit.prim << " at t = " << hit.t;
    return text.str();
}

}  // namespace

struct Reference::Impl {
    std::vector<Triangle> world;
    std::vector<bool> isIncluded;
    ReferenceBvh bvh;

    Answer answer(const Ray& ray) const {
        Answer best;
        const auto limit = [&] { return std::min(double{ray.tMax}, best.t) * (1.0 + 1e-5) + best.slack; };
        bvh.traverse(ray, limit, [&](uint32_t prim) {
            const LineHit hit = intersectLine(ray, world[prim]);
            if (!hit.hits) return;
            const Range range = rangeOf(hit, ray);
            if (range == Range::doubtful) best.doubtfulT = std::min(best.doubtfulT, hit.t);
            if (range != Range::inside || hit.t >= best.t) return;
            best.t = hit.t;
            best.slack = hit.slack;
            best.prim = prim;
        });
        return best;
    }

    bool finds(const Ray& ray, const Hit& hit) const {
        if (hit.prim >= isIncluded.size() || !isIncluded[hit.prim]) return false;
        const LineHit own = intersectLine(ray, world[hit.prim]);
        return own.hits && isSameT(hit.t, own.t, own.slack);
    }
};

Reference::Reference(std::span<const Triangle> world, std::span<const uint32_t> included)
    : impl_(new Impl{{world.begin(), world.end()}, std::vector<bool>(world.size()), {world, included}}) {
    for (const uint32_t i : included) impl_->isIncluded[i] = true;
}

Reference::~Reference() = default;

Reference::Judgement Reference::judge(const Ray& ray, const Hit& hit, Query query) const {
    const bool isHit = hit.prim != kNone;
    if (!isValidRay(ray)) return {isHit ? Verdict::mismatch : Verdict::agrees, 0.0};
    const Answer reference = impl_->answer(ray);
    const bool isCertainHit = reference.prim != kNone;
    if (!isCertainHit && reference.doubtfulT < kNever) return {Verdict::undecided, 0.0};
    if (!isHit || query == Query::any) return {isHit == isCertainHit ? Verdict::agrees : Verdict::mismatch, 0.0};
    if (reference.doubtfulT < kNever && reference.doubtfulT <= reference.t * (1.0 + kTolerance))
        return {Verdict::undecided, 0.0};
    if (!isCertainHit || !isSameT(hit.t, reference.t, reference.slack)) return {Verdict::mismatch, 0.0};
    if (hit.prim != reference.prim && !impl_->finds(ray, hit)) return {Verdict::mismatch, 0.0};
    const double error = std::fabs(hit.t - reference.t);
    return {Verdict::agrees, error <= kSmallestT ? 0.0 : error / reference.t};
}

CheckResult check(const Reference& reference, std::span<const Ray> rays, std::span<const Hit> hits, Query query,
                  uint64_t count, uint32_t threads) {
    if (rays.size() != hits.size())
        throw Error("cannot check " + std::to_string(hits.size()) + " hits of " + std::to_string(rays.size()) +
                    " rays; give one hit per ray");
    CheckResult result;
    result.rays = std::min<uint64_t>(count, rays.size());
    const auto indexOf = [&](uint64_t i) { return i * rays.size() / result.rays; };
    const uint64_t workers = std::max<uint64_t>(1, threads);
    std::vector<Tally> tallies(workers);
    const auto work = [&](uint64_t worker) {
        Tally tally;
        for (uint64_t i = worker; i < result.rays; i += workers) {
            const uint64_t index = indexOf(i);
            const Reference::Judgement judgement = reference.judge(rays[index], hits[index], query);
            tally.undecided += judgement.verdict == Reference::Verdict::undecided ? 1 : 0;
            tally.maxRelativeTError = std::max(tally.maxRelativeTError, judgement.relativeTError);
            if (judgement.verdict != Reference::Verdict::mismatch) continue;
            ++tally.mismatches;
            tally.firstMismatch = std::min(tally.firstMismatch, index);
        }
        tallies[worker] = tally;
    };
    {
        std::vector<std::jthread> pool;
        for (uint64_t worker = 1; worker < workers; ++worker) pool.emplace_back(work, worker);
        work(0);
    }
    uint64_t first = std::numeric_limits<uint64_t>::max();
    for (const Tally& tally : tallies) {
        result.mismatches += tally.mismatches;
        result.undecided += tally.undecided;
        result.maxRelativeTError = std::max(result.maxRelativeTError, tally.maxRelativeTError);
        first = std::min(first, tally.firstMismatch);
    }
    if (result.mismatches > 0) result.first = described(first, rays[first], hits[first]);
    return result;
}

}  // namespace cleave
