// Measurements of a scene by `cleave bench --survey`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "builders/builders.h"
#include "figures/names.h"
#include "figures/survey_published.h"
#include "judge/oracle.h"
#include "measure/statistics.h"
#include "measure/straddling.h"

namespace cleave {

// A builder with some settings. Each vector has an entry per run, in ms, or none where that was not measured.
struct SurveyVariant {
    std::vector<double> oneThread;   // builds with one thread; CPU builders only
    std::vector<double> oneCpu;      // the processor's time of these: others' load does not count
    std::vector<double> allThreads;  // with --threads; GPU: on the device
    std::vector<double> upload;      // of the tree; none for GPU builds
    std::vector<double> primary;     // rays on the device, restart traversal
    std::vector<double> diffuse;
    double rayCost = 0.0;  // what the SAH predicts, counted: costs of nodes visited and triangles tested, per ray
    TreeStatistics statistics;
    std::string hash;
    CheckResult check;  // of the rays that were judged before any time was taken
};

struct SurveyBuilder {
    Builder builder = Builder::exact;
    SurveyVariant ours;                 // with the settings that were asked for
    std::optional<SurveyVariant> pure;  // without what goes beyond the survey; of builders that do
};

// A median builder's tree. Costs as of SurveyVariant, but of a part of its rays.
struct MedianTree {
    Builder builder;
    AxisChoice axes;
    uint32_t leafSize;
    std::optional<double> sahCost;
    double rayCost;
    uint64_t references;
};
// The median builders with every rule of axes and several leaf sizes, and exact's costs.
struct SurveyMedians {
    std::optional<double> exactSahCost;
    double exactRayCost = 0.0;
    std::vector<MedianTree> trees;
};
// The leaf sizes that are tried.
inline constexpr std::array<uint32_t, 4> kMedianLeafSizes{1, 4, 16, 64};

// Counts of the exact builds when they sort in all nodes, and how their tree's planes cut triangles.
struct SurveyComplexity {
    BuildReport once;     // exact
    BuildReport perNode;  // exact-nlog2n
    StraddlingLaw straddling;
    double worstCut = 0.0;  // largest straddling / sqrt(triangles) among nodes of 64 triangles and more
};

struct SurveyScene {
    std::string name;                    // of the file, without folder and extension
    const SurveyModel* model = nullptr;  // that it is or stands in for
    bool standsIn = false;               // its name is not the model's
    uint64_t triangles = 0;              // of the tree: those left out are not counted
    uint64_t rays = 0;                   // per set
    std::vector<SurveyBuilder> builders;
    SurveyMedians medians;
    SurveyComplexity complexity;

    // Null if the builder was not measured.
    const SurveyBuilder* find(std::string_view builder) const;
};

}  // namespace cleave
