#include "app/measure_errors.h"

#include <algorithm>

#include "app/bench_peers.h"
#include "app/bench_rays.h"
#include "app/session.h"
#include "base/error.h"

namespace cleave {
namespace {

constexpr uint32_t kQuickRaySetSize = 512;
// Rays of a set that are judged where errors are counted; elsewhere as many as in a benchmark.
constexpr uint64_t kJudged = 65536, kQuickJudged = 8192;

// `exact` is first: the others are measured against it, and its answers start the secondary rays. `gpu` is the second.
constexpr std::array<Builder, 8> kBuilders{{Builder::exact,
                                            Builder::gpu,
                                            {"hunt-all"},
                                            {"hunt-hybrid"},
                                            {"hunt-one"},
                                            {"shevtsov"},
                                            {"object-median"},
                                            {"spatial-median"}}};

struct Variant {
    Builder builder;
    std::string name;
    BuildSettings settings;
};

template <class Change>
Variant variant(Builder builder, const std::string& name, BuildSettings settings, Change change) {
    change(settings);
    return {builder, name, settings};
}

// What trades error for time in the builders that have something to set, one at a time.
std::vector<Variant> variants(const BuildSettings& defaults) {
    std::vector<Variant> all;
    for (const Builder builder : {Builder::gpu, Builder{"shevtsov"}}) {
        for (const uint32_t bins : {8u, 16u})
            all.push_back(variant(builder, "bins " + std::to_string(bins), defaults,
                                  [bins](BuildSettings& s) { s.bins = bins; }));
        all.push_back(variant(builder, "subsample off", defaults, [](BuildSettings& s) { s.subsample = false; }));
        all.push_back(variant(builder, "clip off", defaults, [](BuildSettings& s) { s.clip = false; }));
    }
    all.push_back(variant(Builder::gpu, "exact-up-to 32", defaults, [](BuildSettings& s) { s.exactUpTo = 32; }));
    for (const Builder builder : {Builder{"object-median"}, Builder{"spatial-median"}})
        for (const uint32_t size : {2u, 8u, 16u})
            all.push_back(variant(builder, "leaf-size " + std::to_string(size), defaults,
                                  [size](BuildSettings& s) { s.leafSize = size; }));
    return all;
}

double percentAbove(double value, double base) { return 100.0 * (value / base - 1.0); }

Spread sumOf(const std::array<SetFigures, kRaySets.size()>& sets) {
    std::vector<double> sums;
    for (const SetFigures& set : sets) {
        sums.resize(std::max(sums.size(), set.runs.size()));
        for (size_t i = 0; i < set.runs.size(); ++i) sums[i] += set.runs[i];
    }
    return spreadOf(sums);
}

using AllSets = std::array<SetFigures, kRaySets.size()>;

// What traces the sets of rays, and how long that takes.
struct Tracing {
    std::shared_ptr<DeviceTree> tree;
    Traversal traversal = Traversal::stack;
    TriangleTest test = TriangleTest::watertight;
    AllSets figures;
};

class Measurement {
  public:
    Measurement(Run& run, Session& session, const std::string& name) : run_(run), session_(session) {
        errors_.name = name;
        errors_.triangles = session.posed().triangles.size();
        sets_[0].rays = primaryRays(session.worldBounds(), run.options.interior, raySetSize(run.options));
    }

    SceneErrors all() {
        std::vector<Tracing> byTree;
        for (const Builder builder : kBuilders) byTree.push_back(firstTurn(builder));
        secondTurn(byTree);
        for (size_t i = 0; i < byTree.size(); ++i) addRays(kBuilders[i], byTree[i].figures, byTree[0].figures);
        const std::shared_ptr<DeviceTree> ofGpu = byTree[1].tree;
        byTree.clear();
        addHits(ofGpu);
        if (!run_.options.quick)
            for (const Variant& v : variants(run_.options.settings)) addTree(buildTimed(v.builder, v.settings), v.name);
        markPareto(errors_.tree);
        markPareto(errors_.rays);
        markPareto(errors_.hits);
        return std::move(errors_);
    }

  private:
    Run& run_;
    Session& session_;
    SceneErrors errors_;
    RaySets sets_;
    std::optional<double> exactCost_;
    std::vector<Spread> builds_;  // by builder, at the defaults

    // Runs are split into two turns, the second in the opposite order: what changes as time goes by, as clocks and
    // other work of the machine do, then disturbs all about alike.
    uint32_t runsOfFirstTurn() const { return (run_.options.runs + 1) / 2; }

    // The first build on the CPU starts threads and touches memory for all that follow: it is not counted, as on the
    // device nothing is before the warm-up.
    BuiltTree buildTimed(Builder builder, const BuildSettings& settings) {
        if (builder == Builder::gpu) return session_.buildTimed(builder, run_.options.runs, settings);
        BuiltTree built = session_.buildTimed(builder, run_.options.runs + 1, settings);
        built.runs.erase(built.runs.begin());
        built.ms = medianOf(built.runs);
        return built;
    }

