// Any bytes are a Draco mesh, whose triangles and attributes are all there, or an Error of one line. The first four say
// what is asked of the rest: a component type, a number of components, an attribute, whether counts are announced.
#include <array>

#include "base/error.h"
#include "harness.h"
#include "scene/check_format.h"
#include "scene/draco_mesh.h"

namespace cleave::fuzz {
namespace {

constexpr size_t kMostBytes = size_t(1) << 22;

DracoRequest requestOf(const uint8_t* head) {
    using gltf::ComponentType;
    constexpr std::array kTypes = {ComponentType::float32, ComponentType::int8,   ComponentType::uint8,
                                   ComponentType::int16,   ComponentType::uint16, ComponentType::uint32};
    DracoRequest request;
    request.mostBytes = kMostBytes;
    request.attributes = {{head[2] % 4u, kTypes[head[0] % kTypes.size()], 1u + head[1] % 4u, "POSITION"}};
    if (head[3] % 2 == 1) request.vertices = head[3] / 2;
    return request;
}

void requireWhole(const DracoRequest& request, const DracoMesh& mesh) {
    require(!request.vertices || mesh.vertices == *request.vertices, "there are as many vertices as announced");
    require(mesh.indices.size() % 3 == 0, "there are whole triangles");
    for (const uint32_t index : mesh.indices) require(index < mesh.vertices, "every corner is a vertex");
    require(mesh.attributes.size() == 1, "there is the attribute");
    const DracoAttribute& asked = request.attributes[0];
    require(mesh.attributes[0].size() == mesh.vertices * asked.components * componentSize(asked.type),
            "there is a value for each vertex");
}

}  // namespace
}  // namespace cleave::fuzz

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    if (size < 4) return 0;
    const TimeLimit limit;
    const cleave::DracoRequest request = requestOf(data);
    try {
        requireWhole(request, cleave::decompressDracoMesh({data + 4, size - 4}, request, "meshes[0]"));
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    return 0;
}
