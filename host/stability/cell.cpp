#include "stability/cell.h"

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/strided.h"

namespace cleave {
namespace {

constexpr double kMostUndecided = 1e-5;

std::string pointText(const vec3& p) {
    std::ostringstream text;
    text.precision(9);
    text << "(" << p.x << ", " << p.y << ", " << p.z << ")";
    return text.str();
}

std::string answerText(const Hit& hit) {
    std::ostringstream text;
    text.precision(9);
    if (hit.prim == kNone)
        text << "a miss";
    else
        text << "triangle " << hit.prim << " at t = " << hit.t << ", u = " << hit.u << ", v = " << hit.v;
    return text.str();
}

bool isSame(const Hit& a, const Hit& b) { return a.t == b.t && a.prim == b.prim && a.u == b.u && a.v == b.v; }

bool isAsExpected(const Hit& hit, const Hit& expected, Query query) {
    if (query == Query::closest) return isSame(hit, expected);
    return (hit.prim == kNone) == (expected.prim == kNone) && hit.t >= expected.t;
}

// What was said of the expected answer, as far as it is about an answer to the query.
Reference::Judgement judgedAs(const Reference::Judgement& closest, Query query) {
    const bool isAboutT = closest.fault == Reference::Fault::none || closest.fault == Reference::Fault::wrong;
    return query == Query::any && isAboutT ? Reference::Judgement{} : closest;
}

std::string described(size_t i, const Ray& ray, const Hit& hit, const Hit& expected,
                      const Reference::Judgement& judgement, Query query) {
    std::ostringstream text;
    text.precision(9);
    text << "ray " << i << ", origin " << pointText(ray.origin) << ", direction " << pointText(ray.direction)
         << ", t in [" << ray.tMin << ", " << ray.tMax << "]: answered with " << answerText(hit);
    if (judgement.fault != Reference::Fault::none) {
        text << ", by the reference ";
        if (judgement.referencePrim == kNone)
            text << "a miss";
        else
            text << "triangle " << judgement.referencePrim << " at t = " << judgement.referenceT;
    }
    if (!isAsExpected(hit, expected, query)) text << ", expected " << answerText(expected);
    return text.str();
}

void add(Cell& cell, const Reference::Judgement& judgement) {
    using Verdict = Reference::Verdict;
    using Fault = Reference::Fault;
    cell.maxUlpError = std::max(cell.maxUlpError, judgement.ulpTError);
    cell.maxRelativeError = std::max(cell.maxRelativeError, judgement.relativeTError);
    if (judgement.verdict == Verdict::undecided) ++cell.undecided;
    if (judgement.verdict != Verdict::mismatch) return;
    cell.wrong += judgement.fault == Fault::wrong ? 1 : 0;
    cell.missed += judgement.fault == Fault::missed ? 1 : 0;
    cell.falseHits += judgement.fault == Fault::falseHit ? 1 : 0;
}

}  // namespace

std::vector<Reference::Judgement> judgeAll(const Reference& reference, std::span<const Ray> rays,
                                           std::span<const Hit> hits, uint32_t threads) {
    std::vector<Reference::Judgement> judged(rays.size());
    forEachStrided(rays.size(), threads,
                   [&](size_t, size_t i) { judged[i] = reference.judge(rays[i], hits[i], Query::closest); });
    return judged;
}

void count(Cell& cell, const Volley& volley, const Tracer::Result& traced, const Reference& reference, Query query) {
    cell.rays = volley.rays.size();
    cell.capped = traced.cappedRays;
    cell.ms = traced.ms;
    cell.byBruteForce = volley.byBruteForce;
    bool isBroken = false;
    for (size_t i = 0; i < volley.rays.size(); ++i) {
        const Hit &hit = traced.hits[i], &expected = volley.expected[i];
        const bool same = isAsExpected(hit, expected, query);
        const auto judgement = same ? judgedAs(volley.judged[i], query) : reference.judge(volley.rays[i], hit, query);
        cell.hits += hit.prim != kNone ? 1 : 0;
        cell.differing += same ? 0 : 1;
        add(cell, judgement);
        const bool breaks = !same || judgement.verdict == Reference::Verdict::mismatch;
        const bool doubtful = judgement.verdict == Reference::Verdict::undecided;
        if ((breaks && !isBroken) || (doubtful && cell.first.empty()))
            cell.first = described(i, volley.rays[i], hit, expected, judgement, query);
        isBroken = isBroken || breaks;
    }
    for (const StepCount& steps : traced.steps) cell.mostSteps = std::max(cell.mostSteps, steps.inner + steps.leaves);
}

std::string whyBroken(const Cell& cell) {
    const auto told = [](uint64_t n, const char* what) { return std::to_string(n) + " " + what; };
    std::string why;
    const auto add = [&](const std::string& reason) { why += (why.empty() ? "" : ", ") + reason; };
    if (cell.wrong > 0) add(told(cell.wrong, "wrong"));
    if (cell.missed > 0) add(told(cell.missed, "missed"));
    if (cell.falseHits > 0) add(told(cell.falseHits, "false"));
    if (cell.differing > 0)
        add(told(cell.differing, cell.byBruteForce ? "not as by brute force" : "not as by the first builder"));
    if (cell.capped > 0) add(told(cell.capped, "stopped by the step cap"));
    const double most = std::ceil(kMostUndecided * static_cast<double>(cell.rays));
    if (!cell.isEdgeFamily && static_cast<double>(cell.undecided) > most) add(told(cell.undecided, "undecided"));
    return why;
}

void requireWithinBounds(std::span<const Cell> cells) {
    const Cell* first = nullptr;
    uint64_t broken = 0;
    for (const Cell& cell : cells) {
        if (whyBroken(cell).empty()) continue;
        if (first == nullptr) first = &cell;
        ++broken;
    }
    if (first == nullptr) return;
    throw Error("stability: " + std::to_string(broken) + " of " + std::to_string(cells.size()) +
                " cells are out of bounds, first: " + first->scene + ", " + first->builder + ", " + first->traversal +
                ", " + first->family + ": " + whyBroken(*first) + " of " + std::to_string(first->rays) + " rays" +
                (first->first.empty() ? "" : "; " + first->first) + "; please report this case");
}

}  // namespace cleave
