// Measures error against run time in a scene.
#pragma once

#include <filesystem>
#include <string>

#include "app/notebook.h"
#include "app/run.h"
#include "figures/scene_errors.h"

namespace cleave {

// Rays of a set: fewer in a quick report.
uint32_t raySetSize(const Options& options);

// Trees by every builder, and by some with other settings; rays through these; all ways to answer rays; pictures.
// `name` is that of the scene in the rows. A builder that fails is told in leftOut; `exact` has to succeed. Throws
// Error if the scene cannot be read or has no triangle.
SceneErrors measureErrors(Run& run, Notebook& notebook, const std::filesystem::path& file, const std::string& name);

}  // namespace cleave
