// Judgements of many rays, summed up.
#include <algorithm>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "base/strided.h"
#include "judge/oracle.h"

namespace cleave {
namespace {

// Of one thread; not in one cache line with the next one's.
struct alignas(64) Tally {
    uint64_t mismatches = 0, missed = 0, falseHits = 0;
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

void CheckResult::add(const CheckResult& more) {
    rays += more.rays;
    mismatches += more.mismatches;
    missed += more.missed;
    falseHits += more.falseHits;
    undecided += more.undecided;
    maxRelativeTError = std::max(maxRelativeTError, more.maxRelativeTError);
}

CheckResult check(const Reference& reference, std::span<const Ray> rays, std::span<const Hit> hits, Query query,
                  uint64_t count, uint32_t threads) {
    if (rays.size() != hits.size())
        throw Error("cannot check " + std::to_string(hits.size()) + " hits of " + std::to_string(rays.size()) +
                    " rays; give one hit per ray");
    CheckResult result;
    result.rays = std::min<uint64_t>(count, rays.size());
    const auto indexOf = [&](uint64_t i) { return i * rays.size() / result.rays; };
    std::vector<Tally> tallies(std::max(1u, threads));
    forEachStrided(result.rays, threads, [&](size_t worker, size_t i) {
        Tally& tally = tallies[worker];
        const uint64_t index = indexOf(i);
        const Reference::Judgement judgement = reference.judge(rays[index], hits[index], query);
        tally.undecided += judgement.verdict == Reference::Verdict::undecided ? 1 : 0;
        tally.maxRelativeTError = std::max(tally.maxRelativeTError, judgement.relativeTError);
        if (judgement.verdict != Reference::Verdict::mismatch) return;
        ++tally.mismatches;
        tally.missed += judgement.fault == Reference::Fault::missed ? 1 : 0;
        tally.falseHits += judgement.fault == Reference::Fault::falseHit ? 1 : 0;
        tally.firstMismatch = std::min(tally.firstMismatch, index);
    });
    uint64_t first = std::numeric_limits<uint64_t>::max();
    for (const Tally& tally : tallies) {
        result.mismatches += tally.mismatches;
        result.missed += tally.missed;
        result.falseHits += tally.falseHits;
        result.undecided += tally.undecided;
        result.maxRelativeTError = std::max(result.maxRelativeTError, tally.maxRelativeTError);
        first = std::min(first, tally.firstMismatch);
    }
    if (result.mismatches > 0) result.first = described(first, rays[first], hits[first]);
    return result;
}

}  // namespace cleave
