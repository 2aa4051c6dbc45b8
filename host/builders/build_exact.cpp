#include "builders/builders.h"
#include "builders/event_node.h"
#include "builders/exact_chooser.h"
#include "builders/graft.h"
#include "builders/threads.h"
#include "builders/top_down.h"

namespace cleave {
namespace {

// From so many references on, a node's right subtree may be built by another thread.
constexpr uint32_t kShareChildrenFrom = 1024;

// One part of the tree, built depth first by one thread at a time, as TopDownBuilder does it. Parts that other threads
// built are put where this one would have built them, so that the tree does not depend on who built what.
class ExactPart {
  public:
    ExactPart(EventBuild& build, const BuildSettings& settings)
        : build_(build),
          settings_(settings),
          small_(build.set, settings, ExactChooser(settings, build.maxDepth, report_), build.bytes) {
        tree_.nodes.resize(1);
    }
    ExactPart(const ExactPart&) = delete;  // the chooser holds the report's address

    void buildNode(uint32_t index, EventNode node) {
        if (isCounted(settings_, node.count))
            return graft(tree_, index, small_.buildSubtree(node.toSplit(build_.costs)));
        const Split split = choose(node);
        if (split.axis == kLeafAxis) return makeLeaf(index, node);

        const uint32_t child = appendChildren(tree_);
        tree_.nodes[index] = innerNode(split.axis, split.position, child);
        const bool shares = build_.parallel && node.count >= kShareChildrenFrom;
        Children children = divide(build_, std::move(node), split, report_);
        if (shares) return buildAtOnce(child, std::move(children));
        buildNode(child, std::move(children.left));
        buildNode(child + 1, std::move(children.right));
    }

    KdTree& tree() { return tree_; }
    const BuildReport& report() const { return report_; }

  private:
    Split choose(const EventNode& node) {
        if (node.depth >= build_.maxDepth || collapsedAxes(node.cell) >= 2) return noSplit();
        Split best[3];
        forEachAxis(build_, node.count, [&](int axis) {
            best[axis] = sweepEvents(noSplit(), build_.costs, node.alongAxis[axis], node.cell,
                                     static_cast<uint32_t>(axis), node.count);
        });
        for (const std::span<Event>& events : node.alongAxis) report_.eventsSwept += events.size();
        for (const Split& split : {best[1], best[2]})
            if (isBetter(split, best[0])) best[0] = split;
        return isWorthwhile(build_.costs, best[0], node.cell, node.count, node.depth, build_.maxDepth) ? best[0]
                                                                                                       : noSplit();
    }

    void buildAtOnce(uint32_t child, Children children) {
        ExactPart right(build_, settings_);
        bothAtOnce([&] { buildNode(child, std::move(children.left)); },
                   [&] { right.buildNode(0, std::move(children.right)); });
        graft(tree_, child + 1, right.tree_);
        report_.eventsSwept += right.report_.eventsSwept;
        report_.sortSteps += right.report_.sortSteps;
    }

    void makeLeaf(uint32_t index, const EventNode& node) {
        beginLeaf(tree_, index, node.count);
        for (const ClippedRef& ref : node.references()) tree_.leafTriangles.push_back(ref.prim);
    }

    EventBuild& build_;
    const BuildSettings& settings_;
    BuildReport report_;
    KdTree tree_;
    TopDownBuilder<ExactChooser> small_;
};

}  // namespace

KdTree buildExact(const TriangleSet& set, const BuildSettings& settings, BuildReport* asked) {
    BuildReport report;
    EventBuild build{
        set, splitCosts(settings), settings.clip, depthLimit(settings, set.included.size()), settings.threads > 1, {}};
    ExactPart whole(build, settings);
    const auto run = [&] {
        BuildReport ofRoot;
        EventNode root = rootNode(build, ofRoot);
        whole.buildNode(0, std::move(root));
        report = whole.report();
        report.sortSteps += ofRoot.sortSteps;
    };
    withThreads(settings.threads, run);
    KdTree tree = std::move(whole.tree());
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    // Parts exist twice while they are grafted.
    const uint64_t treeBytes = growthBytes(tree);
    report.peakBytes = build.bytes.peak() + (build.parallel ? 2 : 1) * treeBytes;
    if (asked != nullptr) *asked = report;
    return tree;
}

}  // namespace cleave
