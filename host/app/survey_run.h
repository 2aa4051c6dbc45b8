// The run of `cleave bench --survey`.
#pragma once

#include <filesystem>

#include "app/session.h"
#include "figures/survey_figures.h"

namespace cleave {

// Builds and traces with every builder of the survey, with the settings that were asked for and without what goes
// beyond its paper, after judging a sample of the rays. Builders take turns, so that what else the machine does
// disturbs all alike. Throws Error if an answer is wrong, or if the exact builds differ.
SurveyScene measureForSurvey(Run& run, Session& session, const std::filesystem::path& file);

}  // namespace cleave
