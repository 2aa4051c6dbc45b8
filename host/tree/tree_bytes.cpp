#include "tree/tree_bytes.h"

#include <bit>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/hash.h"

namespace cleave {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr uint32_t kMagic = 0x54564C43u;  // "CLVT"
constexpr uint64_t kHashWords = 2;

struct Head {
    uint32_t magic = kMagic;
    uint32_t version = kTreeBytesVersion;
    uint32_t triangles = 0;
    uint32_t nodes = 0;
    uint32_t references = 0;
    int32_t exponent = 0;
    Box bounds;
    uint32_t identity[kHashWords] = {};  // of the triangles
};
static_assert(sizeof(Head) == 14 * sizeof(uint32_t));
constexpr uint64_t kHeadWords = sizeof(Head) / sizeof(uint32_t);

using Words = std::vector<uint32_t>;

void append(Words& words, const void* from, uint64_t count) {
    const size_t at = words.size();
    words.resize(at + count);
    if (count > 0) std::memcpy(&words[at], from, count * sizeof(uint32_t));
}

void putHash(const Hash& hash, uint32_t (&to)[kHashWords]) {
    to[0] = static_cast<uint32_t>(hash.value());
    to[1] = static_cast<uint32_t>(hash.value() >> 32);
}

Hash hashOf(std::span<const uint32_t> words) {
    Hash hash;
    for (const uint32_t word : words) hash.add(word);
    return hash;
}

Hash identityOf(std::span<const Triangle> world) {
    Hash hash;
    hash.add(static_cast<uint32_t>(world.size()));
    for (const Triangle& t : world)
        for (const vec3& v : {t.a, t.b, t.c})
            for (int axis = 0; axis < 3; ++axis) hash.add(floatBitsToUint(v[axis]));
    return hash;
}

bool isEqual(const Hash& hash, const uint32_t* words) {
    uint32_t wanted[kHashWords];
    putHash(hash, wanted);
    return std::memcmp(wanted, words, sizeof wanted) == 0;
}

[[noreturn]] void refuse(const std::string& why) { throw Error("cannot load the tree: " + why); }

Head headOf(const Words& words) {
    Head head;
    if (words.size() < kHeadWords) refuse("it ends within its first bytes; save it again");
    std::memcpy(static_cast<void*>(&head), words.data(), sizeof head);
    if (head.magic != kMagic) refuse("these bytes are none; save one first");
    if (head.version != kTreeBytesVersion)
        refuse("its format is " + std::to_string(head.version) + ", and this program reads " +
               std::to_string(kTreeBytesVersion) + "; save it again");
    const uint64_t whole = kHeadWords + 2 * uint64_t{head.nodes} + head.references + kHashWords;
    if (words.size() != whole)
        refuse("it has " + std::to_string(words.size() * sizeof(uint32_t)) + " bytes, and its head asks for " +
               std::to_string(whole * sizeof(uint32_t)) + "; save it again");
    if (!isEqual(hashOf(std::span(words).first(whole - kHashWords)), &words[whole - kHashWords]))
        refuse("its checksum differs, so that it is not as it was written; save it again");
    return head;
}

// Each node once, from the root; a path is no longer than the stacks of those that walk it.
void requireWalkable(const KdTree& tree, uint64_t triangles) {
    struct Entry {
        uint32_t node, depth;
    };
    const auto broken = [](uint32_t node, const char* what) {
        refuse("node " + std::to_string(node) + " " + what + "; build it anew");
    };
    std::vector<bool> isReached(tree.nodes.size());
    uint64_t reached = 0;
    std::vector<Entry> waiting{{0, 0}};
    while (!waiting.empty()) {
        const auto [at, depth] = waiting.back();
        waiting.pop_back();
        if (at >= tree.nodes.size()) broken(at, "is not there");
        if (isReached[at]) broken(at, "is reached twice");
        if (depth > kMaxDepth) broken(at, "is too deep");
        isReached[at] = true;
        ++reached;
        const KdNode node = tree.nodes[at];
        if (isLeaf(node)) {
            if (uint64_t{leafFirst(node)} + leafCount(node) > tree.leafTriangles.size())
                broken(at, "lists more references than there are");
            continue;
        }
        if (!isFinite(nodePosition(node))) broken(at, "has a plane that is not finite");
        waiting.push_back({nodeChild(node) + 1, depth + 1});
        waiting.push_back({nodeChild(node), depth + 1});
    }
    if (reached != tree.nodes.size()) refuse("some of its nodes are never reached; build it anew");
    for (const uint32_t number : tree.leafTriangles)
        if (number >= triangles)
            refuse("it lists triangle " + std::to_string(number) + " of " + std::to_string(triangles) +
                   "; build it anew");
}

}  // namespace

std::vector<std::byte> bytesOfTree(const KdTree& tree, std::span<const Triangle> world) {
    Head head;
    head.triangles = static_cast<uint32_t>(world.size());
    head.nodes = static_cast<uint32_t>(tree.nodes.size());
    head.references = static_cast<uint32_t>(tree.leafTriangles.size());
    head.exponent = tree.exponent;
    head.bounds = tree.bounds;
    putHash(identityOf(world), head.identity);
    Words words;
    append(words, &head, kHeadWords);
    append(words, tree.nodes.data(), 2 * tree.nodes.size());
    append(words, tree.leafTriangles.data(), tree.leafTriangles.size());
    uint32_t checksum[kHashWords];
    putHash(hashOf(words), checksum);
    append(words, checksum, kHashWords);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(words));
    return {bytes.begin(), bytes.end()};
}

KdTree treeOfBytes(std::span<const std::byte> bytes, std::span<const Triangle> world, const TriangleSet& set) {
    if (bytes.size() % sizeof(uint32_t) != 0) refuse("its last bytes are missing; save it again");
    Words words(bytes.size() / sizeof(uint32_t));
    if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
    const Head head = headOf(words);
    if (head.triangles != world.size() || !isEqual(identityOf(world), head.identity))
        refuse("it was built over other triangles than these; build it anew");
    KdTree tree;
    tree.bounds = set.bounds;
    tree.exponent = set.exponent;
    const bool isSame =
        head.exponent == set.exponent && head.bounds.lo == set.bounds.lo && head.bounds.hi == set.bounds.hi;
    if (!isSame && !set.included.empty())  // builders differ in what they call the bounds of nothing
        refuse("its bounds are not those of its triangles; build it anew");
    tree.nodes.resize(head.nodes);
    tree.leafTriangles.resize(head.references);
    const uint32_t* from = words.data() + kHeadWords;
    std::memcpy(tree.nodes.data(), from, tree.nodes.size() * sizeof(KdNode));
    if (head.references > 0)
        std::memcpy(tree.leafTriangles.data(), from + 2 * uint64_t{head.nodes}, head.references * sizeof(uint32_t));
    requireWalkable(tree, world.size());
    return tree;
}

}  // namespace cleave
