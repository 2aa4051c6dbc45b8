// Checks meshes: attributes, indices and morph targets are accessors of the right format, and of one count.
#include "scene/check_compression.h"
#include "scene/check_format.h"
#include "scene/gltf_check.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

// Returns the format that a semantic must have; null where geometry does not depend on it.
const Format* formatOf(const std::string& semantic) {
    if (semantic == "POSITION") return &kPositionFormat;
    if (semantic.starts_with("JOINTS_")) return &kJointsFormat;
    if (semantic.starts_with("WEIGHTS_")) return &kWeightsFormat;
    return nullptr;
}

// Checks accessors by semantic. All have as many elements as `first`, which is the first of them where it is null.
void checkAttributes(const Json& document, const Json& attributes, const Json*& first, const std::string& where) {
    for (const auto& [semantic, value] : attributes.items()) {
        const std::string name = where + "." + semantic;
        const Format* format = formatOf(semantic);
        checkIndexValue(value, targetOf(document, "accessors"), name);
        const Json& accessor = format != nullptr ? checkAccessorValue(document, value, *format, name)
                                                 : document["accessors"][value.get<size_t>()];
        if (first == nullptr) first = &accessor;
        if (countOf(accessor) != countOf(*first))
            refuseGltf(name + " has " + std::to_string(countOf(accessor)) + " elements, and the primitive has " +
                       std::to_string(countOf(*first)) + " vertices");
    }
}

void checkVariants(const Json& document, const Json& primitive, const std::string& where) {
    const Json* variants = extensionOf(primitive, "KHR_materials_variants", where);
    if (variants == nullptr) return;
    const std::string name = where + ".extensions.KHR_materials_variants";
    const Json& mappings = objectsOf(*variants, "mappings", name);
    for (size_t i = 0; i < mappings.size(); ++i)
        requireIndex(mappings[i], "material", targetOf(document, "materials"), at(name + ".mappings", i));
}

void checkPrimitive(const Json& document, const Json& primitive, const std::string& where) {
    checkIndex(primitive, "material", targetOf(document, "materials"), where);
    checkCount(primitive, "mode", false, 6, where);
    const Json* first = nullptr;
    checkAttributes(document, requiredObject(primitive, "attributes", where), first, where + ".attributes");
    if (const Json* indices = member(primitive, "indices"))
        checkAccessorValue(document, *indices, kIndexFormat, where + ".indices");
    const Json& targets = objectsOf(primitive, "targets", where);
    for (size_t i = 0; i < targets.size(); ++i) checkAttributes(document, targets[i], first, at(where + ".targets", i));
    checkDraco(document, primitive, where);
    checkVariants(document, primitive, where);
}

}  // namespace

void checkMeshes(const Json& document) {
    const Json& meshes = objectsOf(document, "meshes");
    for (size_t i = 0; i < meshes.size(); ++i) {
        const std::string where = at("meshes", i);
        const Json& primitives = objectsOf(meshes[i], "primitives", where);
        for (size_t p = 0; p < primitives.size(); ++p) {
            checkPrimitive(document, primitives[p], at(where + ".primitives", p));
            const size_t targets = arrayOf(primitives[p], "targets", where).size();
            const size_t expected = arrayOf(primitives[0], "targets", where).size();
            if (targets != expected)
                refuseGltf(at(where + ".primitives", p) + " has " + std::to_string(targets) +
                           " morph targets, and the mesh's first one has " + std::to_string(expected));
        }
        checkMorphWeights(document, meshes[i], i, where);
    }
}

size_t morphTargetsOf(const Json& document, size_t mesh) {
    const Json& primitives = arrayOf(document["meshes"][mesh], "primitives", "");
    return primitives.empty() ? 0 : arrayOf(primitives[0], "targets", "").size();
}

void checkMorphWeights(const Json& document, const Json& object, size_t mesh, const std::string& where) {
    const size_t given = arrayOf(object, "weights", where).size();
    if (!object.contains("weights")) return;
    checkNumbers(object, "weights", given, where);
    const size_t targets = morphTargetsOf(document, mesh);
    if (given != targets)
        refuseGltf(where + ".weights holds " + std::to_string(given) + " numbers, and its mesh has " +
                   std::to_string(targets) + " morph targets");
}

}  // namespace cleave
