#include "app/measure_errors.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "app/bench_peers.h"
#include "app/bench_rays.h"
#include "app/measure_paths.h"
#include "app/session.h"
#include "app/subjects.h"
#include "app/tree_portrait.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "figures/error_rows.h"
#include "figures/timing.h"
#include "run/device_builders.h"

namespace cleave {
namespace {

constexpr uint32_t kQuickRaySetSize = 512;
// Rays of a set that are judged where errors are counted; elsewhere as many as in a benchmark.
constexpr uint64_t kJudged = 65536, kQuickJudged = 8192;

TreeErrors errorsOf(const Subject& subject, const BuiltTree& built, SahCosts costs) {
    const TreeStatistics s = computeStatistics(built.tree, costs);
    TreeErrors figures;
    figures.builder = nameOf(subject.builder);
    figures.settings = subject.settings;
    figures.runs = built.runs;
    figures.hasCost = s.sahCost.has_value();
    figures.sahCost = s.sahCost.value_or(0.0);
    figures.expected = {s.expectedInner.value_or(0.0), s.expectedLeaves.value_or(0.0),
                        s.expectedTriangles.value_or(0.0)};
    figures.nodes = s.nodes;
    figures.references = s.references;
    figures.leafHistogram = s.leafHistogram;
    figures.depthHistogram = s.depthHistogram;
    return figures;
}

constexpr const char* kAllRays = "all";

// The rays of a set, or all, through a tree.
std::optional<WorkSample> sampleOf(const TracedErrors& traced, std::optional<size_t> set) {
    const uint64_t rays = set ? traced.sets[*set].rays : sumOf(traced.sets).rays;
    if (rays == 0) return std::nullopt;
    double ms = 0.0;
    for (size_t k = 0; k < kRaySets.size(); ++k)
        if (!traced.sets[k].runs.empty() && (!set || *set == k)) ms += medianOf(traced.sets[k].runs);
    const RayCounts counts = set ? traced.counts[*set] : meanCounts(traced);
    return WorkSample{counts.inner, counts.triangles, 1e6 * ms / static_cast<double>(rays)};
}

// Medians know no costs, and their trees are unlike those that a fit is for.
bool isFitted(const TreeErrors& tree) { return tree.builder.find("median") == std::string::npos; }

std::vector<NamedFit> fitsOf(const SceneErrors& errors) {
    std::vector<NamedFit> fits;
    for (size_t k = 0; k <= kRaySets.size(); ++k) {
        const bool all = k == kRaySets.size();
        std::vector<WorkSample> samples;
        for (const TracedErrors& traced : errors.traced)
            if (const auto sample = sampleOf(traced, all ? std::nullopt : std::optional(k));
                sample && isFitted(errors.trees[traced.tree]))
                samples.push_back(*sample);
        if (const std::optional<FittedCosts> costs = fitCosts(samples))
            fits.push_back({all ? kAllRays : kRaySets[k], *costs});
    }
    return fits;
}

// Figures of another scene under the same name, or of one that has been edited, are not this one's.
std::string fingerprintOf(const PosedScene& scene) {
    Hash hash;
    for (const Triangle& t : scene.triangles)
        for (const vec3& v : {t.a, t.b, t.c})
            for (int axis = 0; axis < 3; ++axis) {
                uint32_t word = 0;
                std::memcpy(&word, &v[axis], sizeof word);
                hash.add(word);
            }
    return hash.text();
}

class Measurement {
  public:
    Measurement(Run& run, Session& session, Notebook& notebook, const std::string& name)
        : run_(run),
          session_(session),
          notebook_(notebook),
          prefix_(fingerprintOf(session.posed()) + " "),
          subjects_(subjectsOf(run.options)),
          portrait_(run, session) {
        errors_.name = name;
        errors_.triangles = session.posed().triangles.size();
        sets_[0].rays = primaryRays(session.worldBounds(), run.options.interior, raySetSize(run.options));
    }

    SceneErrors all() {
        for (size_t i = 0; i < subjects_.size(); ++i) firstTurn(i);
        addFitted();
        for (size_t i = subjects_.size(); i-- > 0;) secondTurn(i);
        addWays();
        addPaths();
        if (run_.options.peers) addPeers();
        run_.progress.within("");
        return std::move(errors_);
    }

