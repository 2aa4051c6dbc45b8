// The CPU twin of the GPU builder: the same passes in the same order, one file per pass, written to be obvious.
#pragma once

#include "tree/tree_builder.h"

namespace cleave {

// Bytes are those of the arrays that stand for the device's buffers.
BuildOutcome buildTwin(const TriangleSet& set, const BuildSettings& settings);

}  // namespace cleave
