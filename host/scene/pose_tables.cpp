#include "scene/pose_tables.h"

#include <algorithm>
#include <map>

#include "scene/instances.h"
#include "scene/node_transforms.h"
#include "scene/posed_nodes.h"
#include "scene/posed_vertices.h"
#include "scene/skin_matrices.h"
#include "scene/triangle_count.h"
#include "shared/triangle.h"

namespace cleave {
namespace {

// A node that moves and shows a mesh: where what it has begins in the tables of a time.
struct MovingMesh {
    uint32_t node = 0;
    size_t instances = 1;
    size_t joints = 0;   // of its skin
    size_t weights = 0;  // as many as any of its primitives has targets
    size_t firstMap = 0;
    size_t firstJoint = 0;
    size_t firstWeight = 0;
};

size_t jointsOf(const Scene& scene, const gltf::Node& node) {
    return node.skin && hasMatrices(scene, *node.skin) ? scene.skins[*node.skin].joints.size() : 0;
}

std::vector<MovingMesh> movingMeshes(const Scene& scene, const std::vector<bool>& movingNodes) {
    std::vector<MovingMesh> meshes;
    size_t maps = 0, weights = 0;
    for (const uint32_t index : shownNodes(scene)) {
        const gltf::Node& node = scene.nodes[index];
        if (!node.mesh || !movingNodes[index]) continue;
        MovingMesh mesh{index, instanceCount(scene, node), jointsOf(scene, node)};
        for (const gltf::Primitive& primitive : scene.meshes[*node.mesh].primitives)
            mesh.weights = std::max(mesh.weights, primitive.targets.size());
        mesh.firstMap = maps;
        mesh.firstJoint = maps + mesh.instances;
        mesh.firstWeight = weights;
        maps = mesh.firstJoint + mesh.joints;
        weights += mesh.weights;
        meshes.push_back(mesh);
    }
    return meshes;
}

AffineMap affineMap(const glm::dmat4& m) {
    return {glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[2]), glm::dvec3(m[3])};
}

// A primitive as it is in all places and at all times.
struct MadePrimitive {
    PosePart part{};
    std::vector<uint32_t> corners;  // of its triangles, counted from its first vertex
    size_t vertices = 0;
    uint32_t largestJoint = 0;
};

class Making {
  public:
    Making(const Scene& scene, uint64_t mostBytes) : scene_(scene), left_(mostBytes) {}

    // False if the tables would be too large, or cannot be trusted to do what pose() does.
    bool add(const MovingMesh& mesh, size_t firstTriangle, size_t triangles) {
        const gltf::Node& node = scene_.nodes[mesh.node];
        std::vector<const MadePrimitive*> primitives;
        for (const gltf::Primitive& primitive : scene_.meshes[*node.mesh].primitives) {
            if (!isReadable(scene_, primitive)) continue;
            const size_t count = triangleCount(primitive.mode, indexCountOf(scene_, primitive));
            if (count == 0) continue;
            if (count > triangles) return false;
            const auto [known, isNew] = known_.try_emplace({&primitive, mesh.joints > 0});
            if (isNew) known->second = made(primitive, count, mesh.joints > 0);
            const std::optional<MadePrimitive>& one = known->second;
            if (!one || (one->part.influenceCount > 0 && one->largestJoint >= mesh.joints)) return false;
            primitives.push_back(&*one);
        }
        return place(primitives, mesh, firstTriangle, triangles);
    }

    PoseTables take() { return std::move(tables_); }

