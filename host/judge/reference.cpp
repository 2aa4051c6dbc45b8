#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/oracle.h"
#include "judge/reference_bvh.h"
#include "judge/reference_triangle.h"

namespace cleave {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-6;        // of t, relative
constexpr double kEndTolerance = 0x1p-23;  // of an end of the interval: t is compared with it after rounding to float
constexpr double kLargestT = 0x1.fffffep127;
constexpr double kSmallestT = 0x1p-126;  // what is smaller is flushed

// The reference's answer to a ray: the closest hit whose t, rounded to float once, is in the ray's interval. That
// is doubtful where t is so close to an end of the interval, or to the largest float, that double's error may decide
// it. Whether t is before 0 is never in doubt: there the exact sign counts.
struct Answer {
    double t = kNever;
    double low = 0.0;  // PreciseT::low of t
    double slack = 0.0;
    uint32_t prim = kNone;
    double doubtfulT = kNever;  // the smallest doubtful t, whether it is in the interval or not

    bool isDoubtful() const { return doubtfulT < kNever && doubtfulT <= t * (1.0 + kTolerance) + slack; }
};

// Rounded to float once, as answers are before they are compared; what is behind the origin stays behind it.
bool isInside(double t, const Ray& ray) {
    if (t < 0.0 || t > std::numeric_limits<float>::max()) return false;
    const auto rounded = static_cast<float>(t);
    return rounded >= ray.tMin && rounded <= ray.tMax;
}

bool isNearAnEnd(const LineHit& hit, const Ray& ray) {
    const double lo = ray.tMin, hi = ray.tMax;
    const double loMargin = lo == 0.0 ? 0.0 : kEndTolerance * lo + hit.slack;
    const double hiMargin = std::isinf(hi) ? 0.0 : hi == 0.0 ? kSmallestT : kEndTolerance * hi + hit.slack;
    return std::fabs(hit.t - lo) < loMargin || std::fabs(hit.t - hi) < hiMargin || hit.t >= kLargestT;
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
            // A hit that can become neither the closest nor a closer doubtful one needs no better t.
            if (!hit.hits || hit.t - hit.slack > limit()) return;
            const PreciseT t = preciseT(ray, world[prim]);
            hit.t = t.high;
            if (isNearAnEnd(hit, ray)) best.doubtfulT = std::min(best.doubtfulT, hit.t);
            if (!isInside(hit.t, ray) || hit.t > best.t || (hit.t == best.t && t.low >= best.low)) return;
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
    Judgement faulty(const Ray& ray, const Answer& reference, Fault fault, uint32_t atFault) const {
        constexpr double kUlps = 4.0;
        const bool nearEdge = isKnown(atFault) && passesNearEdge(ray, world[atFault], kUlps);
        return {nearEdge || reference.isDoubtful() ? Verdict::undecided : Verdict::mismatch,
                fault,
                0.0,
                0.0,
                reference.t,
                reference.prim};
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
    Judgement judgement;
    if (error <= kSmallestT || reference.t <= reference.slack) return judgement;
    judgement.relativeTError = error / reference.t;
    const double ulp = std::ldexp(1.0, std::ilogb(reference.t) - 23);
    if (reference.slack <= 0.5 * ulp) judgement.ulpTError = error / ulp;
    return judgement;
}

Reference::Judgement Reference::judge(const Ray& ray, const Hit& hit, Query query) const {
    const bool isHit = hit.prim != kNone;
    if (!isValidRay(ray)) return isHit ? Judgement{Verdict::mismatch, Fault::falseHit} : Judgement{};
    const Answer reference = impl_->answer(ray);
    const bool isReferenceHit = reference.prim != kNone;
    const auto faulty = [&](Fault fault, uint32_t atFault) { return impl_->faulty(ray, reference, fault, atFault); };
    if (!isHit) return isReferenceHit ? faulty(Fault::missed, reference.prim) : Judgement{};
    if (!isReferenceHit) return faulty(Fault::falseHit, hit.prim);
    if (query == Query::any) return {};
    if (!isSameT(hit.t, reference.t, reference.slack))
        return faulty(Fault::wrong, hit.t > reference.t ? reference.prim : hit.prim);
    if (hit.prim != reference.prim && !impl_->finds(ray, hit)) return faulty(Fault::wrong, hit.prim);
    return Impl::agreeing(hit, reference);
}

}  // namespace cleave
