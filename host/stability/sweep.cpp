#include "stability/sweep.h"

#include "base/stopwatch.h"
#include "base/strided.h"

namespace cleave {

SceneSweep::SceneSweep(std::string scene, std::span<const Triangle> world, const TriangleSet& set,
                       const SweepSettings& settings)
    : scene_(std::move(scene)), world_(world), set_(set), settings_(settings), reference_(world, set.included) {}

std::vector<Hit> SceneSweep::answer(std::span<const Ray> rays) const {
    if (!isSmall(rays.size())) return answeringBy_->trace(*answering_, rays).hits;
    std::vector<Hit> hits(rays.size());
    forEachStrided(rays.size(), settings_.threads,
                   [&](size_t, size_t i) { hits[i] = bruteForce(set_, rays[i], Query::closest); });
    return hits;
}

Volley SceneSweep::volley(const RayFamily& family, const KdTree* tree) const {
    const uint64_t seed = seedFor(seedFor(settings_.seed, scene_), family.name);
    const auto answers = [this](std::span<const Ray> rays) { return answer(rays); };
    Volley volley{&family, family.make({world_, set_, tree, settings_.rays, seed, answers}), {}, {}, false};
    volley.byBruteForce = isSmall(volley.rays.size());
    volley.expected = answer(volley.rays);
    volley.judged = judgeAll(reference_, volley.rays, volley.expected, settings_.threads);
    return volley;
}

void SceneSweep::answerBy(std::shared_ptr<const TreeUnderTest> tree, const TraversalUnderTest& traversal) {
    answering_ = std::move(tree);
    answeringBy_ = traversal;
    for (const RayFamily& family : rayFamilies())
        if (!family.needsTree) shared_.push_back(volley(family, nullptr));
}

std::vector<Cell> SceneSweep::run(std::shared_ptr<const TreeUnderTest> tree,
                                  std::span<const TraversalUnderTest> traversals) {
    if (!answering_) answerBy(tree, traversals.front());
    std::vector<Volley> own;
    for (const RayFamily& family : rayFamilies())
        if (family.needsTree) own.push_back(volley(family, &tree->tree));

    std::vector<Cell> cells;
    for (const TraversalUnderTest& traversal : traversals)
        for (const auto* volleys : {&shared_, &own})
            for (const Volley& volley : *volleys) {
                if (volley.rays.empty() || volley.rays.size() * set_.included.size() > traversal.mostWork) continue;
                Cell cell;
                cell.scene = scene_;
                cell.builder = tree->builder;
                cell.traversal = traversal.name;
                cell.family = volley.family->name;
                cell.isEdgeFamily = volley.family->isEdgeFamily;
                count(cell, volley, traversal.trace(*tree, volley.rays), reference_, traversal.query);
                cells.push_back(std::move(cell));
            }
    return cells;
}

TraversalUnderTest hostStack(const TriangleSet& set, uint64_t mostWork, uint32_t threads) {
    const auto trace = [&set, threads](const TreeUnderTest& tree, std::span<const Ray> rays) {
        const Stopwatch watch;
        Tracer::Result result;
        result.hits.resize(rays.size());
        forEachStrided(rays.size(), threads,
                       [&](size_t, size_t i) { result.hits[i] = stackWalk(tree.tree, set, rays[i], Query::closest); });
        result.ms = watch.milliseconds();
        return result;
    };
    return {"host-stack", trace, mostWork};
}

std::string traversalName(const std::string& traversal, Query query) {
    return query == Query::any ? traversal + "-any" : traversal;
}

}  // namespace cleave
