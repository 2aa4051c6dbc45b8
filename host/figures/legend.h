// The legend of a picture of counts: its colour scale with the least and the greatest count.
#pragma once

#include "run/renderer.h"

namespace cleave {

// Draws the colours of shared/shade.h, scaleColour, from picture.scaleLow to picture.scaleHigh, with these numbers into
// the lower left corner. A picture too small to hold it stays as it is.
void drawLegend(Picture& picture);

}  // namespace cleave
