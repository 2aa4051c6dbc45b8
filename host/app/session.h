// A loaded scene, and the trees that are built over it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/needs.h"
#include "app/run.h"
#include "figures/built_tree.h"
#include "judge/oracle.h"
#include "run/poser.h"
#include "scene/moving_nodes.h"
#include "scene/pose.h"

namespace cleave {

// A scene as its file has it, and how long that took.
struct ReadScene {
    Scene scene;
    double ms = 0.0;
};
ReadScene readScene(Run& run, const std::filesystem::path& file);

// The animations that the options of the run ask for; warns where there is none, or where they are of no use.
std::vector<uint32_t> chosenAnimations(Run& run, const Scene& scene);

class Session {
  public:
    // Loads the scene, poses it at the time that the options of the run ask for, and passes warnings on, each once.
    // `run` outlives the session.
    Session(Run& run, const std::filesystem::path& file, Detail detail = Detail::triangles)
        : Session(run, readScene(run, file), detail) {}
    Session(Run& run, ReadScene loaded, Detail detail = Detail::triangles);

    // Poses the scene anew; what was built or judged before was of another pose. From the second time on triangles that
    // do not move stay as they are, on the device, too.
    void poseAt(double seconds);
    // The others are posed on the device from now on, where that can be and, unless it is `always`, pays; and on the
    // host when somebody asks for them. Not with what surfaces look like at their corners, which the host poses.
    void mayPoseOnDevice(bool always);
    bool isPosedOnDevice() const { return pose_ != nullptr; }

    const Scene& scene() const { return scene_; }
    const PosedScene& posed() const;
    // The same, but of the triangles that move perhaps only the numbers, not where they are.
    const PosedScene& posedButTriangles() const { return posed_; }
    const TriangleSet& set() const;
    // Of each node, whether it moves while the animations play.
    const std::vector<bool>& movingNodes();
    // What it took to come by them: to read and check the file, to pose what it shows, and to bring its triangles to
    // the device, if they are there.
    double loadMilliseconds() const { return loadMs_; }
    double poseMilliseconds() const { return poseMs_; }
    double uploadMilliseconds() const { return uploadMs_; }
    // Of the triangles with finite vertices, in world space; empty without any.
    const Box& worldBounds() const;
    // The same in the rest pose, for cameras that stay where they are at all times.
    const Box& restBounds();
    // Those that are played, by number.
    const std::vector<uint32_t>& animations() const { return animations_; }

    // What the run does without; commands add what they find.
    Needs& needs() { return needs_; }
    const Needs& needs() const { return needs_; }
    // The builder of the run; without a name, that of tiny scenes is none, where nobody is shown the tree.
    Builder chosenBuilder(bool showsTree);

    // With the settings of the run where none are given. Where the run names a saved tree, that one, loaded.
    // `list`: over some of the triangles, by ascending numbers; it is on the device then. Empty: over all.
    BuiltTree build(Builder builder, std::span<const uint32_t> list = {}) { return build(builder, settings_, list); }
    BuiltTree build(Builder builder, const BuildSettings& settings, std::span<const uint32_t> list = {});
    // Only the tree and its time: neither statistics nor a hash, which take longer.
    BuiltTree buildPlain(Builder builder, std::span<const uint32_t> list = {});
    // Over all triangles by `gpu`, where rays come to. Session and device outlive it.
    std::unique_ptr<LazyTree> buildLazily();
    // What became of it, as a tree that was built at once has it.
    BuiltTree figuresOf(const LazyTree& lazy);
    // Builds the same tree `runs` times; on the device after a warm-up, and once more to see where the time goes.
    BuiltTree buildTimed(Builder builder, uint32_t runs) { return buildTimed(builder, runs, settings_); }
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
    // Brings those of the pose before to this one; after each pose.
    void moveSurfaces(DeviceSurfaces& surfaces);

    // Judges up to `count` of the rays. The reference is made at the first call and serves all builders.
    CheckResult check(std::span<const Ray> rays, std::span<const Hit> hits, Query query, uint64_t count);

  private:
    void readUnplayed() const;
    void poseScene(const PoseTime& time);
    void poseWhatMoves(const PoseTime& time);
    void poseOnDevice(const PoseTime& time);
    bool preparePose();
    void warnOfNonFinite(const TreeHeader& header);
    void forgetPose();
    void warnOnce(const std::vector<std::string>& warnings);
    BuiltTree prepared(Builder builder);
    void buildOnDevice(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list);
    void buildOnHost(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list);
    void loadSaved(BuiltTree& built);
    void buildOnce(BuiltTree& built, const BuildSettings& settings, std::span<const uint32_t> list = {});
    void buildRuns(BuiltTree& built, uint32_t runs, const BuildSettings& settings);
    void finish(BuiltTree& built, const BuildSettings& settings);
    void tell(BuiltTree& built, const BuildSettings& settings);

    Run& run_;
    BuildSettings settings_;
    Needs needs_;
    Detail detail_;
    Scene scene_;
    std::vector<uint32_t> animations_;
    std::set<std::string> warned_;
    mutable PosedScene posed_;
    mutable std::optional<PoseTime> later_;  // of the triangles that move, where the device is ahead of posed_
    bool isPlaying_ = false;                 // posed_ is of a time of the animations
    bool isPosedAgain_ = false;              // nothing but what moves differs from the pose before
    std::vector<TriangleRun> moving_;        // of a pose that plays
    std::vector<bool> movingNodes_;          // empty: not known yet
    // Of the pose, each made when it is first asked for.
    mutable std::optional<TriangleSet> set_;
    mutable std::optional<Box> bounds_;
    std::optional<Box> restBounds_;
    double loadMs_ = 0.0;
    double poseMs_ = 0.0;
    double uploadMs_ = 0.0;
    std::unique_ptr<DeviceTriangles> onDevice_;
    bool mayPoseOnDevice_ = false, alwaysPoseOnDevice_ = false;
    std::unique_ptr<DevicePose> pose_;
    std::unique_ptr<Reference> reference_;
};

// The scene that render shows where none is named. Throws Error if it is not installed.
std::filesystem::path defaultScene();

// Throws Error if a ray was given up or the check found a wrong answer.
void requireAnswered(uint64_t cappedRays, const CheckResult& check, const std::string& what);

}  // namespace cleave