    Tracing firstTurn(Builder builder) {
        BuiltTree built = buildTimed(builder, run_.options.settings);
        if (builder == Builder::exact) exactCost_ = built.statistics.sahCost;
        addTree(built, "defaults");
        builds_.push_back(spreadOf(built.runs));
        session_.upload(built);
        Tracing tracing{built.onDevice, run_.traversal(), TriangleTest::watertight, {}};
        trace(tracing, raysToJudge(run_.options));
        if (builder == Builder::exact && run_.options.peers) errors_.peers = benchPeers(run_, session_, built, sets_);
        return tracing;
    }

    void secondTurn(std::vector<Tracing>& all) {
        const uint32_t runs = run_.options.runs - runsOfFirstTurn();
        if (runs == 0) return;
        for (size_t n = all.size(); n-- > 0;)
            for (size_t i = 0; i < sets_.size(); ++i) {
                if (sets_[i].rays.empty()) continue;
                run_.progress.phase(std::string("timing ") + kRaySets[i] + " rays");
                const TraceMode mode{sets_[i].query, all[n].traversal, all[n].test, false};
                std::vector<double>& times = all[n].figures[i].runs;
                const std::vector<double> more = run_.device.tracer().time(*all[n].tree, sets_[i].rays, mode, runs);
                times.insert(times.end(), more.begin(), more.end());
            }
    }

    // The first to be traced gives the answers that secondary rays start from.
    void trace(Tracing& tracing, uint64_t judged) {
        const bool first = sets_[0].hits.empty();
        for (size_t i = 0; i < sets_.size(); ++i) {
            const TraceMode mode{sets_[i].query, tracing.traversal, tracing.test, false};
            tracing.figures[i] = measureSet(run_, session_, *tracing.tree, sets_[i], mode, kRaySets[i],
                                            runsOfFirstTurn(), judged, first ? &sets_[i].hits : nullptr);
            if (i == 0 && first) makeSecondaryRays(sets_, session_, raySetSize(run_.options));
        }
    }

    ErrorRow row(Builder builder, const std::string& settings) const {
        ErrorRow made;
        made.scene = errors_.name;
        made.builder = nameOf(builder);
        made.settings = settings;
        return made;
    }

    void addTree(const BuiltTree& built, const std::string& settings) {
        const std::optional<double> cost = built.statistics.sahCost;
        if (!cost || !exactCost_ || !(*exactCost_ > 0.0)) {
            errors_.withoutCost.push_back(nameOf(built.builder));
            return;
        }
        ErrorRow made = row(built.builder, settings);
        made.error = made.errorLow = made.errorHigh = percentAbove(*cost, *exactCost_);
        made.time = spreadOf(built.runs);
        errors_.tree.push_back(made);
    }

    void addRays(Builder builder, const AllSets& figures, const AllSets& ofExact) {
        RayTimes times{nameOf(builder), builds_[errors_.rays.size()], {}, sumOf(figures)};
        for (size_t i = 0; i < figures.size(); ++i)
            if (!figures[i].runs.empty()) times.sets[i] = spreadOf(figures[i].runs);
        const double base = sumOf(ofExact).median;
        ErrorRow made = row(builder, "defaults");
        made.error = percentAbove(times.all.median, base);
        made.errorLow = percentAbove(times.all.low, base);
        made.errorHigh = percentAbove(times.all.high, base);
        made.time = times.build;
        errors_.rays.push_back(made);
        errors_.rayTimes.push_back(times);
    }

    void addHits(const std::shared_ptr<DeviceTree>& tree) {
        const uint64_t judged = run_.options.check > 0 ? run_.options.check
                                : run_.options.quick   ? kQuickJudged
                                                       : kJudged;
        std::vector<Tracing> ways;
        for (const auto& [traversalName, traversal] : kTraversals)
            for (const auto& [testName, test] : kTriangleTests) {
                ways.push_back({tree, traversal, test, {}});
                trace(ways.back(), judged);
            }
        secondTurn(ways);
        for (const Tracing& way : ways) addHitRow(way);
    }

    void addHitRow(const Tracing& way) {
        JudgedRays rays;
        for (const SetFigures& set : way.figures) {
            rays.judged += set.check.rays;
            rays.wrong += set.check.mismatches;
            rays.undecided += set.check.undecided;
            rays.traced += set.rays;
        }
        ErrorRow made = row(Builder::gpu, nameOf(way.traversal) + ", " + nameOf(way.test));
        made.error = 1e6 * static_cast<double>(rays.wrong) / static_cast<double>(rays.judged);
        made.errorLow = made.errorHigh = made.error;
        made.time = sumOf(way.figures);
        errors_.hits.push_back(made);
        errors_.judged.push_back(rays);
    }
};

}  // namespace

uint32_t raySetSize(const Options& options) { return options.quick ? kQuickRaySetSize : kRaySetSize; }

SceneErrors measureErrors(Run& run, const std::filesystem::path& file, const std::string& name) {
    Session session(run, file);
    if (session.set().included.empty())
        throw Error(file.string() +
                    ": no triangle that rays can hit, so there is nothing to measure; name another scene");
    return Measurement(run, session, name).all();
}

}  // namespace cleave
