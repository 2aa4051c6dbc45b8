// The scale in a picture of counts: what its colours stand for.
#pragma once

#include "pass/renderer.h"

namespace cleave {

// Draws a bar of the picture's colours with the numbers at its ends into the lower left corner. A picture too small
// to hold it stays as it is.
void drawLegend(Picture& picture);

}  // namespace cleave
