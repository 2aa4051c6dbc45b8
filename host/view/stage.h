// Loads scenes, poses them and builds their trees beside the window, on a thread and a device of its own.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "figures/built_tree.h"
#include "run/renderer.h"
#include "scene/moving_nodes.h"
#include "scene/pose.h"

namespace cleave {

// What is wanted on the stage.
struct StageWish {
    uint64_t number = 0;  // of the wish
    std::filesystem::path file;
    std::string animation;       // as Options::animation
    std::optional<double> time;  // none: the rest pose
    bool plays = false;          // other times follow: what moves has a tree of its own (docs/motion.md)
    Builder builder = Builder::gpu;
    BuildSettings settings;
    View view = View::shaded;  // whose surfaces are read; those of paths have all others
};

// Whether builds by them make the same tree.
bool sameSettings(const BuildSettings& a, const BuildSettings& b);

// A file, as long as it is shown.
struct LoadedScene {
    std::filesystem::path file;
    Scene scene;
    std::vector<uint32_t> animations;  // that play
    std::vector<bool> movingNodes;
    double end = 0.0;  // of the animations, in seconds
    Box restBounds = emptyBox();
    double loadMs = 0.0;
};

// Its triangles at a time.
struct StagedPose {
    PosedScene posed;
    std::shared_ptr<const char> still;  // poses that share it differ in what moves alone; it says nothing itself
    std::vector<TriangleRun> moving;    // which triangles that is
    Lighting lighting;
    Box bounds = emptyBox();
    uint64_t movingTriangles = 0;
    double poseMs = 0.0;
};

// A tree over all triangles of a pose, or over some of them.
struct StagedTree {
    std::shared_ptr<const KdTree> tree;
    std::shared_ptr<const TriangleSet> set;             // what it was built over; its triangles are the list's alone
    std::shared_ptr<const std::vector<uint32_t>> list;  // their numbers; null: all
    TreeStatistics statistics;
    double buildMs = 0.0;
    uint64_t peakBytes = 0;  // of the build
};

// What there is to look at. Parts that did not change are those of the one before.
struct Staged {
    std::shared_ptr<const LoadedScene> scene;
    std::shared_ptr<const StagedPose> geometry;
    std::shared_ptr<const SurfaceData> surfaces;
    View surfacesOf = View::shaded;
    std::optional<double> time;
    Builder builder = Builder::gpu;
    BuildSettings settings;
    std::vector<StagedTree> trees;    // one, or that of what stays and that of what moves
    std::vector<PassWork> passes;     // of builds on the device, of scenes at rest
    std::optional<double> exactCost;  // SAH cost of the exact builder's tree with the same constants
    std::vector<std::string> warnings;
};

// Whether they have the same trees.
bool sameTrees(const Staged& a, const Staged& b);

class Stage {
  public:
    // `wake` is called, from the stage's thread, when there is something new.
    Stage(std::string device, std::function<void()> wake);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // Takes the place of what was wished before; the thread turns to it after what it is at.
    void ask(const StageWish& wish);
    // The latest that is there; null: nothing yet.
    std::shared_ptr<const Staged> latest() const;
    // The number of the last wish that is fulfilled, or failed.
    uint64_t handled() const;
    // What it is doing, in words; empty: nothing.
    std::string phase() const;
    // Why the last wish failed, once; what was there stays.
    std::optional<std::string> takeError();
    uint64_t deviceBytes() const;

  private:
    struct Workshop;

    std::string device_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable asked_;
    std::optional<StageWish> wish_;
    std::shared_ptr<const Staged> latest_;
    std::string phase_;
    std::optional<std::string> error_;
    uint64_t handled_ = 0;
    uint64_t deviceBytes_ = 0;
    bool ends_ = false;
    std::thread thread_;

    void run();
    void setPhase(const std::string& phase);
    void publish(std::shared_ptr<const Staged> staged, uint64_t handled = 0);
    bool isAskedForMore() const;
};

}  // namespace cleave
