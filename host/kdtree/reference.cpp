#include <algorithm>
#include <cmath>
#include <limits>

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
    double low = 0.0;  // PreciseT::low of t
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

}  // namespace

struct Reference::Impl {
    std::vector<Triangle> world;
    std::vector<bool> isIncluded;
    ReferenceBvh bvh;

    static Judgement agreeing(const Hit& hit, const Answer& reference);

    Answer answer(const Ray& ray) const {
        Answer best;
        const auto limit = [&] { return std::min(double{ray.tMax}, best.t) * (1.0 + 1e-5) + best.slack; };
        bvh.traverse(ray, limit, [&](uint32_t prim) {
            LineHit hit = intersectLine(ray, world[prim]);
            // What cannot become the closest hit, nor a doubtful one before it, needs no better t.
            if (!hit.hits || hit.t - hit.slack > limit()) return;
            const PreciseT t = preciseT(ray, world[prim]);
            hit.t = t.high;
            const Range range = rangeOf(hit, ray);
            if (range == Range::doubtful) best.doubtfulT = std::min(best.doubtfulT, hit.t);
            if (range != Range::inside || hit.t > best.t || (hit.t == best.t && t.low >= best.low)) return;
            best.t = hit.t;
            best.low = t.low;
            best.slack = hit.slack;
            best.prim = prim;
        });
        return best;
    }

    bool finds(const Ray& ray, const Hit& hit) const {
        if (!isKnown(hit.prim)) return false;
        const LineHit own = intersectLine(ray, world[hit.prim]);
        return own.hits && isSameT(hit.t, own.t, own.slack);
    }

    bool isKnown(uint32_t prim) const { return prim < isIncluded.size() && isIncluded[prim]; }

    // A fault counts unless the ray passes too close to an edge of the triangle that was missed or made up.
    Judgement faulty(const Ray& ray, Fault fault, uint32_t atFault) const {
        constexpr double kUlps = 4.0;
        const bool excused = isKnown(atFault) && passesNearEdge(ray, world[atFault], kUlps);
        return {excused ? Verdict::undecided : Verdict::mismatch, fault};
    }
};

Reference::Reference(std::span<const Triangle> world, std::span<const uint32_t> included)
    : impl_(new Impl{{world.begin(), world.end()}, std::vector<bool>(world.size()), {world, included}}) {
    for (const uint32_t i : included) impl_->isIncluded[i] = true;
}

Reference::~Reference() = default;

// The error of a hit that agrees. Below the smallest normal float there is none: answers are flushed there.
Reference::Judgement Reference::Impl::agreeing(const Hit& hit, const Answer& reference) {
    const double error = std::fabs((hit.t - reference.t) - reference.low);
    if (error <= kSmallestT) return {};
    const double ulp = std::ldexp(1.0, std::max(std::ilogb(reference.t), -126) - 23);
    return {Verdict::agrees, Fault::none, error / reference.t, error / ulp};
}

Reference::Judgement Reference::judge(const Ray& ray, const Hit& hit, Query query) const {
    const bool isHit = hit.prim != kNone;
    if (!isValidRay(ray)) return isHit ? Judgement{Verdict::mismatch, Fault::falseHit} : Judgement{};
    const Answer reference = impl_->answer(ray);
    const bool isCertainHit = reference.prim != kNone;
    if (!isCertainHit && reference.doubtfulT < kNever) return {Verdict::undecided};
    if (!isHit) return isCertainHit ? impl_->faulty(ray, Fault::missed, reference.prim) : Judgement{};
    if (!isCertainHit) return impl_->faulty(ray, Fault::falseHit, hit.prim);
    if (query == Query::any) return {};
    if (reference.doubtfulT < kNever && reference.doubtfulT <= reference.t * (1.0 + kTolerance))
        return {Verdict::undecided};
    if (!isSameT(hit.t, reference.t, reference.slack))
        return impl_->faulty(ray, Fault::wrong, hit.t > reference.t ? reference.prim : hit.prim);
    if (hit.prim != reference.prim && !impl_->finds(ray, hit)) return impl_->faulty(ray, Fault::wrong, hit.prim);
    return Impl::agreeing(hit, reference);
}

}  // namespace cleave
