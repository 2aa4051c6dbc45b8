#include "figures/survey_figures.h"

namespace cleave {

const SurveyBuilder* SurveyScene::find(std::string_view builder) const {
    for (const SurveyBuilder& figures : builders)
        if (figures.builder.name == builder) return &figures;
    return nullptr;
}

}  // namespace cleave
