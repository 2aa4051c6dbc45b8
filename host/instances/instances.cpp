#include "instances/instances.h"

#include <algorithm>

#include "instances/mesh_shape.h"
#include "instances/place_mesh.h"

namespace cleave {
namespace {

uint32_t largestReach(std::span<const Triangle> triangles) {
    uint32_t reach = 0;
    for (const Triangle& t : triangles) reach = std::max({reach, reachOf(t.a), reachOf(t.b), reachOf(t.c)});
    return reach;
}

Box boundsOf(std::span<const Triangle> triangles) {
    Box bounds = emptyBox();
    for (const Triangle& t : triangles)
        if (isFiniteTriangle(t)) bounds = including(including(including(bounds, t.a), t.b), t.c);
    return bounds;
}

// Of those that a tree with this scale is built over.
Box boundsOfIncluded(std::span<const Triangle> triangles, int exponent) {
    Box bounds = emptyBox();
    for (const Triangle& world : triangles) {
        if (!isFiniteTriangle(world)) continue;
        const Triangle t = scaledTriangle(world, -exponent);
        if (!liesOnALine(t)) bounds = including(including(including(bounds, t.a), t.b), t.c);
    }
    return bounds;
}

Box both(const Box& a, const Box& b) { return isEmpty(b) ? a : including(including(a, b.lo), b.hi); }

Box scaled(const Box& box, int exponent) {
    return {timesPowerOfTwo(box.lo, -exponent), timesPowerOfTwo(box.hi, -exponent)};
}

constexpr int kLeastShift = -30;

class Placing {
  public:
    explicit Placing(SharedPose& shared) : shared_(shared) {
        for (const SharedMesh& mesh : shared.meshes) shapes_.push_back(shapeOf(mesh.triangles));
        for (const MeshPlace& place : shared.places) extents_.push_back(extentOf(shapes_[place.mesh], place.toWorld));
        made_.triangles = shared.triangles;
        made_.bounds = boundsOf(shared.posed.triangles);
        uint32_t reach = largestReach(shared.posed.triangles);
        for (const PlacedExtent& extent : extents_) reach = std::max(reach, extent.reach);
        made_.exponent = sceneExponent(reach);
    }

    Instances run() {
        for (size_t i = 0; i < shared_.places.size(); ++i) place(shared_.places[i], extents_[i]);
        if (restIsTooSmall()) copyAll();
        gatherRest();
        keepMeshes();
        placeRest();
        grow();
        return std::move(made_);
    }

  private:
    void place(const MeshPlace& at, const PlacedExtent& extent) {
        const MeshShape& shape = shapes_[at.mesh];
        const Box box = scaled(extent.box, made_.exponent);
        std::optional<PlacedMesh> placed;
        if (shape.isKept && extent.isPlain && !shape.vertices.empty())
            placed = placeMesh(at.toWorld, shape.exponent, made_.exponent, box);
        if (!placed) return copy(at);
        placed->first = at.first;
        placed_.push_back(*placed);
        meshOf_.push_back(at.mesh);
        boxes_.push_back(box);
        made_.bounds = both(made_.bounds, extent.all);
        made_.noArea += shape.noArea;
        for (const uint32_t sliver : shape.slivers) copy(at, sliver);
    }

    void copy(const MeshPlace& at, uint32_t triangle) {
        copies_.push_back(inPlace(at.toWorld, shared_.meshes[at.mesh].triangles[triangle]));
        copyNumbers_.push_back(at.first + triangle);
    }

    void copy(const MeshPlace& at) {
        const size_t first = copies_.size();
        for (uint32_t i = 0; i < shared_.meshes[at.mesh].triangles.size(); ++i) copy(at, i);
        made_.bounds = both(made_.bounds, boundsOf(std::span(copies_).subspan(first)));
        made_.copiedPlaces++;
    }

    // A rest so small beside the scene that double would not lead into its tree.
    bool restIsTooSmall() const {
        const uint32_t reach = std::max(largestReach(shared_.posed.triangles), largestReach(copies_));
        return reach != 0 && sceneExponent(reach) - made_.exponent < kLeastShift;
    }

    void copyAll() {
        placed_.clear();
        meshOf_.clear();
        boxes_.clear();
        copies_.clear();
        copyNumbers_.clear();
        made_.copiedPlaces = 0;
        made_.noArea = 0;
        for (const MeshPlace& at : shared_.places) copy(at);
    }

    // Puts copies among the triangles that were never to be placed. Both are in order of their numbers.
    void gatherRest() {
        std::vector<Triangle>& own = shared_.posed.triangles;
        std::vector<uint32_t>& numbers = shared_.numbers;
        if (copies_.empty()) {
            made_.rest = std::move(own);
            made_.restNumbers = std::move(numbers);
            return;
        }
        for (size_t i = 0, k = 0; i < own.size() || k < copies_.size();) {
            const bool takesCopy = i == own.size() || (k < copies_.size() && copyNumbers_[k] < numbers[i]);
            made_.rest.push_back(takesCopy ? copies_[k] : own[i]);
            made_.restNumbers.push_back(takesCopy ? copyNumbers_[k++] : numbers[i++]);
        }
    }

    // Those that stand somewhere.
    void keepMeshes() {
        std::vector<uint32_t> index(shared_.meshes.size(), kNone);
        for (uint32_t& mesh : meshOf_) {
            if (index[mesh] == kNone) {
                index[mesh] = uint32_t(made_.meshes.size());
                made_.meshes.push_back(std::move(shared_.meshes[mesh].triangles));
            }
            mesh = index[mesh];
        }
    }

    void placeRest() {
        const Box bounds = boundsOfIncluded(made_.rest, made_.exponent);
        if (isEmpty(bounds)) return;
        placed_.push_back(placeWorld(sceneExponent(largestReach(made_.rest)), made_.exponent));
        meshOf_.push_back(uint32_t(made_.meshes.size()));
        boxes_.push_back(bounds);
    }

    void grow() {
        PlaceTree tree = placeTreeOf(boxes_);
        made_.nodes = std::move(tree.nodes);
        for (const uint32_t place : tree.order) {
            made_.places.push_back(placed_[place]);
            made_.treeOf.push_back(meshOf_[place]);
        }
    }

    SharedPose& shared_;
    Instances made_;
    std::vector<MeshShape> shapes_;      // of each mesh
    std::vector<PlacedExtent> extents_;  // of each place
    std::vector<PlacedMesh> placed_;
    std::vector<uint32_t> meshOf_;  // of each that is placed
    std::vector<Box> boxes_;        // likewise
    std::vector<Triangle> copies_;
    std::vector<uint32_t> copyNumbers_;
};

}  // namespace

Instances instancesOf(SharedPose& shared) { return Placing(shared).run(); }

}  // namespace cleave
