// The survey's tables for a terminal: what was measured here, and beside it what was published.
#pragma once

#include <string>
#include <vector>

#include "figures/survey_figures.h"

namespace cleave {

// All tables, at most 120 columns wide. `threads` is what --threads said. A model of the survey that is not among the
// scenes has its published figures only; a scene that is not in the survey has its measured ones only.
std::string surveyTables(const std::vector<SurveyScene>& scenes, uint32_t threads);

}  // namespace cleave
