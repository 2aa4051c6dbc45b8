// A tree that was built, with its figures.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "figures/names.h"
#include "judge/oracle.h"
#include "measure/statistics.h"
#include "run/gpu_builder.h"
#include "run/tracer.h"

namespace cleave {

// A tree, on the host for its figures and, once asked for, on the device for rays.
struct BuiltTree {
    Builder builder = Builder::gpu;
    KdTree tree;
    std::shared_ptr<DeviceTree> onDevice;  // GPU builds; else see Session::upload
    TreeStatistics statistics;
    std::string hash;          // treeHash(tree)
    std::vector<double> runs;  // ms of each build
    // Median of the runs. GPU: warm, from triangles on the device to a tree ready to trace. CPU: from triangles in
    // memory to a KdTree.
    double ms = 0.0;
    double setupMs = 0.0;  // compilation and pipelines, GPU only
    // Most bytes held at once. GPU: scratch and tree on the device. CPU: scratch and tree of the builder, in main
    // memory.
    uint64_t peakBytes = 0;
    bool memoryLimited = false;
    uint32_t attempts = 1;  // GPU: 1 + how often the capacity was too small and the build was done once more
    BuildProfile profile;   // GPU, see Session::buildTimed
};

// A line each for the terminal.
std::string builtLine(const BuiltTree& built);
std::string tracedLine(uint64_t rays, double ms, uint64_t invalidRays);
std::string checkedLine(const CheckResult& check);

}  // namespace cleave
