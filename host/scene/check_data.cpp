// Checks buffers, bufferViews and accessors: offsets and counts fit what they lie in.
#include "scene/check_compression.h"
#include "scene/check_format.h"
#include "scene/gltf_check.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

constexpr uint64_t kMaxNumber = uint64_t(1) << 31;

void checkView(const Json& document, size_t index) {
    const Json& view = document["bufferViews"][index];
    const std::string where = at("bufferViews", index);
    requireIndex(view, "buffer", targetOf(document, "buffers"), where);
    checkCount(view, "byteOffset", false, kMaxCount, where);
    checkCount(view, "byteLength", true, kMaxCount, where);
    checkCount(view, "byteStride", false, 252, where);
    if (wholeOf(view, "byteStride") % 4 != 0)
        refuseGltf(where + ".byteStride is " + view["byteStride"].dump() + ", and must be a multiple of 4");
    const size_t buffer = view["buffer"].get<size_t>();
    const uint64_t length = document["buffers"][buffer]["byteLength"].get<uint64_t>();
    const uint64_t end = wholeOf(view, "byteOffset") + view["byteLength"].get<uint64_t>();
    if (end > length)
        refuseGltf(where + " ends at byte " + std::to_string(end) + ", past the end of " + at("buffers", buffer) +
                   ", which has " + std::to_string(length));
    checkMeshopt(document, view, where);
}

// Refuses unless `count` elements of `size` bytes lie within a bufferView, from `offset` on.
void checkExtent(const Json& view, uint64_t offset, uint64_t count, uint64_t size, bool mayStride,
                 const std::string& where) {
    const uint64_t given = mayStride ? wholeOf(view, "byteStride") : 0;
    const uint64_t stride = given != 0 ? given : size;
    if (stride < size) refuseGltf(where + " has elements that are larger than its byteStride");
    const uint64_t fitting = fittingElements(view["byteLength"].get<uint64_t>(), offset, stride, size);
    if (count > fitting)
        refuseGltf(where + " has " + std::to_string(count) + " elements, and its bufferView holds " +
                   std::to_string(fitting));
}

void checkComponentType(const Json& object, const std::string& where) {
    checkCount(object, "componentType", true, kMaxNumber, where);
    if (!isComponentType(object["componentType"].get<uint64_t>()))
        refuseGltf(where + ".componentType is " + object["componentType"].dump() + ", which is not known");
}

// Checks one part of a sparse accessor, which is `count` elements in a bufferView.
void checkSparsePart(const Json& document, const Json& part, uint64_t count, size_t size, const std::string& where) {
    requireIndex(part, "bufferView", targetOf(document, "bufferViews"), where);
    checkCount(part, "byteOffset", false, kMaxCount, where);
    if (size == 0) return;
    const Json& view = document["bufferViews"][part["bufferView"].get<size_t>()];
    checkExtent(view, wholeOf(part, "byteOffset"), count, size, false, where);
}

void checkSparse(const Json& document, const Json& accessor, const Json& sparse, size_t size,
                 const std::string& where) {
    checkCount(sparse, "count", true, countOf(accessor), where);
    const Json& indices = requiredObject(sparse, "indices", where);
    checkComponentType(indices, where + ".indices");
    const auto type = gltf::ComponentType(indices["componentType"].get<int>());
    if (type != gltf::ComponentType::uint8 && type != gltf::ComponentType::uint16 &&
        type != gltf::ComponentType::uint32)
        refuseGltf(where + ".indices are not integers without sign");
    checkSparsePart(document, indices, countOf(sparse), componentSize(type), where + ".indices");
    checkSparsePart(document, requiredObject(sparse, "values", where), countOf(sparse), size, where + ".values");
}

void checkAccessor(const Json& document, size_t index) {
    const Json& accessor = document["accessors"][index];
    const std::string where = at("accessors", index);
    checkCount(accessor, "count", true, kMaxCount, where);
    checkCount(accessor, "byteOffset", false, kMaxCount, where);
    checkComponentType(accessor, where);
    checkBool(accessor, "normalized", where);
    // Elements of a type that is not known have no size; nothing can read them.
    const size_t size = elementSize(elementTypeOf(accessor), gltf::ComponentType(accessor["componentType"].get<int>()));
    if (checkIndex(accessor, "bufferView", targetOf(document, "bufferViews"), where) && size > 0)
        checkExtent(document["bufferViews"][accessor["bufferView"].get<size_t>()], wholeOf(accessor, "byteOffset"),
                    countOf(accessor), size, true, where);
    if (const Json* sparse = objectAt(accessor, "sparse", where))
        checkSparse(document, accessor, *sparse, size, where + ".sparse");
}

}  // namespace

void checkBuffers(const Json& document) {
    const Json& buffers = objectsOf(document, "buffers");
    for (size_t i = 0; i < buffers.size(); ++i) {
        checkCount(buffers[i], "byteLength", true, kMaxCount, at("buffers", i));
        checkText(buffers[i], "uri", at("buffers", i));
        checkFallback(buffers[i], at("buffers", i));
    }
    const size_t views = objectsOf(document, "bufferViews").size();
    for (size_t i = 0; i < views; ++i) checkView(document, i);
}

void checkAccessors(const Json& document) {
    const size_t accessors = objectsOf(document, "accessors").size();
    for (size_t i = 0; i < accessors; ++i) checkAccessor(document, i);
}

}  // namespace cleave
