// The panel beside the picture, by Dear ImGui, between its NewFrame() and Render().
#pragma once

#include "view/controls.h"

namespace cleave {

// The colours and the font of all that is drawn over the picture; `scale`: of the display.
void styleInterface(float scale);

// Draws the panel, and changes what its user changes. True if the error was read and goes.
bool drawPanel(Controls& controls, const Facts& facts);

}  // namespace cleave
