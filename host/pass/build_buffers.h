// The device's arrays of a build: shared/build.h's BuildArgs, filled in.
#pragma once

#include "pass/device_arrays.h"
#include "tree/kd_tree.h"
#include "twin/build_capacity.h"

namespace cleave {

struct BuildBuffers {
    BuildCapacity capacity;
    uint32_t exactBelow = 0;
    Buffer refs[2], nodes[2], chunks, bounds, bins, nearest, smallNodes, sides, clipped, offsets, blockSums, nodeSums,
        tree, leafRefs, state, args;

    BuildBuffers() = default;
    BuildBuffers(Context& context, const BuildCapacity& capacity, uint32_t exactBelow);
    // Tells the kernels where everything is and what to build.
    void bind(const DeviceTriangles& triangles, const BuildSettings& settings);
    uint64_t bytes() const;
};

}  // namespace cleave
