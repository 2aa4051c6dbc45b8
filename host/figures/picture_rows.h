// How the error of pictures of paths falls, as they take more samples and more time.
#pragma once

#include <vector>

#include "figures/error_rows.h"
#include "figures/log_slope.h"

namespace cleave {

// Per cent of the reference's brightness that pictures are off, by relativeRmse(), and their time; one row per number
// of samples. The error of several pictures is the root of their mean square.
std::vector<ErrorRow> pictureRows(const SceneErrors& scene);

// The rows without those that are not off at all.
LogPoints errorsByTime(const SceneErrors& scene);
LogPoints errorsBySamples(const SceneErrors& scene);

// Rows as errorRowsJson() has them, with samples and similarity.
Json pictureRowsJson(const SceneErrors& scene);
// The slopes of the errors' logarithm, over all scenes and of each, with the error of its reference.
Json pictureJson(const std::vector<SceneErrors>& scenes);

}  // namespace cleave
