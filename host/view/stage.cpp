#include "view/stage.h"

#include <algorithm>
#include <new>

#include "app/device_kit.h"
#include "app/lighting.h"
#include "app/options.h"
#include "app/surfaces.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "facade/host_builders.h"
#include "run/device_builders.h"
#include "scene/animation.h"
#include "scene/moving_nodes.h"
#include "scene/pose_again.h"
#include "view/give_way.h"

namespace cleave {
namespace {

// Above, the exact builder would take a core for seconds.
constexpr size_t kMostToCompare = 1'000'000;

bool shows(View read, View wanted) { return read == wanted || read == View::path; }

}  // namespace

bool sameSettings(const BuildSettings& a, const BuildSettings& b) {
    return a.costs.traverse == b.costs.traverse && a.costs.intersect == b.costs.intersect &&
           a.costs.leaf == b.costs.leaf && a.costs.emptyBonus == b.costs.emptyBonus && a.stop == b.stop &&
           a.bins == b.bins && a.exactUpTo == b.exactUpTo && a.maxDepth == b.maxDepth && a.axes == b.axes &&
           a.leafSize == b.leafSize && a.clip == b.clip && a.subsample == b.subsample && a.snap == b.snap &&
           a.otherAxes == b.otherAxes && a.smallNodes == b.smallNodes && a.memory == b.memory;
}

bool sameTrees(const Staged& a, const Staged& b) {
    return std::ranges::equal(a.trees, b.trees, {}, &StagedTree::tree, &StagedTree::tree);
}

// What lives on the thread: the device, and the steps from a wish to what is staged.
struct Stage::Workshop {
    explicit Workshop(Stage& s) : stage(s), kit(s.device_) {}

    Stage& stage;
    DeviceKit kit;
    Needs needs;                                   // nothing is kept that a scene does not need
    std::shared_ptr<const StagedPose> uploadedOf;  // whose triangles are on the device
    std::unique_ptr<DeviceTriangles> triangles;

    std::shared_ptr<LoadedScene> load(const StageWish& wish) {
        stage.setPhase("loading " + oneLine(wish.file.filename().string()));
        auto loaded = std::make_shared<LoadedScene>();
        const Stopwatch watch;
        loaded->file = wish.file;
        loaded->scene = loadGltf(wish.file);
        loaded->loadMs = watch.milliseconds();
        const Scene& scene = loaded->scene;
        loaded->animations =
            wish.animation == kAllAnimations ? allAnimations(scene) : chooseAnimation(scene, wish.animation);
        loaded->movingNodes = movingNodes(scene, loaded->animations);
        loaded->end = endOf(scene, loaded->animations);
        return loaded;
    }

    // `before`: what is staged, of the same scene; null: nothing.
    std::shared_ptr<const StagedPose> poseScene(const LoadedScene& loaded, const std::optional<double>& time,
                                                const Staged* before) {
        stage.setPhase("posing");
        auto made = std::make_shared<StagedPose>();
        const Stopwatch watch;
        const PoseTime at = time ? PoseTime{*time, loaded.animations} : PoseTime{};
        const bool plays = time && before && before->time;
        if (plays) made->posed = before->geometry->posed;
        if (plays && poseAgain(made->posed, loaded.scene, at, loaded.movingNodes, Detail::corners)) {
            made->still = before->geometry->still;
        } else {
            if (!plays) made->posed = pose(loaded.scene, at, kMostTriangles, Detail::corners);
            made->still = std::make_shared<const char>();
        }
        made->poseMs = watch.milliseconds();
        made->moving = runsThat(true, made->posed, loaded.movingNodes);
        made->lighting = lightingOf(loaded.scene, made->posed);
        made->bounds = finiteBounds(made->posed.triangles);
        made->movingTriangles = countMoving(made->posed, loaded.movingNodes);
        return made;
    }

    void readSurfaces(Staged& next, const StageWish& wish) {
        stage.setPhase("reading images");
        uint64_t most = kit.device().largestAllocation();
        if (wish.settings.memory != 0) most = std::min(most, wish.settings.memory);
        const auto warn = [&](const std::string& warning) { next.warnings.push_back(warning); };
        next.surfaces = std::make_shared<SurfaceData>(
            surfacesOf(next.scene->scene, next.geometry->posed, wish.view, most, warn, needs));
        next.surfacesOf = wish.view;
    }

