#include "support/query_check.h"

#include <algorithm>
#include <cstring>
#include <functional>

#include "builders/builder_names.h"
#include "judge/oracle.h"
#include "judge/validate.h"
#include "run/gpu_builder.h"
#include "run/tracer.h"
#include "twin/twin_builder.h"

namespace cleave::test {
namespace {

std::string textOf(const Hit& hit) {
    if (hit.prim == kNone) return "a miss";
    return "triangle " + std::to_string(hit.prim) + " at t = " + std::to_string(double{hit.t}) + " (u " +
           std::to_string(double{hit.u}) + ", v " + std::to_string(double{hit.v}) + ")";
}

bool isSame(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Whether the triangle that an any-hit names is hit there, by the shared triangle function.
bool isHitOf(const TriangleSet& set, const Ray& ray, const Hit& hit) {
    if (hit.prim >= set.triangles.size()) return false;
    TriangleSet one = {{set.triangles[hit.prim]}, {0}, set.bounds, set.exponent, 0, 0};
    Hit own = bruteForce(one, ray, Query::closest);
    if (own.prim == 0) own.prim = hit.prim;
    return std::find(set.included.begin(), set.included.end(), hit.prim) != set.included.end() && isSame(own, hit);
}

using Failure = std::optional<QueryFailure>;

}  // namespace

struct QueryCheck::Impl {
    explicit Impl(Device& d) : device(d), builder(d), tracer(d) {}

    Device& device;
    GpuBuilder builder;
    Tracer tracer;
    Counts counts;

    std::vector<Hit> wanted(const TriangleSet& set, const QueryCase& c) const {
        std::vector<Hit> hits;
        for (const Ray& ray : c.rays) hits.push_back(bruteForce(set, ray, Query::closest));
        return hits;
    }

    Failure judge(const QueryCase& c, const TriangleSet& set, const std::vector<Hit>& hits) {
        const Reference reference(c.triangles, set.included);
        for (size_t i = 0; i < hits.size(); ++i) {
            const auto verdict = reference.judge(c.rays[i], hits[i], Query::closest).verdict;
            counts.undecided += verdict == Reference::Verdict::undecided ? 1 : 0;
            if (verdict == Reference::Verdict::mismatch)
                return QueryFailure{i, "the reference contradicts brute force, which has " + textOf(hits[i])};
        }
        return {};
    }

    Failure trace(const QueryCase& c, const TriangleSet& set, const std::vector<Hit>& hits, const DeviceTree& tree,
                  const std::string& treeName) {
        struct Mode {
            const char* name;
            TraceMode mode;
        };
        // The unfiltered test is the default one without the filter that throws out clear misses: the same answers.
        const Mode modes[] = {{"restart", {Query::closest, Traversal::restart, TriangleTest::watertight}},
                              {"stack", {Query::closest, Traversal::stack, TriangleTest::watertight}},
                              {"short stack", {Query::closest, Traversal::shortStack, TriangleTest::watertight}},
                              {"unfiltered", {Query::closest, Traversal::restart, TriangleTest::unfiltered}}};
        for (const Mode& m : modes) {
            const std::string name = treeName + ", " + m.name;
            TraceMode anyMode = m.mode;
            anyMode.query = Query::any;
            const Tracer::Result closest = tracer.trace(tree, c.rays, m.mode);
            const Tracer::Result any = tracer.trace(tree, c.rays, anyMode);
            counts.traced += 2 * c.rays.size();
            for (size_t i = 0; i < hits.size(); ++i)
                if (Failure f = compare(c, set, i, hits[i], closest.hits[i], any.hits[i], name)) return f;
            if (closest.invalidRays != invalidRays(c) || any.invalidRays != invalidRays(c))
                return QueryFailure{0, name + ": " + std::to_string(closest.invalidRays) + " and " +
                                           std::to_string(any.invalidRays) + " invalid rays counted of " +
                                           std::to_string(invalidRays(c))};
            if (closest.cappedRays + any.cappedRays != 0) return QueryFailure{0, name + ": a ray was given up"};
        }
        return {};
    }

    static uint64_t invalidRays(const QueryCase& c) {
        return static_cast<uint64_t>(
            std::count_if(c.rays.begin(), c.rays.end(), [](const Ray& r) { return !isValidRay(r); }));
    }

    static Failure compare(const QueryCase& c, const TriangleSet& set, size_t i, const Hit& want, const Hit& closest,
                           const Hit& any, const std::string& name) {
        if (!isSame(want, closest))
            return QueryFailure{i, name + ": " + textOf(closest) + ", brute force: " + textOf(want)};
        const bool isRight = any.prim == kNone ? isSame(any, want) : isSame(any, want) || isHitOf(set, c.rays[i], any);
        if (!isRight) return QueryFailure{i, name + ", any hit: " + textOf(any) + ", brute force: " + textOf(want)};
        return {};
    }

    Failure checkTree(const QueryCase& c, const TriangleSet& set, const KdTree& tree, const std::string& name) {
        // The tree of `brute` is one leaf, whatever the depth.
        const ValidationReport report = validate(tree, set, depthLimit(c.settings, set.included.size()));
        if (!report.ok()) return QueryFailure{0, name + ": not a valid tree: " + report.errors.front()};
        return {};
    }

    Failure check(const QueryCase& c) {
        const TriangleSet set = makeTriangleSet(c.triangles);
        const std::vector<Hit> hits = wanted(set, c);
        if (Failure f = judge(c, set, hits)) return f;
        const DeviceTriangles triangles(device, c.triangles);
        const auto onDevice = builder.build(triangles, c.settings).tree;
        const KdTree twin = buildTwin(set, c.settings).tree;
        const KdTree built = readBack(*onDevice);
        if (treeHash(built) != treeHash(twin)) return QueryFailure{0, "gpu: its tree is not the twin's"};
        if (Failure f = checkTree(c, set, built, "gpu")) return f;
        if (Failure f = trace(c, set, hits, *onDevice, "gpu")) return f;
        for (const TreeBuilder& cpu : cpuBuilders()) {
            const KdTree tree = cpu.build(set, c.settings).tree;
            const std::string name(cpu.name);
            if (Failure f = checkTree(c, set, tree, name)) return f;
            if (Failure f = trace(c, set, hits, *uploadTree(device, set, tree), name)) return f;
        }
        ++counts.scenes;
        counts.pairs += c.rays.size();
        for (const Hit& hit : hits) counts.hits += hit.prim != kNone ? 1 : 0;
        return {};
    }
};

QueryCheck::QueryCheck(Device& device) : impl_(std::make_unique<Impl>(device)) {}
QueryCheck::~QueryCheck() = default;

Failure QueryCheck::firstFailure(const QueryCase& c) { return impl_->check(c); }

const QueryCheck::Counts& QueryCheck::counts() const { return impl_->counts; }

QueryCase QueryCheck::shrunk(const QueryCase& failing) {
    QueryCase small = failing;
    const Failure failure = impl_->check(small);
    if (!failure) return small;
    small.rays = {failing.rays[failure->ray]};
    if (!impl_->check(small)) small.rays = failing.rays;  // it takes several rays
    for (size_t i = small.triangles.size(); i-- > 0;) {
        QueryCase less = small;
        less.triangles.erase(less.triangles.begin() + static_cast<std::ptrdiff_t>(i));
        if (!less.triangles.empty() && impl_->check(less)) small = less;
    }
    return small;
}

}  // namespace cleave::test
