#include "scene/pose.h"

#include <algorithm>

#include "scene/animation.h"
#include "scene/instances.h"
#include "scene/node_transforms.h"
#include "scene/place_camera.h"
#include "scene/pose_primitive.h"
#include "scene/skin_matrices.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

constexpr size_t kTermsPerTriangle = 64;

// Warnings repeat a node's name for each of its primitives, and a name may be as long as the file.
constexpr size_t kLongestName = 100;

std::string nameOf(const Scene& scene, uint32_t node) {
    const std::string& name = scene.nodes[node].name;
    return "node " + std::to_string(node) + (name.empty() ? "" : " '" + name.substr(0, kLongestName) + "'");
}

// The scene while it is posed.
class Posing {
  public:
    Posing(const Scene& scene, const PoseTime& time, size_t mostTriangles, Detail detail)
        : scene_(scene),
          detail_(detail),
          budget_{mostTriangles, kTermsPerTriangle * mostTriangles},
          states_(restStates(scene)) {
        posed_.name = scene.name;
        animate(scene, time, states_, warnings_);
        std::vector<glm::dmat4> local;
        for (const NodeState& state : states_) local.push_back(matrixOf(state.transform));
        toWorld_ = worldTransforms(scene, local);
        const size_t count = countTriangles(scene, mostTriangles);
        posed_.triangles.reserve(count);
        posed_.materialOf.reserve(count);
    }

    PosedScene run() {
        for (uint32_t node : shownNodes(scene_)) addNode(node);
        completeCorners(posed_);
        warnOfNonFinite();
        posed_.warnings = warnings_.list();
        return std::move(posed_);
    }

  private:
    void addNode(uint32_t index) {
        const gltf::Node& node = scene_.nodes[index];
        if (node.camera) addCamera(index);
        if (node.light) addLight(index);
        if (node.mesh) {
            const size_t before = posed_.triangles.size();
            addMesh(index);
            posed_.meshes.push_back({index, posed_.triangles.size() - before});
        }
    }

    void addCamera(uint32_t index) {
        const gltf::Node& node = scene_.nodes[index];
        if (const auto camera = placeCamera(scene_.cameras[*node.camera], node.name, toWorld_[index]))
            posed_.cameras.push_back(*camera);
        else
            warnings_.add(nameOf(scene_, index) + " has a camera that shows no picture; it is ignored");
    }

    void addLight(uint32_t index) {
        if (const auto light = placeLight(scene_, *scene_.nodes[index].light, toWorld_[index]))
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
        const Deformation deformation{&states_[index].weights, hasSkin ? &skins_.of(*node.skin) : nullptr};
        const InstanceTransforms instances(scene_, node);
        MeshPosing posing{scene_, deformation, instances.count(), detail_, budget_, posed_.leftOut, warnings_};
        std::vector<PosablePrimitive> primitives;  // where there are instances, which need all of them one by one
        const std::vector<gltf::Primitive>& all = scene_.meshes[*node.mesh].primitives;
        for (size_t p = 0; p < all.size(); ++p) {
            auto primitive = posing.prepare(all[p], name + ", primitive " + std::to_string(p));
            if (primitive && hasInstances(scene_, node))
                primitives.push_back(std::move(*primitive));
            else if (primitive)
                primitive->appendTo(posed_, toWorld_[index]);
        }
        for (size_t i = 0; i < instances.count() && !primitives.empty(); ++i) {
            const glm::dmat4 toWorld = toWorld_[index] * instances[i];
            for (const PosablePrimitive& primitive : primitives) primitive.appendTo(posed_, toWorld);
        }
    }

    bool isPlacedBySkin(uint32_t skin, const std::string& name) {
        if (hasMatrices(scene_, skin)) return true;
        warnings_.add(name +
                      " is skinned, and the matrices of its skin are in a buffer that has no URI: it is placed "
                      "by its node");
        return false;
    }

    void warnOfNonFinite() {
        auto isBad = [](const Triangle& t) { return !isFinite3(t.a) || !isFinite3(t.b) || !isFinite3(t.c); };
        const std::vector<Triangle>& all = posed_.triangles;
        const auto bad = std::count_if(all.begin(), all.end(), isBad);
        if (bad == 0) return;
        const auto first = std::find_if(all.begin(), all.end(), isBad);
        warnings_.add(std::to_string(bad) + " triangles have a vertex that is not finite, the first is number " +
                      std::to_string(first - all.begin()));
    }

    const Scene& scene_;
    Detail detail_;
    Budget budget_;
    Warnings warnings_;
    std::vector<NodeState> states_;
    std::vector<glm::dmat4> toWorld_;
    SkinMatrices skins_{scene_, toWorld_};
    PosedScene posed_;
};

}  // namespace

PosedScene pose(const Scene& scene, const PoseTime& time, size_t mostTriangles, Detail detail) {
    return naming("cannot pose '" + scene.name + "'", [&] { return Posing(scene, time, mostTriangles, detail).run(); });
}

}  // namespace cleave