    bool splits(const Staged& staged, const StageWish& wish) const {
        const uint64_t moving = staged.geometry->movingTriangles;
        return wish.plays && moving > 0 && moving < staged.geometry->posed.triangles.size();
    }

    // One tree over all, or two, of which the first stays while the scene and the builder do.
    void build(Staged& next, const StageWish& wish, const Staged* before) {
        stage.setPhase("building (" + nameOf(wish.builder) + ")");
        next.builder = wish.builder;
        next.settings = wish.settings;
        next.passes.clear();
        next.trees.clear();
        if (!splits(next, wish)) {
            next.trees.push_back(built(next, wish, nullptr));
            return;
        }
        const auto numbers = [&](bool move) {
            return std::make_shared<const std::vector<uint32_t>>(
                trianglesThat(move, next.geometry->posed, next.scene->movingNodes));
        };
        const bool stays = before && before->trees.size() > 1 && before->scene == next.scene &&
                           before->builder == wish.builder && sameSettings(before->settings, wish.settings);
        next.trees.push_back(stays ? before->trees.front() : built(next, wish, numbers(false)));
        next.trees.push_back(built(next, wish, numbers(true)));
    }

    StagedTree built(const Staged& next, const StageWish& wish, std::shared_ptr<const std::vector<uint32_t>> list) {
        StagedTree made;
        const std::vector<Triangle>& all = next.geometry->posed.triangles;
        made.set =
            std::make_shared<TriangleSet>(list ? makeTriangleSet(trianglesOf(all, *list)) : makeTriangleSet(all));
        if (isOnDevice(wish.builder.name)) {
            const std::span<const uint32_t> numbers = list ? std::span(*list) : std::span<const uint32_t>();
            const BuildSettings settings = settingsFor(wish.builder.name, wish.settings);
            const GpuBuilder::Result result = kit.builder().build(onDevice(next.geometry), settings, numbers);
            KdTree tree = readBack(*result.tree);
            for (uint32_t& triangle : tree.leafTriangles)
                if (list) triangle = static_cast<uint32_t>(std::ranges::lower_bound(*list, triangle) - list->begin());
            made.tree = std::make_shared<KdTree>(std::move(tree));
            made.buildMs = result.ms;
            made.peakBytes = result.peakBytes;
        } else {
            const Stopwatch watch;
            BuildOutcome outcome = hostBuilder(wish.builder.name).build(*made.set, wish.settings);
            made.buildMs = watch.milliseconds();
            made.tree = std::make_shared<KdTree>(std::move(outcome.tree));
            made.peakBytes = outcome.peakBytes;
        }
        made.statistics = computeStatistics(*made.tree, wish.settings.costs);
        made.list = std::move(list);
        return made;
    }

    const DeviceTriangles& onDevice(const std::shared_ptr<const StagedPose>& geometry) {
        if (uploadedOf == geometry) return *triangles;
        const std::vector<Triangle>& world = geometry->posed.triangles;
        if (uploadedOf && uploadedOf->still == geometry->still) {
            for (const TriangleRun& run : geometry->moving) triangles->move(world, run.first, run.count);
        } else {
            uploadedOf.reset();
            triangles.reset();
            triangles = std::make_unique<DeviceTriangles>(kit.device(), world);
        }
        uploadedOf = geometry;
        return *triangles;
    }

    // Where its time goes, and how good the tree is: after it is shown, unless there is something else to do.
    void lookClosely(const std::shared_ptr<const Staged>& shown) {
        if (shown->time || shown->trees.size() > 1 || stage.isAskedForMore()) return;
        auto next = std::make_shared<Staged>(*shown);
        if (isOnDevice(shown->builder.name)) {
            stage.setPhase("timing the passes of the build");
            const BuildSettings settings = settingsFor(shown->builder.name, shown->settings);
            next->passes = kit.builder().profile(onDevice(shown->geometry), settings).passes;
            stage.publish(next);
        }
        if (shown->trees.front().set->included.size() > kMostToCompare || stage.isAskedForMore()) return;
        next = std::make_shared<Staged>(*next);
        next->exactCost = shown->trees.front().statistics.sahCost;
        if (!(shown->builder == Builder::exact)) {
            stage.setPhase("building the exact tree, to compare with");
            BuildSettings alone = shown->settings;
            alone.threads = 1;  // the picture needs the others
            const BuildOutcome exact = hostBuilder(Builder::exact.name).build(*shown->trees.front().set, alone);
            next->exactCost = computeStatistics(exact.tree, alone.costs).sahCost;
        }
        stage.publish(next);
    }

