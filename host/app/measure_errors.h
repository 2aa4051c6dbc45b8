// Measures error against run time in a scene.
#pragma once

#include <filesystem>
#include <string>

#include "app/run.h"
#include "figures/error_rows.h"

namespace cleave {

// Rays of a set: fewer in a quick report.
uint32_t raySetSize(const Options& options);

// Trees by every builder, and by some with other settings; rays through these; all ways to answer rays. `name` is that
// of the scene in the rows. Throws Error if the scene cannot be read or has no triangle, or an answer that has to be
// right is wrong.
SceneErrors measureErrors(Run& run, const std::filesystem::path& file, const std::string& name);

}  // namespace cleave