  private:
    std::optional<MadePrimitive> made(const gltf::Primitive& primitive, size_t count, bool isSkinned) {
        const std::vector<JointAccessors> sets = isSkinned ? jointSets(primitive) : std::vector<JointAccessors>();
        if (!areThere(primitive, sets) || !spend(3 * count * sizeof(uint32_t))) return std::nullopt;
        MadePrimitive made;
        PosePart& part = made.part;
        part.firstVertex = uint32_t(tables_.positions.size());
        part.firstMorph = uint32_t(tables_.morphs.size());
        part.firstInfluence = uint32_t(tables_.influences.size());
        part.influenceCount = uint32_t(4 * sets.size());
        made.corners = cornersOfAll(primitive, count);
        const std::vector<uint32_t> vertices = compacted(made.corners);
        const size_t points = (1 + primitive.targets.size()) * sizeof(glm::dvec3);
        if (!spend(vertices.size() * (points + part.influenceCount * sizeof(PoseInfluence)))) return std::nullopt;
        addPoints(tables_.positions, primitive.attributes.at("POSITION"), vertices);
        for (size_t i = 0; i < primitive.targets.size(); ++i) {
            const gltf::Index deltas = attributeOf(primitive.targets[i], "POSITION");
            if (!deltas) continue;
            tables_.morphs.push_back({uint32_t(i), uint32_t(tables_.deltas.size())});
            addPoints(tables_.deltas, *deltas, vertices);
        }
        part.morphCount = uint32_t(tables_.morphs.size()) - part.firstMorph;
        made.largestJoint = addInfluences(sets, vertices);
        made.vertices = vertices.size();
        return made;
    }

    bool areThere(const gltf::Primitive& primitive, const std::vector<JointAccessors>& sets) const {
        for (const gltf::Attributes& target : primitive.targets) {
            const gltf::Index deltas = attributeOf(target, "POSITION");
            if (deltas && !hasBytes(scene_, *deltas)) return false;
        }
        return std::ranges::all_of(sets, [&](const JointAccessors& set) {
            return hasBytes(scene_, set.joints) && hasBytes(scene_, set.weights);
        });
    }

    bool spend(uint64_t bytes) {
        if (bytes > left_) return false;
        left_ -= bytes;
        return true;
    }

    std::vector<uint32_t> cornersOfAll(const gltf::Primitive& primitive, size_t count) const {
        const size_t vertices = scene_.accessors[primitive.attributes.at("POSITION")].count;
        const VertexIndices indices(scene_, primitive.indices, vertices);
        std::vector<uint32_t> corners;
        corners.reserve(3 * count);
        for (size_t i = 0; i < count; ++i)
            for (const size_t corner : cornersOf(primitive.mode, i)) corners.push_back(uint32_t(indices[corner]));
        return corners;
    }

    // Lists the vertices that corners use, which a file may have any number of beside; corners count in this list then.
    static std::vector<uint32_t> compacted(std::vector<uint32_t>& corners) {
        std::vector<uint32_t> vertices = corners;
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        for (uint32_t& corner : corners)
            corner = uint32_t(std::ranges::lower_bound(vertices, corner) - vertices.begin());
        return vertices;
    }

    void addPoints(std::vector<glm::dvec3>& to, uint32_t accessor, const std::vector<uint32_t>& vertices) const {
        const AccessorValues values(scene_, accessor);
        for (const uint32_t vertex : vertices) to.push_back(values.vec3(vertex));
    }

    // Returns the largest number of a joint.
    uint32_t addInfluences(const std::vector<JointAccessors>& sets, const std::vector<uint32_t>& vertices) {
        struct Set {
            AccessorIntegers joints;
            AccessorValues weights;
        };
        std::vector<Set> views;
        for (const JointAccessors& set : sets)
            views.push_back({AccessorIntegers(scene_, set.joints), AccessorValues(scene_, set.weights)});
        uint32_t largest = 0;
        for (const uint32_t vertex : vertices)
            for (const Set& set : views) {
                const glm::uvec4 joint = set.joints[vertex];
                const glm::dvec4 weight = set.weights.vec4(vertex);
                for (int i = 0; i < 4; ++i) {
                    tables_.influences.push_back({weight[i], joint[i], 0});
                    largest = std::max(largest, joint[i]);
                }
            }
        return largest;
    }

