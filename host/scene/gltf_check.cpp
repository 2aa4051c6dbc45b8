#include "scene/gltf_check.h"

#include <array>
#include <cstdint>
#include <limits>

#include "scene/gltf_file.h"

namespace cleave {
namespace {

using Json = nlohmann::json;

constexpr uint64_t kMaxCount = uint64_t(1) << 48;  // sums and products with strides stay within 64 bits
constexpr uint64_t kMaxSparse = uint64_t(std::numeric_limits<int>::max());  // tinygltf keeps these in an int

struct Place {  // for messages: "accessors[3]"
    const char* array;
    size_t index;
    operator std::string() const { return std::string(array) + "[" + std::to_string(index) + "]"; }
};

const Json* member(const Json& object, const char* name) {
    const auto it = object.find(name);
    return it == object.end() ? nullptr : &*it;
}

void checkIndexValue(const Json& value, size_t limit, const std::string& where) {
    if (!value.is_number_unsigned() || value.get<uint64_t>() >= limit)
        refuseGltf(where + " is " + value.dump() + ", and must be an index below " + std::to_string(limit));
}

void checkIndex(const Json& object, const char* name, size_t limit, const std::string& where) {
    if (const Json* value = member(object, name)) checkIndexValue(*value, limit, where + "." + name);
}

void checkCount(const Json& object, const char* name, bool required, uint64_t limit, const std::string& where) {
    const Json* value = member(object, name);
    if (value == nullptr && !required) return;
    if (value == nullptr) refuseGltf(where + " has no " + name);
    if (!value->is_number_unsigned() || value->get<uint64_t>() > limit)
        refuseGltf(where + "." + name + " is " + value->dump() + ", and must be a whole number, not negative or huge");
}

void checkNumbers(const Json& object, const char* name, size_t size, const std::string& where) {
    const Json* value = member(object, name);
    if (value == nullptr) return;
    bool good = value->is_array() && value->size() == size;
    for (size_t i = 0; good && i < size; ++i) good = (*value)[i].is_number();
    if (!good) refuseGltf(where + "." + name + " must hold " + std::to_string(size) + " numbers");
}

const Json& objectMember(const Json& object, const char* name, const std::string& where) {
    const Json* value = member(object, name);
    if (value == nullptr || !value->is_object()) refuseGltf(where + " has no object '" + name + "'");
    return *value;
}

void checkVersion(const Json& document) {
    const Json& asset = objectMember(document, "asset", "the file");
    const Json* version = member(asset, "version");
    if (version == nullptr || !version->is_string() || !version->get<std::string>().starts_with("2."))
        refuseGltf("asset.version is " + (version == nullptr ? "missing" : version->dump()) + ", and must be 2.x",
                   "convert it to glTF 2.0");
    const Json* least = member(asset, "minVersion");
    if (least != nullptr && *least != "2.0")
        refuseGltf("asset.minVersion is " + least->dump() + ", and 2.0 is what is understood",
                   "convert it to glTF 2.0");
}

// Quantisation is implemented; the others change how surfaces look, and not where they are.
bool isKnownExtension(const std::string& name) {
    constexpr std::array kKnown = {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
                                   "EXT_texture_webp",      "EXT_texture_avif",      "KHR_lights_punctual",
                                   "KHR_xmp_json_ld"};
    for (const char* known : kKnown)
        if (name == known) return true;
    return name.starts_with("KHR_materials_");
}

void checkExtensions(const Json& document) {
    const Json* required = member(document, "extensionsRequired");
    if (required == nullptr) return;
    if (!required->is_array()) refuseGltf("extensionsRequired is not an array");
    for (const Json& name : *required) {
        if (!name.is_string()) refuseGltf("extensionsRequired holds " + name.dump() + ", which is no name");
        if (!isKnownExtension(name.get<std::string>()))
            refuseGltf("it requires the extension " + name.get<std::string>() + ", which is not supported",
                       "export it without that extension");
    }
}

void checkReferences(const Json& document) {
    struct Reference {
        const char* array;
        const char* field;
        const char* target;
    };
    constexpr std::array kReferences = {
        Reference{"bufferViews", "buffer", "buffers"}, Reference{"accessors", "bufferView", "bufferViews"},
        Reference{"nodes", "mesh", "meshes"},          Reference{"nodes", "camera", "cameras"},
        Reference{"nodes", "skin", "skins"},
    };
    for (const Reference& reference : kReferences) {
        const Json& objects = objectsOf(document, reference.array);
        const size_t limit = objectsOf(document, reference.target).size();
        for (size_t i = 0; i < objects.size(); ++i)
            checkIndex(objects[i], reference.field, limit, Place{reference.array, i});
    }
}

void checkBuffers(const Json& document) {
    const Json& buffers = objectsOf(document, "buffers");
    for (size_t i = 0; i < buffers.size(); ++i) {
        const Place where{"buffers", i};
        checkCount(buffers[i], "byteLength", true, kMaxCount, where);
        const Json* uri = member(buffers[i], "uri");
        if (uri != nullptr && !uri->is_string()) refuseGltf(std::string(where) + ".uri is not a string");
    }
    const Json& views = objectsOf(document, "bufferViews");
    for (size_t i = 0; i < views.size(); ++i) {
        const Place where{"bufferViews", i};
        if (member(views[i], "buffer") == nullptr) refuseGltf(std::string(where) + " has no buffer");
        checkCount(views[i], "byteOffset", false, kMaxCount, where);
        checkCount(views[i], "byteLength", true, kMaxCount, where);
        checkCount(views[i], "byteStride", false, kMaxCount, where);
    }
}

void checkSparse(const Json& sparse, size_t views, const std::string& where) {
    if (!sparse.is_object()) refuseGltf(where + " is not an object");
    checkCount(sparse, "count", true, kMaxSparse, where);
    for (const char* part : {"indices", "values"}) {
        const Json& object = objectMember(sparse, part, where);
        const std::string name = where + "." + part;
        if (member(object, "bufferView") == nullptr) refuseGltf(name + " has no bufferView");
        checkIndex(object, "bufferView", views, name);
        checkCount(object, "byteOffset", false, kMaxSparse, name);
    }
    checkCount(sparse["indices"], "componentType", true, kMaxSparse, where + ".indices");
}

void checkAccessors(const Json& document) {
    const Json& accessors = objectsOf(document, "accessors");
    const size_t views = objectsOf(document, "bufferViews").size();
    for (size_t i = 0; i < accessors.size(); ++i) {
        const Place where{"accessors", i};
        checkCount(accessors[i], "count", true, kMaxCount, where);
        checkCount(accessors[i], "byteOffset", false, kMaxCount, where);
        checkCount(accessors[i], "componentType", true, kMaxSparse, where);
        const Json* normalized = member(accessors[i], "normalized");
        if (normalized != nullptr && !normalized->is_boolean())
            refuseGltf(std::string(where) + ".normalized is neither true nor false");
        if (const Json* sparse = member(accessors[i], "sparse"))
            checkSparse(*sparse, views, std::string(where) + ".sparse");
    }
}

void checkMeshes(const Json& document) {
    const Json& meshes = objectsOf(document, "meshes");
    const size_t accessors = objectsOf(document, "accessors").size();
    const size_t materials = objectsOf(document, "materials").size();
    for (size_t i = 0; i < meshes.size(); ++i) {
        const Json& primitives = objectsOf(meshes[i], "primitives");
        for (size_t p = 0; p < primitives.size(); ++p) {
            const std::string where = std::string(Place{"meshes", i}) + "." + std::string(Place{"primitives", p});
            checkIndex(primitives[p], "indices", accessors, where);
            checkIndex(primitives[p], "material", materials, where);
            checkCount(primitives[p], "mode", false, 6, where);
            for (const auto& attribute : objectMember(primitives[p], "attributes", where).items())
                checkIndexValue(attribute.value(), accessors, where + "." + attribute.key());
        }
    }
}

void checkTransforms(const Json& nodes) {
    for (size_t i = 0; i < nodes.size(); ++i) {
        checkNumbers(nodes[i], "matrix", 16, Place{"nodes", i});
        checkNumbers(nodes[i], "translation", 3, Place{"nodes", i});
        checkNumbers(nodes[i], "rotation", 4, Place{"nodes", i});
        checkNumbers(nodes[i], "scale", 3, Place{"nodes", i});
    }
}

// The entries of an array of node indices.
std::vector<size_t> nodeList(const Json& object, const char* name, size_t nodeCount, const std::string& where) {
    std::vector<size_t> list;
    const Json* value = member(object, name);
    if (value == nullptr) return list;
    if (!value->is_array()) refuseGltf(where + "." + name + " is not an array");
    for (const Json& entry : *value) {
        checkIndexValue(entry, nodeCount, where + "." + name);
        list.push_back(entry.get<size_t>());
    }
    return list;
}

// glTF 2.0, section 3.5.2: the nodes are a set of disjoint strict trees.
std::vector<bool> checkForest(const Json& nodes) {
    std::vector<std::vector<size_t>> children(nodes.size());
    std::vector<bool> hasParent(nodes.size(), false);
    for (size_t i = 0; i < nodes.size(); ++i) {
        children[i] = nodeList(nodes[i], "children", nodes.size(), Place{"nodes", i});
        for (size_t child : children[i]) {
            if (hasParent[child]) refuseGltf(std::string(Place{"nodes", child}) + " is the child of two nodes");
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
    return hasParent;
}

void checkScenes(const Json& document, const std::vector<bool>& hasParent) {
    const Json& scenes = objectsOf(document, "scenes");
    checkIndex(document, "scene", scenes.size(), "the default scene");
    for (size_t i = 0; i < scenes.size(); ++i) {
        const Place where{"scenes", i};
        std::vector<bool> listed(hasParent.size(), false);
        for (size_t root : nodeList(scenes[i], "nodes", hasParent.size(), where)) {
            if (listed[root]) refuseGltf(std::string(where) + " lists node " + std::to_string(root) + " twice");
            if (hasParent[root])
                refuseGltf(std::string(where) + " lists node " + std::to_string(root) + ", which is not a root");
            listed[root] = true;
        }
    }
}

}  // namespace

const Json& objectsOf(const Json& object, const char* name) {
    static const Json kNone = Json::array();
    const Json* value = member(object, name);
    if (value == nullptr) return kNone;
    if (!value->is_array()) refuseGltf(std::string(name) + " is not an array");
    for (const Json& entry : *value)
        if (!entry.is_object()) refuseGltf(std::string(name) + " holds something that is no object");
    return *value;
}

void checkGltf(const Json& document) {
    checkVersion(document);
    checkExtensions(document);
    checkReferences(document);
    checkBuffers(document);
    checkAccessors(document);
    checkMeshes(document);
    const Json& nodes = objectsOf(document, "nodes");
    checkTransforms(nodes);
    checkScenes(document, checkForest(nodes));
}

}  // namespace cleave
