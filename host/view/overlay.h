// Lines over the picture, by Dear ImGui: the tree's cells, and those along a ray.
#pragma once

#include "view/controls.h"

namespace cleave {

// `width`, `height`: of the window, in the units of ImGui.
void drawOverlay(const Controls& controls, const Facts& facts, float width, float height);

}  // namespace cleave
