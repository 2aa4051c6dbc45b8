// Shoots all families of rays at one scene, through any number of trees and by any number of traversals.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "measure/statistics.h"
#include "run/device_instances.h"
#include "stability/cell.h"

namespace cleave {

struct TreeUnderTest {
    std::string builder;
    KdTree tree;
    std::shared_ptr<DeviceTree> onDevice;             // null where no traversal of the device is tested
    std::vector<std::shared_ptr<DeviceTree>> halves;  // over every other triangle each; none of scenes of one or none
    std::shared_ptr<DeviceInstances> instances;       // only of a placed case (placed_case.h), `tree` being the first
    std::vector<std::shared_ptr<LazyTree>> lazy;      // one of each traversal that waits; none where that is not tested
    TreeStatistics statistics;
    double buildMs = 0.0;
};

struct TraversalUnderTest {
    std::string name;
    // Answers to `query`, and how many steps were taken where that is counted. The first of several gives closest hits.
    std::function<Tracer::Result(const TreeUnderTest& tree, std::span<const Ray> rays)> trace;
    uint64_t mostWork = UINT64_MAX;  // it is left out where rays times triangles are more
    Query query = Query::closest;
};

struct SweepSettings {
    uint64_t rays = 1000;  // per family
    // Brute force gives the expected answers up to so many rays times triangles; beyond that, the first tree does.
    uint64_t bruteWork = 4'000'000;
    uint64_t seed = 1;
    uint32_t threads = 2;
};

class SceneSweep {
  public:
    // `world` and `set` outlive this.
    SceneSweep(std::string scene, std::span<const Triangle> world, const TriangleSet& set,
               const SweepSettings& settings);

    // What answers where brute force takes too long: unless it is told, the first tree and traversal that are run.
    void answerBy(std::shared_ptr<const TreeUnderTest> tree, const TraversalUnderTest& traversal);

    // A cell per traversal and family.
    std::vector<Cell> run(std::shared_ptr<const TreeUnderTest> tree, std::span<const TraversalUnderTest> traversals);

  private:
    std::vector<Hit> answer(std::span<const Ray> rays) const;
    bool isSmall(size_t rays) const { return rays * set_.included.size() <= settings_.bruteWork; }
    Volley volley(const RayFamily& family, const KdTree* tree) const;

    std::string scene_;
    std::span<const Triangle> world_;
    const TriangleSet& set_;
    SweepSettings settings_;
    Reference reference_;
    std::shared_ptr<const TreeUnderTest> answering_;
    std::optional<TraversalUnderTest> answeringBy_;
    std::vector<Volley> shared_;  // of the families that need no tree
};

// stackWalk (judge/oracle.h) on the host.
TraversalUnderTest hostStack(const TriangleSet& set, uint64_t mostWork, uint32_t threads = 2);

// What a traversal is called in a table: any-hit queries by it have a row of their own.
std::string traversalName(const std::string& traversal, Query query);

}  // namespace cleave
