#include "tree/kd_tree.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "shared/build.h"

namespace cleave {
namespace {

// FNV-1a over 32-bit words, finished by the mixer of MurmurHash3.
class Hash {
  public:
    void add(uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) state_ = (state_ ^ (word >> shift & 0xFFu)) * 0x100000001B3u;
    }
    uint64_t value() const {
        uint64_t h = state_;
        h = (h ^ h >> 33) * 0xFF51AFD7ED558CCDu;
        h = (h ^ h >> 33) * 0xC4CEB9FE1A85EC53u;
        return h ^ h >> 33;
    }

  private:
    uint64_t state_ = 0xCBF29CE484222325u;
};

[[noreturn]] void refuse(uint64_t node) {
    throw Error("cannot hash the tree: node " + std::to_string(node) +
                " links to what is not there or was seen before; validate the tree first");
}

void addLeaf(Hash& hash, const KdTree& tree, uint32_t node, std::vector<uint32_t>& list) {
    const uint64_t first = leafFirst(tree.nodes[node]);
    const uint64_t count = leafCount(tree.nodes[node]);
    if (first + count > tree.leafTriangles.size()) refuse(node);
    const auto begin = tree.leafTriangles.begin() + static_cast<std::ptrdiff_t>(first);
    list.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    std::sort(list.begin(), list.end());
    hash.add(kLeafAxis);
    hash.add(static_cast<uint32_t>(count));
    for (const uint32_t triangle : list) hash.add(triangle);
}

std::string hexadecimal(uint64_t value) {
    std::string text(16, '0');
    for (size_t i = 0; i < 16; ++i) text[i] = "0123456789abcdef"[value >> (60 - 4 * i) & 15u];
    return text;
}

}  // namespace

uint32_t depthLimit(const BuildSettings& settings, uint64_t triangleCount) {
    return depthLimit(settings.maxDepth, static_cast<uint32_t>(std::min<uint64_t>(triangleCount, kMaxLink)));
}

// Bounds and exponent are no choice of a builder and stay out.
std::string treeHash(const KdTree& tree) {
    Hash hash;
    std::vector<uint32_t> queue{0};  // breadth-first; what was treated stays in front
    std::vector<uint32_t> list;
    if (tree.nodes.empty()) refuse(0);
    for (size_t next = 0; next < queue.size(); ++next) {
        const uint32_t index = queue[next];
        const KdNode node = tree.nodes[index];
        if (isLeaf(node)) {
            addLeaf(hash, tree, index, list);
            continue;
        }
        const uint32_t child = nodeChild(node);
        if (child + size_t{1} >= tree.nodes.size() || queue.size() + 2 > tree.nodes.size()) refuse(index);
        hash.add(nodeAxis(node));
        hash.add(node.plane);
        queue.push_back(child);
        queue.push_back(child + 1);
    }
    return hexadecimal(hash.value());
}

}  // namespace cleave
