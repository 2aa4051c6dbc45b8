#include <bit>

#include "twin/passes.h"

namespace cleave::twin {

namespace {

// A node of a level of a batch's subtrees.
struct Node {
    Box cell;
    uint32_t staged;
    std::vector<PrimRef> refs;
};

// The subtrees of a batch, level by level.
struct Growth {
    BuildArrays& a;
    uint32_t depth;
    KdNode* nodes;
    uint32_t* leafRefs;
    Subtrees made{};
    uint32_t workRefs = 0;  // what the device's workgroup holds: all references that there were
    uint32_t cuts = 0;      // references that straddle planes of the level

    struct Halves {
        std::vector<PrimRef> left, right;
    };
    Halves halvesOf(const Node& node, const Split& s) {
        Halves h;
        const int axis = static_cast<int>(s.axis);
        for (const PrimRef& r : node.refs) {
            const uint32_t side = sideOf(r.lo[axis], r.hi[axis], s.position, s.planarLeft);
            if (side == (kLeft | kRight)) {
                const SplitBoxes parts = partsOf(a, r, s);
                if (!isEmpty(parts.left)) h.left.push_back({parts.left.lo, r.prim, parts.left.hi, 0});
                if (!isEmpty(parts.right)) h.right.push_back({parts.right.lo, r.prim, parts.right.hi, 0});
                workRefs += 2;
                cuts++;
            } else {
                (side == kLeft ? h.left : h.right).push_back(r);
            }
        }
        return h;
    }

    // The next level; false if it outgrows the workgroup. Nothing of it is written then.
    bool grow(std::vector<Node>& level) {
        const uint32_t at = depth + made.levels;
        cuts = 0;
        std::vector<Split> splits;
        std::vector<Halves> halves;
        uint32_t children = 0, refs = 0, leaves = 0, next = 0;
        for (const Node& node : level) {
            const auto count = static_cast<uint32_t>(node.refs.size());
            const Split best = bestFace(a.args.costs, node.refs, node.cell);
            const bool split = isWorthwhile(a.args.costs, best, node.cell, count, at, a.state.maxDepth);
            splits.push_back(split ? best : noSplit());
            halves.push_back(split ? halvesOf(node, best) : Halves{});
            const Halves& h = halves.back();
            children += split ? 2 : 0;
            leaves += split ? 0 : count;
            refs += static_cast<uint32_t>(h.left.size() + h.right.size());
            next += !h.left.empty() + !h.right.empty();
        }
        if (workRefs > kWorkRefs || cuts > kWorkCuts || refs > kWorkList || next > kWorkNodes ||
            made.nodes + children > kStagedNodes || made.leafRefs + leaves > kStagedRefs)
            return false;
        std::vector<Node> grown;
        const auto child = [&](Box cell, std::vector<PrimRef>& of) {
            if (of.empty())
                nodes[made.nodes] = leafNode(made.leafRefs, 0);
            else
                grown.push_back({cell, made.nodes, std::move(of)});
            made.nodes++;
        };
        for (size_t k = 0; k < level.size(); k++) {
            const Node& node = level[k];
            const Split& s = splits[k];
            if (s.axis == kLeafAxis) {
                nodes[node.staged] = leafNode(made.leafRefs, static_cast<uint32_t>(node.refs.size()));
                for (const PrimRef& r : node.refs) leafRefs[made.leafRefs++] = r.prim;
            } else {
                nodes[node.staged] = innerNode(s.axis, s.position, made.nodes);
                child(leftOf(node.cell, s.axis, s.position), halves[k].left);
                child(rightOf(node.cell, s.axis, s.position), halves[k].right);
            }
        }
        made.levels++;
        level = std::move(grown);
        return true;
    }
};

void buildBatch(BuildArrays& a, uint32_t depth, uint32_t batch) {
    const Level& level = a.state.level[depth];
    const std::vector<PrimRef>& refs = a.refsIn(depth);
    const bool isLast = batch + 1 == ceilDiv(level.subtreeRefCount, kBatch);
    const uint32_t first = a.batchFirsts[batch];
    const uint32_t end = isLast ? level.nodeCount : a.batchFirsts[batch + 1];
    a.subtrees[batch] = {};
    a.blockSums[batch] = glm::uvec4(0);
    Growth growth{a, depth, &a.stagedNodes[size_t{batch} * kStagedNodes], &a.stagedRefs[size_t{batch} * kStagedRefs]};
    std::vector<Node> roots;
    for (uint32_t n = first; n < end; n++) {
        const BuildNode& node = a.nodesIn(depth)[n];
        if (!isSubtree(node.count, a.args.exactUpTo)) continue;
        const auto from = refs.begin() + node.first;
        roots.push_back({node.cell, static_cast<uint32_t>(roots.size()), {from, from + node.count}});
        growth.workRefs += node.count;
    }
    if (roots.empty()) return;
    growth.made.roots = growth.made.nodes = static_cast<uint32_t>(roots.size());
    while (!roots.empty())
        if (!growth.grow(roots)) return;
    growth.made.firstNode = first;
    growth.made.endNode = end;
    a.subtrees[batch] = growth.made;
    a.blockSums[batch] = {0, 0, growth.made.nodes - growth.made.roots, growth.made.leafRefs};
    uint32_t root = 0;
    for (uint32_t n = first; n < end; n++) {
        BuildNode& node = a.nodesIn(depth)[n];
        if (!isSubtree(node.count, a.args.exactUpTo)) continue;
        node.split.axis = kSubtreeAxis;
        node.child = root++;
    }
}

}  // namespace

void subtrees(BuildArrays& a, uint32_t depth) {
    const uint32_t batches = ceilDiv(a.state.level[depth].subtreeRefCount, kBatch);
    for (uint32_t batch = 0; batch < batches; batch++) buildBatch(a, depth, batch);
    a.state.batchesTaken += batches + std::min(batches, a.args.workers);
}

}  // namespace cleave::twin
