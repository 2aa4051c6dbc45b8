#include "scene/pose.h"

#include <algorithm>

#include "scene/instances.h"
#include "scene/node_transforms.h"
#include "scene/place_camera.h"
#include "scene/pose_primitive.h"
#include "scene/posed_nodes.h"
#include "scene/shared_pose.h"
#include "scene/skin_matrices.h"
#include "scene/triangle_count.h"
#include "shared/geometry.h"

namespace cleave {
namespace {

constexpr size_t kTermsPerTriangle = 64;

// Warnings repeat a node's name for each of its primitives, and a name may be as long as the file.
constexpr size_t kLongestName = 100;

std::string nameOf(const Scene& scene, uint32_t node) {
    const std::string& name = scene.nodes[node].name;
    return "node " + std::to_string(node) + (name.empty() ? "" : " '" + name.substr(0, kLongestName) + "'");
}

bool isNotFinite(const Triangle& t) { return !isFiniteTriangle(t); }

std::string nonFiniteSentence(size_t count, size_t first) {
    return std::to_string(count) + " triangles have a vertex that is not finite, the first is number " +
           std::to_string(first);
}

// The scene while it is posed.
class Posing {
  public:
    // `sharing`: which meshes are kept once; null: none.
    // `nodes`: whose meshes are posed; null: all.
    Posing(const Scene& scene, const PoseTime& time, size_t mostTriangles, Detail detail,
           const Sharing* sharing = nullptr, const std::vector<bool>* nodes = nullptr)
        : scene_(scene),
          sharing_(sharing),
          nodes_(nodes),
          detail_(detail),
          budget_{mostTriangles, kTermsPerTriangle * mostTriangles},
          placed_(poseNodes(scene, time, warnings_)) {
        posed_.name = scene.name;
        const size_t count = countTriangles(scene, mostTriangles);
        if (sharing || nodes) return;
        posed_.triangles.reserve(count);
        posed_.materialOf.reserve(count);
    }

    PosedScene run() {
        addNodes();
        if (const auto warning = nonFiniteWarning(posed_)) warnings_.add(*warning);
        return finished();
    }

    PosedScene runPart() {
        addNodes();
        return finished();
    }

    SharedPose runShared() {
        addNodes();
        shared_.triangles = numbersUsed();
        shared_.posed = finished();
        return std::move(shared_);
    }

  private:
    void addNodes() {
        for (uint32_t node : shownNodes(scene_)) addNode(node);
        completeCorners(posed_);
    }

    PosedScene finished() {
        posed_.warnings = warnings_.list();
        return std::move(posed_);
    }

    size_t numbersUsed() const { return posed_.triangles.size() + inPlaces_; }

    void addNode(uint32_t index) {
        const gltf::Node& node = scene_.nodes[index];
        if (node.camera) addCamera(index);
        if (node.light) addLight(index);
        if (node.mesh && (!nodes_ || (*nodes_)[index])) {
            const size_t before = numbersUsed();
            const size_t first = posed_.triangles.size();
            addMesh(index);
            posed_.meshes.push_back({index, numbersUsed() - before});
            if (!sharing_) return countNonFinite(posed_.meshes.back(), first);
            for (size_t i = first; i < posed_.triangles.size(); ++i)
                shared_.numbers.push_back(uint32_t(before + i - first));
        }
    }

    void countNonFinite(ShownMesh& mesh, size_t first) {
        const std::span<const Triangle> own = std::span(posed_.triangles).subspan(first);
        mesh.nonFinite = size_t(std::ranges::count_if(own, isNotFinite));
        if (mesh.nonFinite > 0) mesh.firstNonFinite = size_t(std::ranges::find_if(own, isNotFinite) - own.begin());
    }

    void addCamera(uint32_t index) {
        const gltf::Node& node = scene_.nodes[index];
        if (const auto camera = placeCamera(scene_.cameras[*node.camera], node.name, placed_.toWorld[index]))
            posed_.cameras.push_back(*camera);
        else
            warnings_.add(nameOf(scene_, index) + " has a camera that shows no picture; it is ignored");
    }

    void addLight(uint32_t index) {
        if (const auto light = placeLight(scene_, *scene_.nodes[index].light, placed_.toWorld[index]))
            posed_.lights.push_back(*light);
        else
            warnings_.add(nameOf(scene_, index) + " has a light that is nowhere, or has no direction; it is ignored");
    }

