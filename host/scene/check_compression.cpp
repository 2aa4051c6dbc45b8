#include "scene/check_compression.h"

#include <array>
#include <limits>

#include "scene/check_format.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::MeshoptFilter;
using gltf::MeshoptMode;

constexpr std::array kMeshoptNames = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

bool isFallback(const Json& buffer) {
    const char* name = meshoptNameOf(buffer);
    const Json* fallback = name == nullptr ? nullptr : member(buffer["extensions"][name], "fallback");
    return fallback != nullptr && *fallback == true;
}

std::string named(const Json& value) { return value.dump() + ", which is not supported"; }

// Checks where the compressed bytes are.
void checkMeshoptBytes(const Json& document, const Json& meshopt, const std::string& where) {
    requireIndex(meshopt, "buffer", targetOf(document, "buffers"), where);
    checkCount(meshopt, "byteOffset", false, kMaxCount, where);
    checkCount(meshopt, "byteLength", true, kMaxCount, where);
    const size_t index = meshopt["buffer"].get<size_t>();
    const Json& buffer = document["buffers"][index];
    const uint64_t end = wholeOf(meshopt, "byteOffset") + wholeOf(meshopt, "byteLength");
    if (end > wholeOf(buffer, "byteLength"))
        refuseGltf(where + " ends at byte " + std::to_string(end) + ", past the end of " + at("buffers", index) +
                   ", which has " + std::to_string(wholeOf(buffer, "byteLength")));
    if (isFallback(buffer))
        refuseGltf(where + ".buffer is " + std::to_string(index) + ", which is a fallback for uncompressed data");
}

bool isStrideOf(MeshoptMode mode, MeshoptFilter filter, uint64_t stride) {
    if (mode != MeshoptMode::attributes) return stride == 2 || stride == 4;
    if (filter == MeshoptFilter::octahedral) return stride == 4 || stride == 8;
    if (filter == MeshoptFilter::quaternion) return stride == 8;
    return stride > 0 && stride <= 256 && stride % 4 == 0;
}

// Checks what they become, which fills the bufferView.
void checkMeshoptElements(const Json& view, const Json& meshopt, MeshoptMode mode, MeshoptFilter filter,
                          const std::string& where) {
    checkCount(meshopt, "byteStride", true, 256, where);
    checkCount(meshopt, "count", true, kMaxCount, where);
    const uint64_t stride = wholeOf(meshopt, "byteStride");
    const uint64_t count = wholeOf(meshopt, "count");
    if (!isStrideOf(mode, filter, stride))
        refuseGltf(where + ".byteStride is " + std::to_string(stride) + ", which its mode and filter do not allow");
    if (view.contains("byteStride") && wholeOf(view, "byteStride") != stride)
        refuseGltf(where + ".byteStride is " + std::to_string(stride) + ", and that of its bufferView is " +
                   std::to_string(wholeOf(view, "byteStride")));
    if (mode == MeshoptMode::triangles && count % 3 != 0)
        refuseGltf(where + ".count is " + std::to_string(count) + ", and must be a multiple of 3");
    if (stride * count != wholeOf(view, "byteLength"))
        refuseGltf(where + " makes " + std::to_string(stride * count) + " bytes, and its bufferView has " +
                   std::to_string(wholeOf(view, "byteLength")));
}

// What Draco decompresses takes the place of an accessor's data.
void checkDracoAccessor(const Json& accessor, const std::string& where) {
    if (accessor.contains("sparse")) refuseGltf(where + " is compressed by Draco, and its accessor is sparse");
    const gltf::ElementType type = elementTypeOf(accessor);
    if (type > gltf::ElementType::vec4)
        refuseGltf(where + " is compressed by Draco, and its accessor holds neither numbers nor vectors");
}

}  // namespace

const char* meshoptNameOf(const Json& object) {
    const Json* extensions = objectAt(object, "extensions", "");
    for (const char* name : kMeshoptNames)
        if (extensions != nullptr && extensions->contains(name)) return name;
    return nullptr;
}

std::optional<MeshoptMode> meshoptModeOf(const std::string& name) {
    if (name == "ATTRIBUTES") return MeshoptMode::attributes;
    if (name == "TRIANGLES") return MeshoptMode::triangles;
    if (name == "INDICES") return MeshoptMode::indices;
    return std::nullopt;
}

std::optional<MeshoptFilter> meshoptFilterOf(const std::string& name) {
    if (name == "NONE") return MeshoptFilter::none;
    if (name == "OCTAHEDRAL") return MeshoptFilter::octahedral;
    if (name == "QUATERNION") return MeshoptFilter::quaternion;
    if (name == "EXPONENTIAL") return MeshoptFilter::exponential;
    return std::nullopt;
}

void checkFallback(const Json& buffer, const std::string& where) {
    const char* name = meshoptNameOf(buffer);
    if (name != nullptr) checkBool(*extensionOf(buffer, name, where), "fallback", where + ".extensions." + name);
}

void checkMeshopt(const Json& document, const Json& view, const std::string& viewName) {
    const char* name = meshoptNameOf(view);
    if (name == nullptr) return;
    const Json* meshopt = extensionOf(view, name, viewName);
    const std::string where = viewName + ".extensions." + name;
    checkMeshoptBytes(document, *meshopt, where);
    const Json* modeName = member(*meshopt, "mode");
    if (modeName == nullptr) refuseGltf(where + " has no mode");
    const auto mode = modeName->is_string() ? meshoptModeOf(modeName->get<std::string>()) : std::nullopt;
    if (!mode) refuseGltf(where + ".mode is " + named(*modeName));
    const Json* filterName = member(*meshopt, "filter");
    auto filter = std::optional(MeshoptFilter::none);
    if (filterName != nullptr)
        filter = filterName->is_string() ? meshoptFilterOf(filterName->get<std::string>()) : std::nullopt;
    if (!filter) refuseGltf(where + ".filter is " + named(*filterName));
    if (mode != MeshoptMode::attributes && filter != MeshoptFilter::none)
        refuseGltf(where + ".filter is " + filterName->dump() + ", and there is none for indices");
    checkMeshoptElements(view, *meshopt, *mode, *filter, where);
}

void checkDraco(const Json& document, const Json& primitive, const std::string& primitiveName) {
    const Json* draco = extensionOf(primitive, "KHR_draco_mesh_compression", primitiveName);
    if (draco == nullptr) return;
    const std::string where = primitiveName + ".extensions.KHR_draco_mesh_compression";
    requireIndex(*draco, "bufferView", targetOf(document, "bufferViews"), where);
    if (wholeOf(primitive, "mode", 4) != 4)
        refuseGltf(primitiveName + " is compressed by Draco, which has lists of triangles, and its mode is " +
                   primitive["mode"].dump());
    const Json& ids = requiredObject(*draco, "attributes", where);
    const Json& accessors = arrayOf(document, "accessors", "");
    for (const auto& [semantic, id] : ids.items()) {
        checkCount(ids, semantic.c_str(), true, std::numeric_limits<uint32_t>::max(), where + ".attributes");
        const Json* accessor = member(primitive["attributes"], semantic.c_str());
        if (accessor == nullptr) refuseGltf(where + ".attributes." + semantic + " is no attribute of the primitive");
        checkDracoAccessor(accessors[accessor->get<size_t>()], primitiveName + ".attributes." + semantic);
    }
    if (const Json* indices = member(primitive, "indices"))
        checkDracoAccessor(accessors[indices->get<size_t>()], primitiveName + ".indices");
}

}  // namespace cleave
