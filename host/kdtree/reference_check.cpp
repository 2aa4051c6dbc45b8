// Judgements of many rays, summed up.
#include <algorithm>
#include <limits>
#include <sstream>
#include <thread>

#include "error.h"
#include "kdtree/oracle.h"

namespace cleave {
namespace {

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
