// For programs that do not want to write Vulkan: opens a device, loads glTF, builds kd-trees, traces rays, and judges
// the answers by exact arithmetic.
//
// Everything here throws std::runtime_error (or std::bad_alloc); the text says what failed, where, and what to do.
// One thread at a time uses a Device and what was made with it. Rays, hits and modes are those of cleave.hpp.
#pragma once

#include <array>
#include <cleave/cleave.hpp>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace cleave::scene {

// The x, y, z of three vertices, in world space.
using Triangle = std::array<float, 9>;

// What Vulkan offers on this machine.
struct DeviceInfo {
    std::string name;
    std::string type;  // "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;
    std::string apiVersion;
    std::string lacks;    // why it cannot be used; empty if it can
    bool chosen = false;  // the one that a Device opens if none is named
};
std::vector<DeviceInfo> listDevices();

struct DeviceOptions {
    std::string nameOrIndex;  // a part of the name, or the number in listDevices(); empty: the best
    // Receives each message of the validation layers, which are on if it is set (and we open the device).
    std::function<void(const char* message)> onValidation;
    // Load and store compiled pipelines between runs; unset: they are compiled in every run. The key names device and
    // driver.
    std::function<std::vector<char>(const std::string& key)> loadPipelines;
    std::function<void(const std::string& key, std::span<const char> data)> storePipelines;
    bool mapsMemory = true;  // false: device memory is never mapped, as on a discrete GPU; all transfers are staged
};

// A device that the caller has opened, with requirements(); it outlives the Device.
struct AdoptedDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  // with compute; nobody else submits to it during a call
    uint32_t queueFamily = 0;
};

// Bytes that the host wrote to and read from device memory.
struct Transfers {
    uint64_t up = 0;
    uint64_t down = 0;
};

// Device, memory and pipelines. It outlives the meshes and trees that are made with it.
class Device {
  public:
    explicit Device(DeviceOptions options = {});
    Device(const AdoptedDevice& adopted, DeviceOptions options = {});
    ~Device();
    Device(Device&&) noexcept;

    std::string name() const;
    Transfers transfers() const;

  private:
    friend class Mesh;
    struct State;
    std::unique_ptr<State> state_;
};

// What a scene shows at a time.
struct Posed {
    std::vector<Triangle> triangles;  // in scene order: the index is the number of a triangle
    std::vector<std::string> warnings;
};

// A glTF file, kept as it is.
class GltfFile {
  public:
    // .gltf or .glb
    explicit GltfFile(const std::filesystem::path& file);
    ~GltfFile();
    GltfFile(GltfFile&&) noexcept;

    const std::vector<std::string>& warnings() const;  // what is wrong with the file but can be survived
    // The triangles at a time, in seconds; none: the rest pose. `animation` is a name or a number; empty: the first.
    Posed pose(std::optional<double> seconds = {}, const std::string& animation = {}) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// The axes along which median builders look for a split: all, the cell's longest, or one after the other by level.
enum class Axes { all, widest, cycle };

// Each setting is for the builders that know it.
struct BuildSettings {
    float costTraverse = 15.0f;  // SAH costs of an inner node and of a triangle test, 0.001 to 1000
    float costIntersect = 20.0f;
    float costLeaf = 0.0f;     // and of a leaf, 0 to 1000
    float emptyBonus = 0.8f;   // on the cost of a split that leaves a side empty, 0.001 to 1
    uint32_t bins = 32;        // per axis, 2 to 32
    uint32_t exactUpTo = 224;  // nodes of at most so many references are split by exact SAH; at most 1024
    uint32_t maxDepth = 0;     // of a leaf, at most 63; 0: round(8 + 1.3 log2 n)
    bool clip = true;          // clips straddling triangles to both cells
    bool subsample = true;     // bins every l-th reference of a large node, l = max(1, floor(log10 n))
    bool snap = true;          // moves sampled and binned planes to a face of a box beside them
    Axes axes = Axes::cycle;   // of median builders
    uint32_t leafSize = 4;     // median builders stop at so many references
    uint32_t threads = 2;      // of CPU builders that use several
    uint64_t memory = 0;       // bytes that a build on the device (or its twin) may use; 0: no limit
};

// The names of all builders. The first, "gpu" and "gpu-exact", are on the device.
std::vector<std::string_view> builders();

struct TreeCounts {
    uint32_t triangles = 0;      // of the mesh, or of the list
    uint32_t nonFinite = 0;      // left out: a vertex is not finite
    uint32_t noArea = 0;         // left out: the vertices lie on a line
    uint32_t nodes = 0;          // inner nodes and leaves
    uint32_t references = 0;     // of all leaves
    uint64_t bytes = 0;          // of the tree on the device
    uint64_t peakBytes = 0;      // that the build held at once
    uint32_t attempts = 1;       // 1 + how often a build on the device ran short of capacity and was repeated
    bool memoryLimited = false;  // the budget was met: the last levels were finished as leaves; answers stay right
    double ms = 0.0;             // from triangles in the builder's memory to a tree
};

struct Answers {
    std::vector<TraceHit> hits;     // one per ray
    std::vector<TraceSteps> steps;  // one per ray where mode.countSteps, else empty
    double ms = 0.0;                // on the device, the rays being there
    uint64_t invalidRays = 0;       // answered as misses
    uint64_t unfinishedRays = 0;    // given up after 2^30 steps: none, in trees of builders()
};

using Point = std::array<float, 3>;

// A closed box. It may be flat, or a point.
struct Box {
    Point lo;
    Point hi;
};

// What a query refuses: a point that is not finite, a box with lo > hi or a part that is no number.
class BadItem : public std::runtime_error {
  public:
    BadItem(const std::string& text, size_t firstBad) : std::runtime_error(text), row(firstBad) {}
    size_t row;  // the first that is bad
};

// Inside and outside are asked of a surface that is not closed.
class NotClosed : public std::runtime_error {
  public:
    NotClosed(const std::string& text, uint64_t edges) : std::runtime_error(text), openEdges(edges) {}
    uint64_t openEdges;  // that belong to an odd number of triangles
};

// Answers to queries; docs/queries.md says what each promises. `ms` is the time on the device, or of the host.
struct AllHits {
    std::vector<TraceHit> hits;  // hitsPerRay of each ray: by t, then by number; misses fill up its row
    double ms = 0.0;
    uint64_t invalidRays = 0;
};
struct Counts {
    std::vector<int32_t> counts;  // one per ray; 0 for one that is not valid
    double ms = 0.0;
    uint64_t invalidRays = 0;
};
struct Nearest {
    std::vector<TraceHit> hits;  // one per point; t is the distance
    double ms = 0.0;
};
struct Contained {
    std::vector<uint8_t> isInside;  // one per point: 1 inside or on the surface, else 0
    double ms = 0.0;
};
struct SignedDistances {
    std::vector<float> distances;  // one per point: negative inside, 0 on the surface
    double ms = 0.0;
};
struct Overlap {
    uint32_t box;
    uint32_t triangle;
};
struct Overlaps {
    std::vector<Overlap> pairs;  // ascending
    double ms = 0.0;
};

// A tree on the device.
class Tree {
  public:
    ~Tree();
    Tree(Tree&&) noexcept;
    Tree& operator=(Tree&&) noexcept;

