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
#include "figures/built_tree.h"
#include "judge/oracle.h"
#include "scene/pose.h"

namespace cleave {

class Session {
  public:
    // Loads the scene, poses it and passes warnings on. `run` outlives the session.
    Session(Run& run, const std::filesystem::path& file, Detail detail = Detail::triangles);

    const Scene& scene() const { return scene_; }
    const PosedScene& posed() const { return posed_; }
    const TriangleSet& set() const { return set_; }
    // Of the triangles with finite vertices, in world space; empty without any.
    const Box& worldBounds() const { return bounds_; }

    // With the settings of the run where none are given.
    BuiltTree build(Builder builder) { return build(builder, run_.options.settings); }
    BuiltTree build(Builder builder, const BuildSettings& settings);
    // Builds the same tree `runs` times; on the device after a warm-up, and once more to see where the time goes.
    BuiltTree buildTimed(Builder builder, uint32_t runs) { return buildTimed(builder, runs, run_.options.settings); }
    BuiltTree buildTimed(Builder builder, uint32_t runs, const BuildSettings& settings);
    // Only the milliseconds of each.
    std::vector<double> timeBuilds(Builder builder, uint32_t runs, const BuildSettings& settings);
    // The tree on the device, which opens it.
    const DeviceTree& upload(BuiltTree& built);
    // What pictures need beside the tree.
    const DeviceTriangles& trianglesOnDevice();
    // What a view shows of surfaces; those of the scene's corners if the session was made with these. Warns of images
    // that cannot be read.
    DeviceSurfaces surfacesOnDevice(View view);

    // Judges up to `count` of the rays. The reference is made at the first call and serves all builders.
    CheckResult check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count);

  private:
    BuiltTree prepared(Builder builder);
    void buildOnDevice(BuiltTree& built, const BuildSettings& settings);
    void buildOnce(BuiltTree& built, const BuildSettings& settings);
    void buildRuns(BuiltTree& built, uint32_t runs, const BuildSettings& settings);
    void finish(BuiltTree& built, const BuildSettings& settings);

    Run& run_;
    Scene scene_;
    PosedScene posed_;
    TriangleSet set_;
    Box bounds_ = emptyBox();
    std::unique_ptr<DeviceTriangles> onDevice_;
    std::unique_ptr<Reference> reference_;
};

// The scene that render shows where none is named. Throws Error if it is not installed.
std::filesystem::path defaultScene();

// Throws Error if a ray was given up or the check found a wrong answer.
void requireAnswered(uint64_t cappedRays, const CheckResult& check, const std::string& what);

}  // namespace cleave
