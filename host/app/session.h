// A loaded scene, and the trees that are built over it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/run.h"
#include "kdtree/oracle.h"
#include "kdtree/statistics.h"
#include "scene/pose.h"

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
    // GPU: scratch and tree on the device. CPU builders do not count their scratch: the tree's own bytes, a lower
    // bound.
    uint64_t peakBytes = 0;
    bool memoryLimited = false;
    std::vector<KernelTime> kernels;  // see Session::profile
};

class Session {
  public:
    // Loads the scene, poses it and passes warnings on. `run` outlives the session.
    Session(Run& run, const std::filesystem::path& file);

    const Scene& scene() const { return scene_; }
    const PosedScene& posed() const { return posed_; }
    const TriangleSet& set() const { return set_; }
    // Of the triangles with finite vertices, in world space; empty without any.
    const Box& worldBounds() const { return bounds_; }

    // Builds the same tree so many times, to time it.
    BuiltTree build(Builder builder, uint32_t runs = 1);
    // Where a GPU build's time goes: builds once more and notes it in `built`. Others are left alone.
    void profile(BuiltTree& built);
    // The tree on the device, which opens it.
    const DeviceTree& upload(BuiltTree& built);

    // Judges up to `count` of the rays. The reference is made at the first call and serves all builders.
    CheckResult check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count);

  private:
    std::shared_ptr<DeviceTriangles> trianglesOnDevice();
    void buildOnDevice(BuiltTree& built);

    Run& run_;
    Scene scene_;
    PosedScene posed_;
    TriangleSet set_;
    Box bounds_ = emptyBox();
    std::shared_ptr<DeviceTriangles> onDevice_;
    std::unique_ptr<Reference> reference_;
};

// The scene that render shows where none is named. Throws Error if it is not installed.
std::filesystem::path defaultScene();

// Throws Error if a ray was given up or the check found a wrong answer.
void requireAnswered(const Tracer::Result& traced, const CheckResult& check, const std::string& what);

// A line each for the terminal.
std::string builtLine(const BuiltTree& built);
std::string tracedLine(uint64_t rays, const Tracer::Result& traced);
std::string checkedLine(const CheckResult& check);

}  // namespace cleave
