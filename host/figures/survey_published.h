// The figures that the survey's tables print, as it prints them: models and machines of 2006 and 2007.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cleave {

struct SurveyModel {
    std::string_view name;
    std::string_view triangles;  // as printed: "69k"
    double triangleCount;        // the same as a number
};
// In the order of table 5.1.
std::span<const SurveyModel> surveyModels();

// The model that a scene is, or stands in for: its name begins with the model's (in any case) and it has as many
// triangles, to within 2 %. Null if there is none.
const SurveyModel* surveyModelOf(std::string_view sceneName, uint64_t triangles);

enum class SurveyTable {
    exactBuilds,     // 5.1: seconds of exact-nlog2n and exact (Wald and Havran 2006)
    huntBuilds,      // 6.1: seconds of hunt-all, hunt-hybrid, hunt-one and exact (Hunt et al. 2006)
    huntRendering,   // 6.2: rendering time over exact's, per cent more
    shevtsovToImage  // 7.1: seconds to the image, exact and shevtsov (Shevtsov et al. 2007)
};
std::optional<double> publishedFigure(SurveyTable table, std::string_view model, std::string_view builder);
// Whether the table has a row for the model.
bool isPublished(SurveyTable table, std::string_view model);

}  // namespace cleave
