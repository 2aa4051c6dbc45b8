#include "figures/survey_published.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace cleave {
namespace {

constexpr SurveyModel kModels[] = {{"bunny", "69k", 69e3},      {"armadillo", "346k", 346e3}, {"dragon", "863k", 863e3},
                                   {"buddha", "1.07m", 1.07e6}, {"blade", "1.76m", 1.76e6},   {"thai", "10m", 10e6},
                                   {"erw6", "804", 804},        {"conf", "282k", 282e3},      {"soda", "2.2m", 2.2e6},
                                   {"PP", "12.7m", 12.7e6}};

struct Figure {
    std::string_view model, builder;
    double value;
};

constexpr Figure kExactBuilds[] = {{"bunny", "exact-nlog2n", 6.7},    {"bunny", "exact", 3.2},
                                   {"armadillo", "exact-nlog2n", 16}, {"armadillo", "exact", 5},
                                   {"dragon", "exact-nlog2n", 46},    {"dragon", "exact", 16},
                                   {"buddha", "exact-nlog2n", 61},    {"buddha", "exact", 21},
                                   {"blade", "exact-nlog2n", 74},     {"blade", "exact", 21},
                                   {"thai", "exact-nlog2n", 1120},    {"thai", "exact", 430},
                                   {"erw6", "exact-nlog2n", 0.060},   {"erw6", "exact", 0.030},
                                   {"conf", "exact-nlog2n", 30.5},    {"conf", "exact", 15.0},
                                   {"soda", "exact-nlog2n", 228},     {"soda", "exact", 104},
                                   {"PP", "exact-nlog2n", 1436},      {"PP", "exact", 559}};
constexpr Figure kHuntBuilds[] = {{"bunny", "hunt-all", 0.25},     {"bunny", "hunt-hybrid", 0.23},
                                  {"bunny", "hunt-one", 0.11},     {"bunny", "exact", 3.2},
                                  {"armadillo", "hunt-all", 1.41}, {"armadillo", "hunt-hybrid", 1.14},
                                  {"armadillo", "hunt-one", 0.69}, {"armadillo", "exact", 5}};
constexpr Figure kHuntRendering[] = {
    {"bunny", "hunt-all", 1.63}, {"bunny", "hunt-hybrid", 1.63}, {"bunny", "hunt-one", 7.72}, {"bunny", "exact", 0}};
constexpr Figure kShevtsovToImage[] = {{"buddha", "exact", 32.3}, {"buddha", "shevtsov", 0.696},
                                       {"bunny", "exact", 4.8},   {"bunny", "shevtsov", 0.104},
                                       {"dragon", "exact", 23.9}, {"dragon", "shevtsov", 0.751}};

std::span<const Figure> figuresOf(SurveyTable table) {
    switch (table) {
        case SurveyTable::exactBuilds:
            return kExactBuilds;
        case SurveyTable::huntBuilds:
            return kHuntBuilds;
        case SurveyTable::huntRendering:
            return kHuntRendering;
        case SurveyTable::shevtsovToImage:
            return kShevtsovToImage;
    }
    return {};
}

bool beginsWith(std::string_view text, std::string_view start) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return text.size() >= start.size() && std::equal(start.begin(), start.end(), text.begin(), same);
}

}  // namespace

std::span<const SurveyModel> surveyModels() { return kModels; }

const SurveyModel* surveyModelOf(std::string_view sceneName, uint64_t triangles) {
    for (const SurveyModel& model : kModels) {
        const double off = static_cast<double>(triangles) - model.triangleCount;
        if (beginsWith(sceneName, model.name) && std::fabs(off) <= 0.02 * model.triangleCount) return &model;
    }
    return nullptr;
}

std::optional<double> publishedFigure(SurveyTable table, std::string_view model, std::string_view builder) {
    for (const Figure& figure : figuresOf(table))
        if (figure.model == model && figure.builder == builder) return figure.value;
    return std::nullopt;
}

bool isPublished(SurveyTable table, std::string_view model) {
    const std::span<const Figure> figures = figuresOf(table);
    return std::any_of(figures.begin(), figures.end(), [&](const Figure& f) { return f.model == model; });
}

}  // namespace cleave
