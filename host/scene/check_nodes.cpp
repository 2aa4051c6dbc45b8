// Checks nodes, scenes, skins, cameras and lights; nodes form a forest.
#include <vector>

#include "scene/check_format.h"
#include "scene/gltf_check.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

// Returns the format that an attribute of instances must have; null for custom ones, which nothing reads.
const Format* instanceFormatOf(const std::string& semantic) {
    if (semantic == "TRANSLATION" || semantic == "SCALE") return &kVec3Format;
    return semantic == "ROTATION" ? &kRotationFormat : nullptr;
}

// All attributes of instances have one count (EXT_mesh_gpu_instancing), as many as there are instances.
void checkInstancing(const Json& document, const Json& node, const std::string& where) {
    const Json* instancing = extensionOf(node, "EXT_mesh_gpu_instancing", where);
    const std::string name = where + ".extensions.EXT_mesh_gpu_instancing";
    const Json* attributes = instancing == nullptr ? nullptr : objectAt(*instancing, "attributes", name);
    if (attributes == nullptr) return;
    const Json* first = nullptr;
    for (const auto& [semantic, value] : attributes->items()) {
        const std::string place = name + "." + semantic;
        const Format* format = instanceFormatOf(semantic);
        checkIndexValue(value, targetOf(document, "accessors"), place);
        const Json& accessor = format != nullptr ? checkAccessorValue(document, value, *format, place)
                                                 : document["accessors"][value.get<size_t>()];
        if (first == nullptr) first = &accessor;
        if (countOf(accessor) != countOf(*first))
            refuseGltf(place + " has " + std::to_string(countOf(accessor)) + " elements, and the node has " +
                       std::to_string(countOf(*first)) + " instances");
    }
}

size_t lightCountOf(const Json& document) {
    const Json* lights = extensionOf(document, "KHR_lights_punctual", "");
    return lights == nullptr ? 0 : arrayOf(*lights, "lights", "extensions.KHR_lights_punctual").size();
}

void checkNode(const Json& document, const Json& node, const std::string& where) {
    const bool hasMesh = checkIndex(node, "mesh", targetOf(document, "meshes"), where);
    checkIndex(node, "camera", targetOf(document, "cameras"), where);
    checkIndex(node, "skin", targetOf(document, "skins"), where);
    if (const Json* light = extensionOf(node, "KHR_lights_punctual", where))
        requireIndex(*light, "light", {"lights", lightCountOf(document)}, where + ".extensions.KHR_lights_punctual");
    checkInstancing(document, node, where);
    checkNumbers(node, "matrix", 16, where);
    checkNumbers(node, "translation", 3, where);
    checkNumbers(node, "rotation", 4, where);
    checkNumbers(node, "scale", 3, where);
    if (hasMesh)
        checkMorphWeights(document, node, node["mesh"].get<size_t>(), where);
    else if (node.contains("weights"))
        refuseGltf(where + " has weights, and no mesh");
}

// Returns the entries of an array of node indices.
std::vector<size_t> nodeList(const Json& document, const Json& object, const char* name, const std::string& where) {
    const Json& array = arrayOf(object, name, where);
    std::vector<size_t> list;
    for (size_t i = 0; i < array.size(); ++i) {
        checkIndexValue(array[i], targetOf(document, "nodes"), at(where + "." + name, i));
        list.push_back(array[i].get<size_t>());
    }
    return list;
}

// glTF 2.0, section 3.5.2: the nodes are a set of disjoint strict trees.
void checkForest(const Json& document, const Json& nodes) {
    std::vector<std::vector<size_t>> children(nodes.size());
    std::vector<bool> hasParent(nodes.size(), false);
    for (size_t i = 0; i < nodes.size(); ++i) {
        children[i] = nodeList(document, nodes[i], "children", at("nodes", i));
        for (size_t child : children[i]) {
            if (hasParent[child]) refuseGltf(at("nodes", child) + " is the child of two nodes");
            hasParent[child] = true;
        }
    }
    // With one parent each, what no root reaches lies on a cycle or below one.
    std::vector<size_t> reached;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (!hasParent[i]) reached.push_back(i);
    for (size_t i = 0; i < reached.size(); ++i)
        reached.insert(reached.end(), children[reached[i]].begin(), children[reached[i]].end());
    if (reached.size() != nodes.size()) refuseGltf("its nodes form a cycle: a node is its own ancestor");
}

