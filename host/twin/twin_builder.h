// The CPU twin of the GPU builder: the same passes in the same order, one file per pass, written to be obvious.
#pragma once

#include "tree/kd_tree.h"
#include "tree/triangle_set.h"

namespace cleave {

struct TwinResult {
    KdTree tree;
    uint64_t peakBytes = 0;      // of the arrays that stand for the device's buffers
    bool memoryLimited = false;  // as GpuBuilder::Result
};
TwinResult buildTwin(const TriangleSet& set, const BuildSettings& settings);

}  // namespace cleave
