// The GPU builder: which kernel when (survey section 7; breadth-first, level by level).
#pragma once

#include "gpu/context.h"
#include "pass/device_tree.h"

namespace cleave {

class GpuBuilder {
  public:
    explicit GpuBuilder(Context& context);
    ~GpuBuilder();

    struct Result {
        std::shared_ptr<DeviceTree> tree;
        double ms = 0.0;             // from triangles on the device to a tree ready to trace
        uint64_t peakBytes = 0;      // device memory of the build: scratch and tree, without the triangles
        uint32_t levels = 0;         // depth reached
        uint32_t attempts = 1;       // 1 + how often a buffer was too small and the build was done once more
        bool memoryLimited = false;  // settings.memory was met: the last levels were finished as leaves
    };
    Result build(std::shared_ptr<DeviceTriangles> triangles, const BuildSettings& settings);

    // Builds once more, with the clock read after every dispatch: what each kernel takes. In the room that the last
    // build needed, so that it follows one with the same settings.
    std::vector<KernelTime> profile(const DeviceTriangles& triangles, const BuildSettings& settings);

    // Compiles every kernel that build() uses, by building a tiny tree.
    void warmUp();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace cleave