  private:
    Run& run_;
    Session& session_;
    Notebook& notebook_;
    const std::string prefix_;
    std::vector<Subject> subjects_;
    TreePortrait portrait_;
    SceneErrors errors_;
    RaySets sets_;
    std::map<size_t, BuiltTree> kept_;  // trees that rays go through, by subject
    size_t step_ = 0;

    template <class Measure>
    auto once(const std::string& what, Measure measure) {
        return notebook_.once(prefix_ + what, measure);
    }

    void begin(const std::string& what) {
        const size_t ways = kTraversals.size() * kTriangleTests.size();
        const size_t steps = 2 * (subjects_.size() + ways) + (run_.options.peers ? 2 : 1);
        run_.progress.within(oneLine(errors_.name) + ", step " + std::to_string(++step_) + " of " +
                             std::to_string(steps) + ", " + what);
    }

    // Runs are split into two turns, the second in the opposite order: what changes as time goes by, as clocks and
    // other work of the machine do, then disturbs all about alike.
    uint32_t runsOfTurn(bool first) const {
        const uint32_t ofFirst = (run_.options.runs + 1) / 2;
        return first ? ofFirst : run_.options.runs - ofFirst;
    }

    // A failure is told in the report, and the others go on; without `exact` there is nothing to measure against.
    template <class Measure>
    void tried(size_t i, Measure measure) {
        try {
            measure();
        } catch (const Error& error) {
            if (i == kOfExact) throw;
            errors_.leftOut.emplace_back(subjects_[i].name(), error.what());
        } catch (const std::bad_alloc&) {
            if (i == kOfExact) throw;
            errors_.leftOut.emplace_back(subjects_[i].name(), "out of memory");
        }
    }

    // The tree of a subject on the device; built without taking its time where that is known from an earlier run.
    const BuiltTree& treeOf(size_t i) {
        if (const auto kept = kept_.find(i); kept != kept_.end()) return kept->second;
        return keep(i, session_.build(subjects_[i].builder, subjects_[i].build));
    }
    const BuiltTree& keep(size_t i, BuiltTree built) {
        session_.upload(built);
        return kept_.emplace(i, std::move(built)).first->second;
    }

    // The first build on the CPU starts threads and touches memory for all that follow: it is not counted, as on the
    // device nothing is before the warm-up.
    static uint32_t notCounted(const Subject& subject) { return isOnDevice(subject.builder.name) ? 0 : 1; }

    BuiltTree buildTimed(const Subject& subject, uint32_t runs) {
        BuiltTree built = session_.buildTimed(subject.builder, runs + notCounted(subject), subject.build);
        built.runs.erase(built.runs.begin(), built.runs.begin() + notCounted(subject));
        return built;
    }
    std::vector<double> timeBuilds(const Subject& subject, uint32_t runs) {
        std::vector<double> times = session_.timeBuilds(subject.builder, runs + notCounted(subject), subject.build);
        times.erase(times.begin(), times.begin() + notCounted(subject));
        return times;
    }

    void firstTurn(size_t i) {
        begin(subjects_[i].name());
        tried(i, [&] {
            Subject& subject = subjects_[i];
            errors_.trees.push_back(once("tree of " + subject.name(), [&] {
                BuiltTree built = buildTimed(subject, runsOfTurn(true));
                TreeErrors figures = errorsOf(subject, built, run_.options.settings.costs);
                if (subject.isTraced) keep(i, std::move(built));
                return figures;
            }));
            subject.tree = errors_.trees.size() - 1;
            if (subject.isTraced) trace(i);
        });
    }