    const TreeCounts& counts() const { return counts_; }
    VkDeviceAddress address() const;  // for TraceInfo::tree, and for shaders that include cleave.glsl
    // `from`: hits of another tree over the same mesh to go on from, one per ray; empty: none.
    Answers trace(std::span<const TraceRay> rays, const TraceMode& mode = {},
                  std::span<const TraceHit> from = {}) const;

    // All hits of rays, edges and vertices of closed surfaces once. hitsPerRay is from 1 to 2^20.
    AllHits all(std::span<const TraceRay> rays, uint32_t hitsPerRay) const;
    Counts count(std::span<const TraceRay> rays, bool isSigned = false) const;
    // The nearest triangle that is at most `within` away. Throws BadItem, as the others do that ask about points.
    Nearest nearest(std::span<const Point> points, float within = std::numeric_limits<float>::infinity()) const;
    // Throw NotClosed unless each edge belongs to an even number of the tree's triangles.
    Contained contains(std::span<const Point> points) const;
    SignedDistances signedDistance(std::span<const Point> points) const;
    Overlaps overlaps(std::span<const Box> boxes) const;

    // The tree as bytes, for Mesh::load(). A tree over a list of triangles has none.
    std::vector<std::byte> save() const;

  private:
    friend class Mesh;
    struct State;
    Tree(std::unique_ptr<State> state, const TreeCounts& counts);
    std::unique_ptr<State> state_;
    TreeCounts counts_;
};

// What the exact reference says about hits. Undecided: the answer is not the exact one, but within a rounding of it.
struct Judgement {
    uint64_t rays = 0;  // that were judged
    uint64_t mismatches = 0;
    uint64_t undecided = 0;
    double maxRelativeTError = 0.0;
    std::string firstMismatch;  // a sentence; empty if there is none
};

// The same queries on the CPU, over all triangles and plainly: answers are those of trees, bit for bit.
class Twin {
  public:
    ~Twin();
    Twin(Twin&&) noexcept;

    AllHits all(std::span<const TraceRay> rays, uint32_t hitsPerRay) const;
    Counts count(std::span<const TraceRay> rays, bool isSigned = false) const;
    Nearest nearest(std::span<const Point> points, float within = std::numeric_limits<float>::infinity()) const;
    Contained contains(std::span<const Point> points) const;
    SignedDistances signedDistance(std::span<const Point> points) const;
    Overlaps overlaps(std::span<const Box> boxes) const;

  private:
    friend class Mesh;
    struct State;
    explicit Twin(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// Triangles on the host and, once they are needed there, on the device.
class Mesh {
  public:
    Mesh(Device& device, std::span<const Triangle> triangles);
    ~Mesh();
    Mesh(Mesh&&) noexcept;

    // `list`: ascending numbers of the triangles that the tree is built over; empty: all.
    Tree build(std::string_view builder = "gpu", const BuildSettings& settings = {},
               std::span<const uint32_t> list = {});
    // A tree of these triangles from the bytes of Tree::save(). Refuses others, and what was changed or cut.
    Tree load(std::span<const std::byte> saved);
    Twin twin(uint32_t threads = 2) const;
    // Judges up to `count` of the rays, spread evenly. hits[i] answers rays[i] over all triangles of the mesh.
    Judgement judge(std::span<const TraceRay> rays, std::span<const TraceHit> hits, Query query, uint64_t count,
                    uint32_t threads = 2);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cleave::scene
#pragma GCC visibility pop
