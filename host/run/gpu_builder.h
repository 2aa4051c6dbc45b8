// Builds trees on the device: gives a build its memory, runs it, and runs it again with more where that was short.
#pragma once

#include <memory>
#include <vector>

#include "gpu/commands.h"
#include "run/build_profile.h"
#include "run/context_of.h"
#include "run/device_tree.h"
#include "run/lazy_tree.h"

namespace cleave {

class GpuBuilder {
  public:
    // Compiles the kernels of builds with default settings; `lazily`: and those of lazy builds.
    explicit GpuBuilder(Device& device, bool lazily = false);
    ~GpuBuilder();
    // Compiles those that a build with these settings has besides, by building a tiny tree; build() does so, too.
    void prepare(const BuildSettings& settings);
    double setupMilliseconds() const { return setupMs_; }

    struct Result {
        std::shared_ptr<DeviceTree> tree;
        double ms = 0.0;             // from triangles on the device to a tree ready to trace
        uint64_t peakBytes = 0;      // device memory of the build: scratch and tree, with the finished tree beside them
        uint32_t levels = 0;         // depth reached
        uint32_t attempts = 1;       // 1 + how often the capacity was too small and the build was done once more
        bool memoryLimited = false;  // settings.memory was met: the last levels were finished as leaves
    };
    // `list`: ascending numbers of the triangles that the tree is built over; empty: all.
    Result build(const DeviceTriangles& triangles, const BuildSettings& settings, std::span<const uint32_t> list = {});

    // Over all of the triangles, which have these ascending numbers in the scene.
    Result buildNumbered(const DeviceTriangles& triangles, const BuildSettings& settings,
                         std::span<const uint32_t> numbers);

    // Builds the top of a tree that is built where rays come to, as LazyTree has it. The triangles outlive it.
    std::unique_ptr<LazyTree> buildLazily(const DeviceTriangles& triangles, const BuildSettings& settings,
                                          uint32_t openUpTo, const Capacity& capacity = {});

    // Builds once more, with the clock read after every pass. With the capacity that the last build needed, so that it
    // follows one with the same settings. Without a clock on the queue all times are 0.
    BuildProfile profile(const DeviceTriangles& triangles, const BuildSettings& settings);

  private:
    Result build(std::span<const Geometry> geometries, const BuildSettings& settings, std::span<const uint32_t> list);

    struct State;
    std::unique_ptr<State> state_;
    double setupMs_ = 0.0;
};

}  // namespace cleave
