// Measures how pictures of paths come near a converged one, against what they take.
#pragma once

#include <string>

#include "app/notebook.h"
#include "app/session.h"
#include "figures/scene_errors.h"

namespace cleave {

struct MeasuredPaths {
    PathErrors errors;
    std::vector<ReportPicture> shown;  // the fewest samples, and the reference
};

// Through `built`, which is on the device. What is measured is noted under names that begin with `prefix`. Throws Error
// if no light reaches the camera.
MeasuredPaths measurePaths(Run& run, Session& session, const BuiltTree& built, Notebook& notebook,
                           const std::string& prefix);

}  // namespace cleave
