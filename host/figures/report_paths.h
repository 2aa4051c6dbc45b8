// How pictures of paths come near a converged one: the section of a scene in a report.
#pragma once

#include <string>

#include "figures/scene_errors.h"

namespace cleave {

// Nothing where no pictures were made.
std::string pathSection(const SceneErrors& scene);

}  // namespace cleave