std::vector<bool> childrenOf(const Json& nodes) {
    std::vector<bool> hasParent(nodes.size(), false);
    for (const Json& node : nodes)
        for (const Json& child : arrayOf(node, "children", "")) hasParent[child.get<size_t>()] = true;
    return hasParent;
}

}  // namespace

void checkNodes(const Json& document) {
    const Json& nodes = objectsOf(document, "nodes");
    for (size_t i = 0; i < nodes.size(); ++i) checkNode(document, nodes[i], at("nodes", i));
    checkForest(document, nodes);
}

void checkScenes(const Json& document) {
    const Json& nodes = objectsOf(document, "nodes");
    const std::vector<bool> isChild = childrenOf(nodes);
    const Json& scenes = objectsOf(document, "scenes");
    if (const Json* shown = member(document, "scene"))
        checkIndexValue(*shown, targetOf(document, "scenes"), "the default scene");
    for (size_t i = 0; i < scenes.size(); ++i) {
        const std::string where = at("scenes", i);
        std::vector<bool> listed(nodes.size(), false);
        for (size_t root : nodeList(document, scenes[i], "nodes", where)) {
            if (listed[root]) refuseGltf(where + " lists node " + std::to_string(root) + " twice");
            if (isChild[root]) refuseGltf(where + " lists node " + std::to_string(root) + ", which is not a root");
            listed[root] = true;
        }
    }
}

void checkSkins(const Json& document) {
    const Json& skins = objectsOf(document, "skins");
    for (size_t i = 0; i < skins.size(); ++i) {
        const std::string where = at("skins", i);
        const size_t joints = nodeList(document, skins[i], "joints", where).size();
        if (joints == 0) refuseGltf(where + " has no joints");
        checkIndex(skins[i], "skeleton", targetOf(document, "nodes"), where);
        const Json* matrices = member(skins[i], "inverseBindMatrices");
        if (matrices == nullptr) continue;
        const Json& accessor = checkAccessorValue(document, *matrices, kMatrixFormat, where + ".inverseBindMatrices");
        if (countOf(accessor) < joints)
            refuseGltf(where + ".inverseBindMatrices has " + std::to_string(countOf(accessor)) +
                       " matrices, and there are " + std::to_string(joints) + " joints");
    }
}

void checkCameras(const Json& document) {
    const Json& cameras = objectsOf(document, "cameras");
    for (size_t i = 0; i < cameras.size(); ++i) {
        const std::string where = at("cameras", i);
        const Json* type = member(cameras[i], "type");
        const bool orthographic = type != nullptr && *type == "orthographic";
        if (!orthographic && (type == nullptr || *type != "perspective"))
            refuseGltf(where + ".type is neither perspective nor orthographic");
        const char* kind = orthographic ? "orthographic" : "perspective";
        const Json& shape = requiredObject(cameras[i], kind, where);
        const std::string name = where + "." + kind;
        checkNumber(shape, "yfov", !orthographic, name);
        checkNumber(shape, "xmag", orthographic, name);
        checkNumber(shape, "ymag", orthographic, name);
        for (const char* field : {"znear", "zfar", "aspectRatio"}) checkNumber(shape, field, false, name);
    }
}

void checkLights(const Json& document) {
    const Json* extension = extensionOf(document, "KHR_lights_punctual", "");
    if (extension == nullptr) return;
    const std::string all = "extensions.KHR_lights_punctual";
    const Json& lights = objectsOf(*extension, "lights", all);
    for (size_t i = 0; i < lights.size(); ++i) {
        const std::string where = at(all + ".lights", i);
        const Json* type = member(lights[i], "type");
        if (type == nullptr || (*type != "directional" && *type != "point" && *type != "spot"))
            refuseGltf(where + ".type is neither directional nor point nor spot");
        checkNumbers(lights[i], "color", 3, where);
        for (const char* field : {"intensity", "range"}) checkNumber(lights[i], field, false, where);
        if (const Json* spot = objectAt(lights[i], "spot", where))
            for (const char* field : {"innerConeAngle", "outerConeAngle"})
                checkNumber(*spot, field, false, where + ".spot");
    }
}

}  // namespace cleave
