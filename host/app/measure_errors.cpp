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

// `exact` is first: the others are measured against it, and its answers start the secondary rays.
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

class Measurement {
  public:
    Measurement(Run& run, Session& session, const std::string& name) : run_(run), session_(session) {
        errors_.name = name;
        errors_.triangles = session.posed().triangles.size();
        sets_[0].rays = primaryRays(session.worldBounds(), run.options.interior, raySetSize(run.options));
    }

    SceneErrors all() {
        for (const Builder builder : kBuilders) measureDefaults(builder);
        if (!run_.options.quick)
            for (const Variant& v : variants(run_.options.settings))
                addTree(session_.buildTimed(v.builder, run_.options.runs, v.settings), v.name);
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
    double exactTrace_ = 0.0;

    void measureDefaults(Builder builder) {
        BuiltTree built = session_.buildTimed(builder, run_.options.runs);
        if (builder == Builder::exact) exactCost_ = built.statistics.sahCost;
        addTree(built, "defaults");
        const DeviceTree& tree = session_.upload(built);
        addRays(built, tree);
        if (builder == Builder::exact && run_.options.peers) errors_.peers = benchPeers(run_, session_, built, sets_);
        if (builder == Builder::gpu) addHits(tree);
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

    std::array<SetFigures, kRaySets.size()> trace(const DeviceTree& tree, Traversal traversal, TriangleTest test,
                                                  uint64_t judged) {
        const bool first = sets_[0].hits.empty();
        std::array<SetFigures, kRaySets.size()> figures;
        for (size_t i = 0; i < sets_.size(); ++i) {
            figures[i] = measureSet(run_, session_, tree, sets_[i], {sets_[i].query, traversal, test, false},
                                    kRaySets[i], judged, first ? &sets_[i].hits : nullptr);
            if (i == 0 && first) makeSecondaryRays(sets_, session_, raySetSize(run_.options));
        }
        return figures;
    }

    void addRays(const BuiltTree& built, const DeviceTree& tree) {
        const auto figures = trace(tree, run_.traversal(), TriangleTest::watertight, raysToJudge(run_.options));
        RayTimes times{nameOf(built.builder), spreadOf(built.runs), {}, sumOf(figures)};
        for (size_t i = 0; i < figures.size(); ++i)
            if (!figures[i].runs.empty()) times.sets[i] = spreadOf(figures[i].runs);
        if (built.builder == Builder::exact) exactTrace_ = times.all.median;
        ErrorRow made = row(built.builder, "defaults");
        made.error = percentAbove(times.all.median, exactTrace_);
        made.errorLow = percentAbove(times.all.low, exactTrace_);
        made.errorHigh = percentAbove(times.all.high, exactTrace_);
        made.time = times.build;
        errors_.rays.push_back(made);
        errors_.rayTimes.push_back(times);
    }

    void addHits(const DeviceTree& tree) {
        const uint64_t judged = run_.options.check > 0 ? run_.options.check
                                : run_.options.quick   ? kQuickJudged
                                                       : kJudged;
        for (const auto& [traversalName, traversal] : kTraversals)
            for (const auto& [testName, test] : kTriangleTests) {
                const auto figures = trace(tree, traversal, test, judged);
                JudgedRays rays;
                for (const SetFigures& set : figures) {
                    rays.judged += set.check.rays;
                    rays.wrong += set.check.mismatches;
                    rays.undecided += set.check.undecided;
                    rays.traced += set.rays;
                }
                ErrorRow made = row(Builder::gpu, std::string(traversalName) + ", " + testName);
                made.error = 1e6 * static_cast<double>(rays.wrong) / static_cast<double>(rays.judged);
                made.errorLow = made.errorHigh = made.error;
                made.time = sumOf(figures);
                errors_.hits.push_back(made);
                errors_.judged.push_back(rays);
            }
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