    void trace(size_t i) {
        Subject& subject = subjects_[i];
        TracedErrors traced;
        traced.tree = *subject.tree;
        for (size_t k = 0; k < sets_.size(); ++k) {
            const std::string what = std::string(kRaySets[k]) + " rays through the tree of " + subject.name();
            traced.sets[k] = once(what, [&] {
                const SetErrors figures =
                    measured(i, k, {setOf(k).query, run_.traversal(), TriangleTest::watertight, false},
                             raysToJudge(run_.options));
                if (figures.wrong > 0)
                    throw Error(grouped(figures.wrong) + " of " + grouped(figures.judged) + " " + kRaySets[k] +
                                " rays are answered wrongly; please report this scene");
                return figures;
            });
            traced.counts[k] = once("counts of " + what, [&] { return counted(i, k, run_.traversal()); });
            traced.restartCounts[k] =
                once("counts by restart of " + what, [&] { return counted(i, k, Traversal::restart); });
        }
        traced.lines = once("lines through the tree of " + subject.name(),
                            [&] { return portrait_.lines(treeOf(i), treeOf(kOfExact)); });
        if (subject.settings == kDefaultSettings)
            for (ReportPicture& picture : once("pictures of the tree of " + subject.name(),
                                               [&] { return portrait_.pictures(treeOf(i), treeOf(kOfExact)); }))
                errors_.pictures.push_back(std::move(picture));
        errors_.traced.push_back(traced);
        subject.traced = errors_.traced.size() - 1;
    }

    // The rays of a set. Secondary ones start from the hits of the primary ones.
    const RaySet& setOf(size_t k) {
        if (k > 0 && sets_[0].hits.empty()) {
            sets_[0].hits = run_.device.tracer().trace(*treeOf(kOfExact).onDevice, sets_[0].rays).hits;
            makeSecondaryRays(sets_, session_, raySetSize(run_.options));
        }
        return sets_[k];
    }

    // Judges first, then takes times: those of the first turn.
    SetErrors measured(size_t i, size_t k, const TraceMode& mode, uint64_t judged) {
        const RaySet& set = setOf(k);
        SetErrors figures;
        figures.rays = set.rays.size();
        if (set.rays.empty()) return figures;
        run_.progress.phase(std::string("tracing ") + kRaySets[k] + " rays");
        Tracer& tracer = run_.device.tracer();
        const Tracer::Result traced = tracer.trace(*treeOf(i).onDevice, set.rays, mode);
        if (traced.cappedRays > 0)
            throw Error(grouped(traced.cappedRays) + " rays were given up at the step cap; please report this scene");
        const CheckResult check = session_.check(set.rays, traced.hits, set.query, judged);
        figures.judged = check.rays;
        figures.wrong = check.mismatches;
        figures.missed = check.missed;
        figures.falseHits = check.falseHits;
        figures.undecided = check.undecided;
        figures.largestTError = check.maxRelativeTError;
        figures.runs = timed(i, k, mode, true);
        return figures;
    }

    std::vector<double> timed(size_t i, size_t k, const TraceMode& mode, bool firstTurn) {
        const RaySet& set = setOf(k);
        const uint32_t runs = runsOfTurn(firstTurn);
        if (set.rays.empty() || runs == 0) return {};
        run_.progress.phase(std::string("timing ") + kRaySets[k] + " rays");
        return run_.device.tracer().time(*treeOf(i).onDevice, set.rays, mode, runs);
    }

    RayCounts counted(size_t i, size_t k, Traversal traversal) {
        const RaySet& set = setOf(k);
        if (set.rays.empty()) return {};
        const TraceMode mode{set.query, traversal, TriangleTest::watertight, true};
        const RayWork work = workOf(run_.device.tracer().trace(*treeOf(i).onDevice, set.rays, mode).steps, 1);
        return {work.inner, work.leaves, work.triangles};
    }

    static void append(std::vector<double>& runs, const std::vector<double>& more) {
        runs.insert(runs.end(), more.begin(), more.end());
    }

    void secondTurn(size_t i) {
        if (!subjects_[i].tree || runsOfTurn(false) == 0) return;
        begin(subjects_[i].name() + ", again");
        tried(i, [&] {
            const Subject& subject = subjects_[i];
            append(errors_.trees[*subject.tree].runs, once("second turn of the tree of " + subject.name(),
                                                           [&] { return timeBuilds(subject, runsOfTurn(false)); }));
            if (!subject.traced) return;
            for (size_t k = 0; k < sets_.size(); ++k)
                append(
                    errors_.traced[*subject.traced].sets[k].runs,
                    once("second turn of " + std::string(kRaySets[k]) + " rays through " + subject.name(), [&] {
                        return timed(i, k, {setOf(k).query, run_.traversal(), TriangleTest::watertight, false}, false);
                    }));
        });
    }

