// cleave records ray queries into the caller's command buffer: it builds a kd-tree over triangles, compacts it, and
// traces rays through it, on any Vulkan 1.3 device that has the features of requirements().
//
// Everything belongs to the caller: device, memory, command buffers, submission. Between calls nothing is kept but the
// pipelines in a Context, which is immutable: any number of threads may record with it. No call throws, waits, reads
// back, prints or looks at the environment; calls that record cannot fail.
//
// Memory is given as ranges of buffers. Ask buildSizes() how large they must be; the answer depends on counts alone.
// A tree is opaque, like a Vulkan acceleration structure, except for the TreeHeader that it begins with. It holds
// device addresses of its own parts: move it by cmdCompact(), not by copying bytes.
//
// Barriers. Within a call they are recorded for you. Before a call, what it reads must be available to compute shader
// reads (and a tree that is built again, to writes). What a call wrote is available after a barrier from
// VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT (clear) with shader and transfer write
// access.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cleave/modes.hpp>
#include <memory>

#pragma GCC visibility push(default)
namespace cleave {

// Versions of this interface, of the bytes of a tree, and of the answers: the last is raised whenever a bit of a hit
// may change.
inline constexpr uint32_t kApiVersion = 8;
inline constexpr uint32_t kTreeFormat = 2;
inline constexpr uint32_t kAnswersVersion = 2;

// The device features that a Context needs. Chain `vulkan12` and `vulkan13` into VkDeviceCreateInfo, or set the same
// members in structs of your own.
struct Requirements {
    uint32_t apiVersion;  // VK_API_VERSION_1_3
    VkPhysicalDeviceFeatures features;
    VkPhysicalDeviceVulkan12Features vulkan12;  // sType is set, pNext is null
    VkPhysicalDeviceVulkan13Features vulkan13;
};
Requirements requirements();

struct ContextInfo {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;  // created with requirements()
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;  // optional; yours to load and to store
    const VkAllocationCallbacks* allocator = nullptr;
    // The modes that cmdTrace() will be asked for; null: closest and any hits by restart, watertight, uncounted.
    const TraceMode* modes = nullptr;
    uint32_t modeCount = 0;
    // The searches that cmdSearch() will be asked for.
    const Search* searches = nullptr;
    uint32_t searchCount = 0;
    // Off: no pipelines to build with, for programs that only trace.
    bool builds = true;
    bool exactBuilds = false;  // with those of BuildInfo::exact, too
    bool expands = false;      // with those of cmdExpand(), too
    // The most workgroups in a row of a dispatch; 0: 65535, which every device takes. Tests make it tiny.
    uint32_t longestRow = 0;
    // Lanes of the workgroups that build, a power of two from 8 to 256; 0: what suits the device. Trees do not depend
    // on it. Tests ask for what other devices have.
    uint32_t groupLanes = 0;
};

// Pipelines on a device. Destroy it before the device, when no command buffer that uses it is pending.
class Context {
  public:
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    struct State;
    const State& state() const { return *state_; }  // for the files of cleave

