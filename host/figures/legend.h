// The scale in a picture of counts: what its colours stand for.
#pragma once

#include "run/renderer.h"

namespace cleave {

// Draws the colours of shared/shade.h, scaleColour, from picture.scaleLow to picture.scaleHigh, with these numbers into
// the lower left corner. A picture too small to hold it stays as it is.
void drawLegend(Picture& picture);

}  // namespace cleave