    // What nodes and tests take here, by the times of the first turn; and trees that are built for these costs.
    void addFitted() {
        errors_.fits = fitsOf(errors_);
        const auto all = std::find_if(errors_.fits.begin(), errors_.fits.end(),
                                      [](const NamedFit& fit) { return fit.rays == kAllRays; });
        const std::optional<SahCosts> costs = all == errors_.fits.end() ? std::nullopt : sahCostsOf(all->costs);
        if (!costs) return;
        for (const Builder builder : {Builder::exact, Builder::gpu}) {
            Subject subject{builder, "", run_.options.settings, true, {}, {}};
            subject.build.costs = *costs;
            subject.settings = "fitted " + fixed(costs->traverse, 0) + " : " + fixed(costs->intersect, 2);
            subjects_.push_back(subject);
            firstTurn(subjects_.size() - 1);
        }
    }

    // Which subject's tree ways and pictures go through.
    size_t throughTree() const { return subjects_[kOfGpu].traced ? kOfGpu : kOfExact; }

    // All traversals and tests, through the tree of `gpu`, in two turns as well.
    void addWays() {
        const uint64_t judged = run_.options.check > 0 ? run_.options.check
                                : run_.options.quick   ? kQuickJudged
                                                       : kJudged;
        std::vector<std::pair<Traversal, TriangleTest>> ways;
        for (const auto& [traversalName, traversal] : kTraversals)
            for (const auto& [testName, test] : kTriangleTests) ways.emplace_back(traversal, test);
        for (const auto& [traversal, test] : ways) {
            WayErrors way{nameOf(traversal), nameOf(test), {}};
            begin(way.traversal + ", " + way.test);
            for (size_t k = 0; k < sets_.size(); ++k)
                way.sets[k] = once(std::string(kRaySets[k]) + " rays by " + way.traversal + ", " + way.test,
                                   [&, mode = TraceMode{setOf(k).query, traversal, test, false}] {
                                       return measured(throughTree(), k, mode, judged);
                                   });
            errors_.ways.push_back(way);
        }
        if (runsOfTurn(false) == 0) return;
        for (size_t n = ways.size(); n-- > 0;) {
            WayErrors& way = errors_.ways[n];
            begin(way.traversal + ", " + way.test + ", again");
            for (size_t k = 0; k < sets_.size(); ++k)
                append(
                    way.sets[k].runs,
                    once("second turn of " + std::string(kRaySets[k]) + " rays by " + way.traversal + ", " + way.test,
                         [&] {
                             return timed(throughTree(), k, {setOf(k).query, ways[n].first, ways[n].second, false},
                                          false);
                         }));
        }
    }

    void addPaths() {
        begin("pictures of light");
        try {
            MeasuredPaths paths = measurePaths(run_, session_, treeOf(throughTree()), notebook_, prefix_);
            errors_.paths = std::move(paths.errors);
            for (ReportPicture& picture : paths.shown) errors_.pictures.push_back(std::move(picture));
        } catch (const Error& error) {
            errors_.leftOut.emplace_back("pictures of light", error.what());
        }
    }

    void addPeers() {
        begin("other ray tracers");
        errors_.peers = once("peers", [&] {
            for (size_t k = 0; k < sets_.size(); ++k) {
                const TraceMode mode{setOf(k).query, run_.traversal(), TriangleTest::watertight, false};
                sets_[k].hits = run_.device.tracer().trace(*treeOf(kOfExact).onDevice, sets_[k].rays, mode).hits;
            }
            return benchPeers(run_, session_, treeOf(kOfExact), sets_);
        });
    }
};

}  // namespace

uint32_t raySetSize(const Options& options) { return options.quick ? kQuickRaySetSize : kRaySetSize; }

SceneErrors measureErrors(Run& run, Notebook& notebook, const std::filesystem::path& file, const std::string& name) {
    Session session(run, file);
    if (session.set().included.empty())
        throw Error(file.string() +
                    ": no triangle that rays can hit, so there is nothing to measure; name another scene");
    return Measurement(run, session, notebook, name).all();
}

}  // namespace cleave