  private:
    friend struct NewContext;
    explicit Context(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// A context, or why there is none.
struct NewContext {
    std::unique_ptr<Context> context;  // null if creation failed
    VkResult result = VK_SUCCESS;
    const char* failed = "";  // what failed, e.g. "creating the pipeline of kernel bin"; a constant of the library

    static NewContext create(const ContextInfo& info) noexcept;
};
inline NewContext createContext(const ContextInfo& info) noexcept { return NewContext::create(info); }

// Bytes of a buffer. The buffer must have the usages that buildSizes() names; `address` is that of the range's first
// byte, a multiple of BuildSizes::alignment.
struct Range {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize size = 0;
    VkDeviceAddress address = 0;
};

// Triangles in device memory, as in VkAccelerationStructureGeometryTrianglesDataKHR.
struct Geometry {
    VkDeviceAddress vertices = 0;  // float x, y, z every vertexStride bytes; a multiple of 4, and so the stride
    VkDeviceSize vertexStride = 12;
    uint32_t vertexCount = 0;
    uint32_t triangleCount = 0;
    // Three per triangle. An index that is not below vertexCount makes a triangle that is left out, as a vertex that
    // is not finite does. VK_INDEX_TYPE_NONE_KHR: vertices 3 i, 3 i + 1 and 3 i + 2.
    VkDeviceAddress indices = 0;  // a multiple of 4
    VkIndexType indexType = VK_INDEX_TYPE_NONE_KHR;
    // VkTransformMatrixKHR, applied in double and rounded to float once; 0: none.
    VkDeviceAddress transform = 0;
};

// How many entries the arrays of a build hold; 0: the default, which suffices for scenes as people have them.
struct Capacity {
    uint32_t refs = 0;        // references of one level; at least one per triangle
    uint32_t levelNodes = 0;  // nodes of one level
    uint32_t nodes = 0;       // of the tree
    uint32_t leafRefs = 0;    // of all leaves
    bool operator==(const Capacity&) const = default;
};

struct BuildInfo {
    // Triangles are numbered through all geometries, in order.
    const Geometry* geometries = nullptr;
    uint32_t geometryCount = 0;
    // The tree's triangles: ascending numbers in device memory; 0: all of them. Static and moving parts can have a
    // tree each this way, with hits that tell the same numbers.
    VkDeviceAddress list = 0;
    uint32_t listCount = 0;

    // Of an inner node, of a triangle test and of a leaf, in the surface area heuristic: finite, of a test positive, of
    // the others 0 or more. Without either a node is split wherever areas times triangles shrink.
    float costTraverse = 15.0f;
    float costIntersect = 20.0f;
    float costLeaf = 0.0f;
    float emptyBonus = 0.8f;  // on the cost of a split that leaves a side empty; above 0, at most 1

    uint32_t bins = 32;        // per axis, 2 to 32
    uint32_t exactUpTo = 224;  // nodes of at most so many references are split by exact SAH; at most 1024
    uint32_t maxDepth = 0;     // of a leaf, at most 63; 0: round(8 + 1.3 log2 n)
    // Lazy building (Hunt et al. 2007): nodes of more than 32 and at most so many references (but at least exactUpTo)
    // are left open, as leaves for now; see cmdExpand(). 0: none.
    uint32_t openUpTo = 0;
    bool clip = true;       // clips straddling triangles to both cells
    bool subsample = true;  // bins every l-th reference of a large node, l = max(1, floor(log10 n))
    bool snap = true;       // moves the plane of a large node from the boundary of bins to a face of a box beside it
    // Splits large nodes by exact SAH, too, whatever bins, subsample and snap say: ContextInfo::exactBuilds.
    bool exact = false;
    Capacity capacity;
    // The largest range of memory that the caller can give, e.g. maxMemoryAllocationSize; 0: any. Scratch that is
    // larger comes in several ranges. The tree and the largest scratch array must fit in one.
    VkDeviceSize largestRange = 0;
    // Does also what cannot matter, to show what leaving it out saves: passes for large nodes where there are too few
    // triangles for one, and bins of axes on which a node is flat. The tree is the same.
    bool everything = false;

    // Called while recording, before the first pass and after each: for timestamps and labels.
    void (*onPass)(void* user, VkCommandBuffer commands, const char* pass) = nullptr;
    void* user = nullptr;
};

struct BuildSizes {
    static constexpr uint32_t kMostScratch = 16;
    VkDeviceSize tree = 0;  // 0: it cannot be built, see `failed`
    // Of each range of scratch memory; free again when the build is done. One, unless BuildInfo::largestRange is met.
    VkDeviceSize scratch[kMostScratch] = {};
    uint32_t scratchCount = 0;
    VkDeviceSize alignment = 64;
    VkBufferUsageFlags usage = 0;  // of either
    Capacity capacity;             // with the defaults filled in
    const char* failed = nullptr;
};
BuildSizes buildSizes(const BuildInfo& info) noexcept;

// The capacity that a build with default settings starts with.
Capacity defaultCapacity(uint32_t triangles) noexcept;

// The first bytes of a tree. Written on the device by cmdBuild(); read it back to learn how a build went.
struct TreeHeader {
    static constexpr uint32_t kMagic = 0x56454C43;   // "CLEV"
    static constexpr uint32_t kShortOfCapacity = 1;  // the last levels were finished as leaves; the tree is valid

    uint32_t magic;
    uint32_t format;  // kTreeFormat
    uint32_t status;  // 0 or kShortOfCapacity
    uint32_t levels;  // depth of the deepest leaf + 1
    uint32_t triangleCount;
    uint32_t nodeCount;
    uint32_t leafRefCount;
    uint32_t nonFinite;  // triangles that were left out: a vertex is not finite
    uint32_t noArea;     // the vertices lie on a line
    int32_t exponent;    // world = scaled * 2^exponent
    float lo[3];         // bounds of the root cell, scaled
    float hi[3];
    Capacity wanted;       // what the build would have needed, where that was more than it had; else 0
    uint64_t bytes;        // of the tree without slack: what cmdCompact() needs
    uint64_t wantedBytes;  // of a tree with `wanted`; 0 where the capacity sufficed
    uint32_t reserved[2];
    VkDeviceAddress triangles;  // 40 bytes each: the vertices, scaled, and the number
    VkDeviceAddress nodes;      // 8 bytes each
    VkDeviceAddress leafRefs;   // 4 bytes each: indices of triangles, leaf by leaf
};
static_assert(sizeof(TreeHeader) == 128);

// Builds a tree in `tree`, using the ranges of `scratch`, all at least as large as buildSizes() said for the same info.
void cmdBuild(VkCommandBuffer commands, const Context& context, const BuildInfo& info, const Range& tree,
              const Range* scratch) noexcept;

// A leaf that was left open: one with more than 32 references and at most openLimit(), at a depth where it may be
// split.
struct OpenNode {
    float lo[3];  // its cell, scaled: the root's, cut by the planes above it
    float hi[3];
    uint32_t node;    // its number among the tree's nodes
    uint32_t first;   // of its entries in the leaf list
    uint32_t count;   // of its references
    uint32_t depth;   // the root's is 0
    uint32_t before;  // planExpansion() sets this
    uint32_t chunk;   // and this
};
uint32_t openLimit(const BuildInfo& info) noexcept;

struct Expansion {
    VkDeviceAddress nodes = 0;  // OpenNode
    uint32_t count = 0;         // at most Capacity::levelNodes
    uint32_t refs = 0;          // references of all of them, at most Capacity::refs
    uint32_t depth = 0;         // of the deepest one
};

// Makes an expansion of the first of these nodes: of as many as the capacity of `info` has room for, where the tree has
// `leafRefs` leaf references already (TreeHeader::leafRefCount). Copy them to device memory then, and set its address.
// None where Capacity::leafRefs has no room for one: cmdMove() the tree to more.
Expansion planExpansion(const BuildInfo& info, uint32_t leafRefs, OpenNode* nodes, uint32_t count) noexcept;

// Builds open nodes of a tree further, down to leaves as cmdBuild() without openUpTo makes them: where they were are
// inner nodes (or final leaves) afterwards, all other nodes are where they were, and new ones follow them. `info`,
// `tree` and `scratch` are those of the build. Where the capacity does not suffice the header says so
// (kShortOfCapacity): the tree is valid, and the same nodes can be built once more in a larger range, where cmdMove()
// brings what was there before. The context has `expands`.
void cmdExpand(VkCommandBuffer commands, const Context& context, const BuildInfo& info, const Expansion& expansion,
               const Range& tree, const Range* scratch) noexcept;

// Copies a tree without slack. `to` is at least TreeHeader::bytes of `from` large, and does not overlap it.
void cmdCompact(VkCommandBuffer commands, const Context& context, VkDeviceAddress from, const Range& to) noexcept;

// Copies a tree to a range of a larger capacity, that of `info`, so that it can be expanded there.
void cmdMove(VkCommandBuffer commands, const Context& context, const BuildInfo& info, VkDeviceAddress from,
             const Range& to) noexcept;

// Rays and hits, as device memory holds them. Points are origin + t direction with tMin <= t <= tMax; the direction
// need not be of unit length. u and v weigh the second and third vertex. A miss: t = +inf, prim = 0xFFFFFFFF. A ray
// with a part that is not finite (but for tMax), of no length, or with tMin < 0 or tMin > tMax, is answered as a miss.
struct TraceRay {
    float origin[3];
    float tMin;
    float direction[3];
    float tMax;
};
struct TraceHit {
    float t;
    uint32_t prim;
    float u, v;
};

// Counts over all rays of all calls that were given them; zero them first.
struct TraceCounts {
    uint32_t invalidRays;     // of rays that do not go on from hits: those were counted with the first tree
    uint32_t unfinishedRays;  // see TraceInfo::trails; answered as misses where there are none
};

// The work of one ray, counted.
struct TraceSteps {
    uint32_t inner;      // inner nodes visited, those of restarts included
    uint32_t leaves;     // leaves visited
    uint32_t triangles;  // triangle tests
    uint32_t restarts;
    uint32_t hitLeaf;   // triangles in the leaf of the hit
    uint32_t resolved;  // triangle tests that were decided in double
};

// How t is kept in hits. Rays go through several trees of a scene one after the other, from hits of the one before; t
// may be below the smallest float for a ray whose direction is long, and which of two hits is closer would be lost.
// So hits between trees keep t by a scale that suits the ray. world: t is itself. between: hits are read and written by
// that scale. last: they are read so, and written in the world.
enum class HitScale : uint32_t { world, between, last };

struct TraceInfo {
    VkDeviceAddress tree = 0;  // the address given to cmdBuild() or cmdCompact(); of a PlacedScene with mode.instances
    VkDeviceAddress rays = 0;  // TraceRay
    // TraceHit, one per ray; for Query::all, hitsPerRay in a row per ray, whose rest are misses; for Query::count and
    // signedCount, an int32_t per ray.
    VkDeviceAddress hits = 0;
    uint32_t count = 0;
    uint32_t hitsPerRay = 1;       // of Query::all
    TraceMode mode;                // one of ContextInfo::modes
    VkDeviceAddress counters = 0;  // TraceCounts
    VkDeviceAddress steps = 0;     // TraceSteps per ray; where mode.countSteps
    // What follows is for closest and any hits.
    //
    // Goes on from the hits that are there, of another tree: the closer one stays, and for any-hit queries a hit ends
    // the ray at once. Steps are added to those that are there. Off: hits and steps are written only.
    bool fromHits = false;
    // The first of several trees has `between` and not fromHits, the last one `last`. All have the same hitExponent,
    // the largest TreeHeader::exponent of them.
    HitScale hitScale = HitScale::world;
    int32_t hitExponent = 0;
    // A dispatch gives up on a ray after so many nodes and triangles, so that no ray can hang a device: 0: 2^20. With
    // `trails` (8 bytes per ray) the ray is counted as unfinished, keeps its best hit so far, and goes on where it was
    // in a next call with `resumes`, which leaves finished rays alone.
    uint32_t stepLimit = 0;
    VkDeviceAddress trails = 0;
    bool resumes = false;
    // Where mode.lazy: what cmdBuild() and cmdExpand() have left open, with `trails`: the number of the tree's nodes,
    // then a uint32_t for each, 1 of those that are open, else 0. A ray that comes to one sets it to 2 and is
    // unfinished: it goes on, by a call with `resumes`, once the node has been built further and is 0 here. (By a stack
    // it begins anew, with the hit that it has.)
    VkDeviceAddress open = 0;
};
void cmdTrace(VkCommandBuffer commands, const Context& context, const TraceInfo& info) noexcept;

struct SearchInfo {
    VkDeviceAddress tree = 0;   // the address given to cmdBuild() or cmdCompact()
    VkDeviceAddress items = 0;  // a point is x, y, z; a box its lower corner, then its upper one: float, without gaps
    uint32_t count = 0;         // of points or boxes
    Search search = Search::nearest;  // one of ContextInfo::searches
    // Search::nearest: the farthest that a triangle may be. A TraceHit per point, whose t is the distance; a miss where
    // there is none, or where the point is not finite.
    float within = 3.40282347e38f;
    // Search::contains: a uint32_t per point, 1 inside or on the surface, 0 outside or where the point is not finite.
    // The surface must be closed: see openEdges() of cleave::scene. Search::countOverlaps: a uint32_t per box; 0 where
    // a lower corner is not below the upper one or is no number.
    VkDeviceAddress answers = 0;
    // Search::listOverlaps: a uint32_t per box, the sum of the counts before it; and where the numbers of its triangles
    // go, uint32_t each.
    VkDeviceAddress first = 0;
    VkDeviceAddress numbers = 0;
};
void cmdSearch(VkCommandBuffer commands, const Context& context, const SearchInfo& info) noexcept;

}  // namespace cleave
#pragma GCC visibility pop