    bool place(const std::vector<const MadePrimitive*>& primitives, const MovingMesh& mesh, size_t first,
               size_t triangles) {
        const size_t end = first + triangles;
        for (size_t instance = 0; instance < mesh.instances; ++instance)
            for (const MadePrimitive* made : primitives) {
                const size_t count = made->corners.size() / 3;
                if (count > end - first) return false;
                if (!spend(sizeof(PosePart) + made->vertices * sizeof(vec3) + 4 * count * sizeof(uint32_t)))
                    return false;
                PosePart part = made->part;
                part.firstPosed = tables_.vertices;
                part.firstWeight = uint32_t(mesh.firstWeight);
                part.firstJoint = uint32_t(mesh.firstJoint);
                part.map = uint32_t(mesh.firstMap + instance);
                tables_.parts.push_back(part);
                for (const uint32_t corner : made->corners) tables_.corners.push_back(part.firstPosed + corner);
                for (size_t i = 0; i < count; ++i) tables_.numbers.push_back(uint32_t(first++));
                tables_.vertices += uint32_t(made->vertices);
            }
        return first == end;
    }

    const Scene& scene_;
    uint64_t left_;
    PoseTables tables_;
    std::map<std::pair<const gltf::Primitive*, bool>, std::optional<MadePrimitive>> known_;  // with a skin and without
};

std::optional<PoseTables> makeTables(const Scene& scene, const PosedScene& posed, const std::vector<bool>& movingNodes,
                                     uint64_t mostBytes) {
    Making making(scene, mostBytes);
    const std::vector<MovingMesh> meshes = movingMeshes(scene, movingNodes);
    auto next = meshes.begin();
    size_t first = 0;
    for (const ShownMesh& shown : posed.meshes) {
        if (movingNodes[shown.node]) {
            if (next == meshes.end() || next->node != shown.node) return std::nullopt;
            if (!making.add(*next++, first, shown.triangles)) return std::nullopt;
        }
        first += shown.triangles;
    }
    PoseTables tables = making.take();
    if (tables.parts.empty()) return std::nullopt;
    return tables;
}

PoseMotion motionOf(const Scene& scene, const PosedNodes& nodes, const std::vector<bool>& movingNodes) {
    SkinMatrices skins(scene, nodes.toWorld);
    PoseMotion motion;
    for (const MovingMesh& mesh : movingMeshes(scene, movingNodes)) {
        const gltf::Node& node = scene.nodes[mesh.node];
        const InstanceTransforms instances(scene, node);
        const glm::dmat4& toWorld = nodes.toWorld[mesh.node];
        for (size_t i = 0; i < mesh.instances; ++i)
            motion.maps.push_back(affineMap(hasInstances(scene, node) ? toWorld * instances[i] : toWorld));
        if (mesh.joints > 0)
            for (const glm::dmat4& joint : skins.of(*node.skin)) motion.maps.push_back(affineMap(joint));
        const std::vector<double>& weights = nodes.states[mesh.node].weights;
        for (size_t i = 0; i < mesh.weights; ++i) motion.weights.push_back(i < weights.size() ? weights[i] : 0.0);
    }
    return motion;
}

}  // namespace

std::optional<PoseTables> poseTables(const Scene& scene, const PosedScene& posed, const std::vector<bool>& movingNodes,
                                     uint64_t mostBytes) {
    return naming("cannot pose '" + scene.name + "'", [&] { return makeTables(scene, posed, movingNodes, mostBytes); });
}

PoseMotion poseMotion(const Scene& scene, const PoseTime& time, const std::vector<bool>& movingNodes) {
    return naming("cannot pose '" + scene.name + "'", [&] {
        Warnings ignored;  // pose() gives the same
        return motionOf(scene, poseNodes(scene, time, ignored), movingNodes);
    });
}

}  // namespace cleave
