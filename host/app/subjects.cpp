#include "app/subjects.h"

#include <array>

#include "base/text.h"
#include "figures/scene_errors.h"

namespace cleave {
namespace {

// `exact` is first: the others are measured against it, and its answers start the secondary rays. `gpu` is the second.
constexpr std::array<Builder, 8> kBuilders{{Builder::exact,
                                            Builder::gpu,
                                            {"hunt-all"},
                                            {"hunt-hybrid"},
                                            {"hunt-one"},
                                            {"shevtsov"},
                                            {"object-median"},
                                            {"spatial-median"}}};

template <class Change>
Subject variant(Builder builder, const std::string& name, BuildSettings settings, Change change) {
    change(settings);
    return {builder, name, settings, false, {}, {}};
}

Subject withCost(Builder builder, float intersect, const BuildSettings& defaults) {
    return variant(builder, "costs 15 : " + fixed(intersect, 0), defaults,
                   [intersect](BuildSettings& s) { s.costs.intersect = intersect; });
}

// What trades error for time in the builders that have something to set, one at a time.
std::vector<Subject> variants(const BuildSettings& defaults) {
    std::vector<Subject> all;
    for (const Builder builder : {Builder::gpu, Builder{"shevtsov"}}) {
        for (const uint32_t bins : {8u, 16u, 128u, 512u})
            if (bins <= kBins || builder != Builder::gpu)
                all.push_back(variant(builder, "bins " + std::to_string(bins), defaults,
                                      [bins](BuildSettings& s) { s.bins = bins; }));
        all.push_back(variant(builder, "subsample off", defaults, [](BuildSettings& s) { s.subsample = false; }));
    }
    for (const uint32_t size : {0u, 32u, 256u})
        all.push_back(variant(Builder::gpu, "exact-up-to " + std::to_string(size), defaults,
                              [size](BuildSettings& s) { s.exactUpTo = size; }));
    for (const Builder builder :
         {Builder::exact, Builder::gpu, Builder{"hunt-all"}, Builder{"hunt-one"}, Builder{"shevtsov"}}) {
        all.push_back(variant(builder, "clip off", defaults, [](BuildSettings& s) { s.clip = false; }));
        if (builder == Builder::exact) {
            all.push_back(
                variant(builder, "stop sa-n", defaults, [](BuildSettings& s) { s.stop = StopRule::equation41; }));
            all.push_back(
                variant(builder, "empty-bonus 1", defaults, [](BuildSettings& s) { s.costs.emptyBonus = 1.0f; }));
        } else {
            all.push_back(variant(builder, "snap off", defaults, [](BuildSettings& s) { s.snap = false; }));
        }
    }
    for (const float cost : {5.0f, 10.0f, 40.0f}) all.push_back(withCost(Builder::gpu, cost, defaults));
    for (const Builder builder : {Builder{"object-median"}, Builder{"spatial-median"}}) {
        for (const uint32_t size : {2u, 8u, 16u})
            all.push_back(variant(builder, "leaf-size " + std::to_string(size), defaults,
                                  [size](BuildSettings& s) { s.leafSize = size; }));
        all.push_back(variant(builder, "axes widest", defaults, [](BuildSettings& s) { s.axes = AxisChoice::widest; }));
        all.push_back(variant(builder, "axes all", defaults, [](BuildSettings& s) { s.axes = AxisChoice::all; }));
    }
    return all;
}

}  // namespace

std::vector<Subject> subjectsOf(const Options& options) {
    std::vector<Subject> all;
    for (const Builder builder : kBuilders) all.push_back({builder, kDefaultSettings, options.settings, true, {}, {}});
    // Traced as well, for the fit of costs to have trees of more nodes and of more tests.
    for (const float cost : options.quick ? std::vector{5.0f, 80.0f} : std::vector{2.0f, 5.0f, 10.0f, 40.0f, 80.0f}) {
        all.push_back(withCost(Builder::exact, cost, options.settings));
        all.back().isTraced = true;
    }
    if (!options.quick)
        for (Subject& subject : variants(options.settings)) all.push_back(std::move(subject));
    return all;
}

}  // namespace cleave
