#include "run/lazy_tree.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"
#include "core/capacity.h"
#include "run/device_build.h"
#include "shared/trace.h"
#include "tree/build_info.h"
#include "tree/open_nodes.h"

namespace cleave {

LazyTree::LazyTree(Device& device, std::shared_ptr<const Context> context, const DeviceTriangles& triangles,
                   const BuildSettings& settings, uint32_t openUpTo, const Capacity& capacity)
    : device_(device),
      context_(std::move(context)),
      commands_(device),
      geometry_(triangles.geometry()),
      settings_(settings) {
    info_ = deviceBuildInfo({&geometry_, 1}, settings, device);
    info_.openUpTo = openUpTo;
    info_.capacity = capacity;
    const Stopwatch watch;
    info_.capacity = requireCapacity(info_, settings.memory);
    buildTop();
    findOpenNodes();
    figures_.ms = figures_.topMs = watch.milliseconds();
}

void LazyTree::reserve() {
    const BuildSizes sizes = requireSizes(info_);
    if (tree_.memory.size() < sizes.tree) {
        tree_.memory = Buffer();
        tree_.memory = Buffer(device_, sizes.tree);
    }
    scratch_.reserve(device_, {sizes.scratch, sizes.scratchCount});
    figures_.peakBytes = std::max(figures_.peakBytes, scratch_.bytes() + tree_.memory.size());
}

TreeHeader LazyTree::run(const Expansion* expansion) {
    commands_.begin();
    if (expansion)
        cmdExpand(commands_.handle(), *context_, info_, *expansion, rangeOf(tree_.memory), scratch_.ranges());
    else
        cmdBuild(commands_.handle(), *context_, info_, rangeOf(tree_.memory), scratch_.ranges());
    commands_.run();
    TreeHeader header;
    tree_.memory.read(0, &header, sizeof(header));
    return header;
}

void LazyTree::buildTop() {
    for (;;) {
        reserve();
        tree_.header = run(nullptr);
        const bool isShort = tree_.header.status == TreeHeader::kShortOfCapacity;
        if (isShort && growCapacity(info_, tree_.header.wanted, settings_.memory)) continue;
        figures_.memoryLimited = isShort;
        return;
    }
}

void LazyTree::findOpenNodes() {
    const TreeHeader& h = tree_.header;
    std::vector<KdNode> nodes(h.nodeCount);
    tree_.memory.read(h.nodes - tree_.address(), nodes.data(), nodes.size() * sizeof(KdNode));
    open_ = openNodesOf(tree_.bounds(), nodes, h.triangleCount - h.nonFinite - h.noArea, info_);
    std::vector<uint32_t> words(nodes.size() + 1, kClosedNode);
    words[0] = h.nodeCount;
    for (const OpenNode& node : open_) {
        words[node.node + 1] = kOpenNode;
        figures_.neverBuilt += node.count;
    }
    words_ = uploaded(device_, std::span<const uint32_t>(words));
    figures_.openNodes = figures_.stillOpen = static_cast<uint32_t>(open_.size());
    figures_.references = h.leafRefCount;
}

std::vector<OpenNode> LazyTree::takeMarked() {
    std::vector<uint32_t> words(words_.size() / sizeof(uint32_t));
    words_.read(0, words.data(), words_.size());
    std::vector<OpenNode> marked;
    std::erase_if(open_, [&](const OpenNode& node) {
        uint32_t& word = words[node.node + 1];
        if (word != kMarkedNode) return false;
        word = kClosedNode;
        marked.push_back(node);
        return true;
    });
    if (!marked.empty()) words_.upload(std::span<const uint32_t>(words));
    return marked;
}

bool LazyTree::expandMarked() {
    const Stopwatch watch;
    std::vector<OpenNode> marked = takeMarked();
    if (marked.empty()) return false;
    expand(std::move(marked));
    figures_.ms += watch.milliseconds();
    return true;
}

void LazyTree::expandAll() {
    if (open_.empty()) return;
    const Stopwatch watch;
    expand(std::exchange(open_, {}));
    figures_.ms += watch.milliseconds();
}

void LazyTree::expand(std::vector<OpenNode> nodes) {
    for (const OpenNode& node : nodes) figures_.neverBuilt -= node.count;
    figures_.stillOpen -= static_cast<uint32_t>(nodes.size());
    for (std::span<OpenNode> left(nodes); !left.empty();) left = left.subspan(build(left));
}

// Builds the first of these nodes, as many as fit; how many that were.
uint32_t LazyTree::build(std::span<OpenNode> nodes) {
    const auto planned = [&] {
        return planExpansion(info_, tree_.header.leafRefCount, nodes.data(), static_cast<uint32_t>(nodes.size()));
    };
    Expansion expansion = planned();
    if (expansion.count == 0 && takeMore({0, 0, 0, tree_.header.leafRefCount + nodes.front().count})) {
        moveToLarger(tree_.header);
        expansion = planned();
    }
    if (expansion.count == 0) return static_cast<uint32_t>(nodes.size());  // they stay leaves
    const Buffer list = uploaded(device_, std::span<const OpenNode>(nodes.first(expansion.count)));
    figures_.expansions++;
    expansion.nodes = list.address();
    const TreeHeader before = tree_.header;
    for (;;) {
        tree_.header = run(&expansion);
        const bool isShort = tree_.header.status == TreeHeader::kShortOfCapacity;
        if (!isShort) break;
        if (!takeMore(tree_.header.wanted)) break;
        moveToLarger(before);
    }
    return expansion.count;
}

// Makes the capacity larger, if that fits the budget beside the tree that is there until then.
bool LazyTree::takeMore(const Capacity& wanted) {
    const uint64_t there = tree_.memory.size();
    const uint64_t left = settings_.memory > there ? settings_.memory - there : 1;
    const bool grows = growCapacity(info_, wanted, settings_.memory == 0 ? 0 : left);
    figures_.memoryLimited |= !grows;
    return grows;
}

// The tree with the counts that it had before an expansion that did not fit.
void LazyTree::moveToLarger(const TreeHeader& before) {
    const BuildSizes sizes = requireSizes(info_);
    Buffer larger(device_, sizes.tree);
    commands_.begin();
    cmdMove(commands_.handle(), *context_, info_, tree_.address(), rangeOf(larger));
    commands_.run();
    figures_.peakBytes = std::max(figures_.peakBytes, scratch_.bytes() + tree_.memory.size() + larger.size());
    tree_.memory = std::move(larger);
    TreeHeader header;
    tree_.memory.read(0, &header, sizeof(header));
    header.status = before.status;
    header.levels = before.levels;
    header.nodeCount = before.nodeCount;
    header.leafRefCount = before.leafRefCount;
    tree_.memory.write(0, &header, sizeof(header));
    scratch_.reserve(device_, {sizes.scratch, sizes.scratchCount});
}

}  // namespace cleave