    void fulfil(const StageWish& wish) {
        const std::shared_ptr<const Staged> before = stage.latest();
        auto next = before ? std::make_shared<Staged>(*before) : std::make_shared<Staged>();
        const bool loads = !before || before->scene->file != wish.file;
        const bool poses = loads || before->time != wish.time;
        const bool builds = poses || !(before->builder == wish.builder) ||
                            !sameSettings(before->settings, wish.settings) ||
                            splits(*before, wish) != (before->trees.size() > 1);
        const bool reads = loads || !shows(before->surfacesOf, wish.view);
        if (!poses && !builds && !reads) return stage.publish(before, wish.number);
        std::shared_ptr<LoadedScene> loaded;
        if (loads) next->scene = loaded = load(wish);
        next->time = wish.time;
        if (poses) next->geometry = poseScene(*next->scene, wish.time, loads ? nullptr : before.get());
        if (loads) {
            loaded->restBounds = wish.time ? finiteBounds(pose(loaded->scene).triangles) : next->geometry->bounds;
            next->warnings = loaded->scene.warnings;
            const auto& warnings = next->geometry->posed.warnings;
            next->warnings.insert(next->warnings.end(), warnings.begin(), warnings.end());
        }
        if (reads) readSurfaces(*next, wish);
        if (builds) {
            next->exactCost.reset();
            build(*next, wish, before.get());
        }
        stage.publish(next, wish.number);
        if (builds) lookClosely(next);
    }
};

Stage::Stage(std::string device, std::function<void()> wake)
    : device_(std::move(device)), wake_(std::move(wake)), thread_([this] { run(); }) {}

Stage::~Stage() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void Stage::ask(const StageWish& wish) {
    {
        const std::scoped_lock lock(mutex_);
        wish_ = wish;
        if (phase_.empty()) phase_ = "starting";
    }
    asked_.notify_one();
}

std::shared_ptr<const Staged> Stage::latest() const {
    const std::scoped_lock lock(mutex_);
    return latest_;
}

std::string Stage::phase() const {
    const std::scoped_lock lock(mutex_);
    return phase_;
}

std::optional<std::string> Stage::takeError() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(error_, std::nullopt);
}

uint64_t Stage::handled() const {
    const std::scoped_lock lock(mutex_);
    return handled_;
}

uint64_t Stage::deviceBytes() const {
    const std::scoped_lock lock(mutex_);
    return deviceBytes_;
}

void Stage::setPhase(const std::string& phase) {
    {
        const std::scoped_lock lock(mutex_);
        phase_ = phase;
    }
    wake_();
}

void Stage::publish(std::shared_ptr<const Staged> staged, uint64_t handled) {
    {
        const std::scoped_lock lock(mutex_);
        latest_ = std::move(staged);
        handled_ = std::max(handled_, handled);
    }
    wake_();
}

bool Stage::isAskedForMore() const {
    const std::scoped_lock lock(mutex_);
    return wish_.has_value() || ends_;
}

// A device that was lost, or is out of memory, is opened anew with the next wish.
void Stage::run() {
    giveWay(10);
    std::unique_ptr<Workshop> workshop;
    for (;;) {
        std::optional<StageWish> wish;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [&] { return wish_.has_value() || ends_; });
            if (ends_) break;
            wish.swap(wish_);
        }
        std::optional<std::string> error;
        try {
            if (!workshop) workshop = std::make_unique<Workshop>(*this);
            workshop->fulfil(*wish);
        } catch (const std::bad_alloc&) {
            error = "out of memory, on this machine, for " + oneLine(wish->file.filename().string());
        } catch (const std::exception& thrown) {
            error = thrown.what();
        }
        if (error) workshop.reset();
        {
            const std::scoped_lock lock(mutex_);
            if (error) error_ = error;
            handled_ = std::max(handled_, wish->number);
            if (!wish_) phase_.clear();
            deviceBytes_ = workshop && workshop->kit.isOpen() ? workshop->kit.device().memoryInUse() : 0;
        }
        wake_();
    }
}

}  // namespace cleave
