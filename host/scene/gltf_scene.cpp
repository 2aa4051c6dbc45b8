// loadGltf: file -> document -> model -> placed nodes -> triangles, cameras, materials.
#include <algorithm>
#include <new>

#include "base/error.h"
#include "scene/gltf_camera.h"
#include "scene/gltf_file.h"
#include "scene/gltf_model.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_primitive.h"
#include "scene/scene.h"

namespace cleave {
namespace {

Material materialOf(const tinygltf::Material& source) {
    Material material;
    material.name = source.name;
    const std::vector<double>& factor = source.pbrMetallicRoughness.baseColorFactor;
    for (int i = 0; i < 4 && factor.size() == 4; ++i)
        material.baseColour[i] = float(std::clamp(factor[size_t(i)], 0.0, 1.0));
    return material;
}

void addMaterials(const tinygltf::Model& model, Scene& scene) {
    for (const tinygltf::Material& material : model.materials) scene.materials.push_back(materialOf(material));
    scene.materials.push_back({"default", glm::vec4(1.0f)});
}

void warnOfPose(const tinygltf::Node& node, const tinygltf::Mesh& mesh, const std::string& where, Scene& scene) {
    const bool morphs = std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                                    [](const tinygltf::Primitive& p) { return !p.targets.empty(); });
    if (morphs) scene.warnings.push_back(where + " has morph targets: it is shown without them");
    if (node.skin >= 0)
        scene.warnings.push_back(where + " is skinned: it is shown in its bind pose, placed by its node");
    if (node.extensions.find("EXT_mesh_gpu_instancing") != node.extensions.end())
        scene.warnings.push_back(where + " has EXT_mesh_gpu_instancing: it is shown once");
}

// Warnings repeat a node's name for each of its primitives, and a name may be as long as the file.
constexpr size_t kLongestName = 100;

void addNode(const tinygltf::Model& model, const PlacedNode& placed, size_t mostTriangles, Scene& scene) {
    const tinygltf::Node& node = model.nodes[size_t(placed.node)];
    const std::string name = "node " + std::to_string(placed.node) +
                             (node.name.empty() ? "" : " '" + node.name.substr(0, kLongestName) + "'");
    if (node.camera >= 0) {
        const auto camera = placeCamera(model.cameras[size_t(node.camera)], node.name, placed.toWorld);
        if (camera)
            scene.cameras.push_back(*camera);
        else
            scene.warnings.push_back(name + " has a camera that shows no picture; it is ignored");
    }
    if (node.mesh < 0) return;
    const tinygltf::Mesh& mesh = model.meshes[size_t(node.mesh)];
    warnOfPose(node, mesh, name, scene);
    for (size_t p = 0; p < mesh.primitives.size(); ++p)
        addPrimitive(model, mesh.primitives[p], placed.toWorld, name + ", primitive " + std::to_string(p),
                     mostTriangles, scene);
}

void warnOfNonFinite(Scene& scene) {
    auto isGood = [](const Triangle& t) { return isFinite3(t.a) && isFinite3(t.b) && isFinite3(t.c); };
    const auto bad =
        scene.triangles.size() - size_t(std::count_if(scene.triangles.begin(), scene.triangles.end(), isGood));
    if (bad == 0) return;
    const auto first = std::find_if_not(scene.triangles.begin(), scene.triangles.end(), isGood);
    scene.warnings.push_back(std::to_string(bad) + " triangles have a vertex that is not finite, the first is number " +
                             std::to_string(first - scene.triangles.begin()));
}

// Not one for each of a thousand instances: gives how many it takes away.
size_t trimWarnings(std::vector<std::string>& warnings) {
    constexpr size_t kMost = 20;
    const size_t surplus = warnings.size() - std::min(warnings.size(), kMost);
    warnings.resize(warnings.size() - surplus);
    return surplus;
}

// What the nodes show. Warnings are trimmed after each node: all of them could be far larger than the file.
void addNodes(const tinygltf::Model& model, size_t mostTriangles, Scene& scene) {
    size_t trimmed = trimWarnings(scene.warnings);
    for (const PlacedNode& placed : placeNodes(model)) {
        addNode(model, placed, mostTriangles, scene);
        trimmed += trimWarnings(scene.warnings);
    }
    for (std::string& warning : scene.warnings) warning = oneLine(warning);
    if (trimmed > 0) scene.warnings.push_back("and " + std::to_string(trimmed) + " more warnings like these");
}

Scene sceneOf(GltfFile file, size_t mostTriangles) {
    Scene scene;
    scene.name = file.path.string();
    const tinygltf::Model model = loadModel(std::move(file), scene.warnings);
    addMaterials(model, scene);
    addNodes(model, mostTriangles, scene);
    warnOfNonFinite(scene);
    return scene;
}

// Every failure of `load` becomes an Error of one line that names the file.
template <typename Load>
Scene naming(const std::filesystem::path& file, const Load& load) {
    const std::string failed = "cannot load '" + file.string() + "': ";
    try {
        return load();
    } catch (const std::bad_alloc&) {
        throw Error(oneLine(failed + "there is not enough memory; load a smaller scene"));
    } catch (const std::exception& e) {
        throw Error(oneLine(failed + e.what()));
    }
}

}  // namespace

Scene loadGltf(const std::filesystem::path& file) {
    return naming(file, [&] {
        GltfFile parsed = parseGltfFile(file, readBytes(file));  // and the bytes are let go
        return sceneOf(std::move(parsed), kMostTriangles);
    });
}

Scene loadGltf(const std::filesystem::path& file, std::span<const unsigned char> bytes, size_t mostTriangles) {
    return naming(file, [&] { return sceneOf(parseGltfFile(file, bytes), mostTriangles); });
}

}  // namespace cleave