    void addMesh(uint32_t index) {
        const gltf::Node& node = scene_.nodes[index];
        const std::string name = nameOf(scene_, index);
        if (node.instancing && !hasInstances(scene_, node))
            warnings_.add(name + " is shown once: it has instances, and " +
                          (node.skin ? "also a skin" : "their data is in a buffer that has no URI"));
        // A skinned mesh is where its joints are; its node's own transform does not count.
        const bool hasSkin = node.skin && isPlacedBySkin(*node.skin, name);
        const Deformation deformation{&placed_.states[index].weights, hasSkin ? &skins_.of(*node.skin) : nullptr};
        const InstanceTransforms instances(scene_, node);
        MeshPosing posing{scene_, deformation, instances.count(), detail_, budget_, posed_.leftOut, warnings_};
        const bool isShared = sharing_ && sharing_->meshes[*node.mesh] && !node.skin;
        std::vector<PosablePrimitive> primitives;  // where there are instances, which need all of them one by one
        const std::vector<gltf::Primitive>& all = scene_.meshes[*node.mesh].primitives;
        for (size_t p = 0; p < all.size(); ++p) {
            auto primitive = posing.prepare(all[p], name + ", primitive " + std::to_string(p));
            if (primitive && (isShared || hasInstances(scene_, node)))
                primitives.push_back(std::move(*primitive));
            else if (primitive)
                primitive->appendTo(posed_, placed_.toWorld[index]);
        }
        for (size_t i = 0; i < instances.count() && !primitives.empty(); ++i) {
            const glm::dmat4 toWorld =
                hasInstances(scene_, node) ? placed_.toWorld[index] * instances[i] : placed_.toWorld[index];
            if (isShared)
                place(*node.mesh, primitives, toWorld);
            else
                for (const PosablePrimitive& primitive : primitives) primitive.appendTo(posed_, toWorld);
        }
    }

    // Keeps a mesh as its file has it: an identity moves no float.
    uint32_t keptOnce(uint32_t mesh, const std::vector<PosablePrimitive>& primitives) {
        const auto [known, isNew] = kept_.try_emplace(mesh, uint32_t(shared_.meshes.size()));
        if (!isNew) return known->second;
        PosedScene own;
        for (const PosablePrimitive& primitive : primitives) primitive.appendTo(own, glm::dmat4(1.0));
        shared_.meshes.push_back({std::move(own.triangles), std::move(own.materialOf)});
        return known->second;
    }

    void place(uint32_t mesh, const std::vector<PosablePrimitive>& primitives, const glm::dmat4& toWorld) {
        const uint32_t kept = keptOnce(mesh, primitives);
        shared_.places.push_back({kept, uint32_t(numbersUsed()), toWorld});
        inPlaces_ += shared_.meshes[kept].triangles.size();
    }

    bool isPlacedBySkin(uint32_t skin, const std::string& name) {
        if (hasMatrices(scene_, skin)) return true;
        warnings_.add(name +
                      " is skinned, and the matrices of its skin are in a buffer that has no URI: it is placed "
                      "by its node");
        return false;
    }

    const Scene& scene_;
    const Sharing* sharing_;
    const std::vector<bool>* nodes_;
    Detail detail_;
    Budget budget_;
    Warnings warnings_;
    PosedNodes placed_;
    SkinMatrices skins_{scene_, placed_.toWorld};
    PosedScene posed_;
    SharedPose shared_;
    std::map<uint32_t, uint32_t> kept_;  // mesh -> its index in shared_
    size_t inPlaces_ = 0;                // triangles of places
};

}  // namespace

std::optional<std::string> nonFiniteWarning(std::span<const Triangle> triangles, std::span<const uint32_t> numbers) {
    const auto bad = std::ranges::count_if(triangles, isNotFinite);
    if (bad == 0) return std::nullopt;
    const auto first = size_t(std::ranges::find_if(triangles, isNotFinite) - triangles.begin());
    return nonFiniteSentence(size_t(bad), numbers.empty() ? first : numbers[first]);
}

std::optional<std::string> nonFiniteWarning(const PosedScene& posed) {
    size_t count = 0, first = 0, next = 0;
    for (const ShownMesh& mesh : posed.meshes) {
        if (count == 0 && mesh.nonFinite > 0) first = next + mesh.firstNonFinite;
        count += mesh.nonFinite;
        next += mesh.triangles;
    }
    if (count == 0) return std::nullopt;
    return nonFiniteSentence(count, first);
}

PosedScene pose(const Scene& scene, const PoseTime& time, size_t mostTriangles, Detail detail) {
    return naming("cannot pose '" + scene.name + "'", [&] { return Posing(scene, time, mostTriangles, detail).run(); });
}

PosedScene posePart(const Scene& scene, const PoseTime& time, const std::vector<bool>& nodes, size_t mostTriangles,
                    Detail detail) {
    return naming("cannot pose '" + scene.name + "'",
                  [&] { return Posing(scene, time, mostTriangles, detail, nullptr, &nodes).runPart(); });
}

SharedPose poseShared(const Scene& scene, const PoseTime& time, const Sharing& sharing, size_t mostTriangles) {
    return naming("cannot pose '" + scene.name + "'",
                  [&] { return Posing(scene, time, mostTriangles, Detail::triangles, &sharing).runShared(); });
}

}  // namespace cleave
