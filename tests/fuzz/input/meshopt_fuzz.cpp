// Any bytes are a bufferView that is decompressed to the size that is announced, or an Error of one line. The first
// three say how: mode, filter and stride, one of those that the check of a document lets through, and a count.
#include <array>

#include "base/error.h"
#include "harness.h"
#include "scene/decompress.h"
#include "scene/shown_parts.h"

namespace cleave::fuzz {
namespace {

constexpr size_t kMostTriangles = size_t(1) << 15;

struct Way {
    gltf::MeshoptMode mode;
    gltf::MeshoptFilter filter;
    uint64_t stride;
};

Way wayOf(uint8_t choice) {
    using gltf::MeshoptFilter;
    using gltf::MeshoptMode;
    constexpr std::array kWays = {Way{MeshoptMode::attributes, MeshoptFilter::none, 12},
                                  Way{MeshoptMode::attributes, MeshoptFilter::none, 256},
                                  Way{MeshoptMode::attributes, MeshoptFilter::octahedral, 4},
                                  Way{MeshoptMode::attributes, MeshoptFilter::octahedral, 8},
                                  Way{MeshoptMode::attributes, MeshoptFilter::quaternion, 8},
                                  Way{MeshoptMode::attributes, MeshoptFilter::exponential, 12},
                                  Way{MeshoptMode::triangles, MeshoptFilter::none, 2},
                                  Way{MeshoptMode::triangles, MeshoptFilter::none, 4},
                                  Way{MeshoptMode::indices, MeshoptFilter::none, 2},
                                  Way{MeshoptMode::indices, MeshoptFilter::none, 4}};
    return kWays[choice % kWays.size()];
}

Scene sceneOf(const uint8_t* data, size_t size) {
    const Way way = wayOf(data[0]);
    uint64_t count = data[1] + 256u * data[2];
    if (way.mode == gltf::MeshoptMode::triangles) count -= count % 3;
    Scene scene;
    scene.buffers.push_back({{data + 3, data + size}, size - 3});
    const gltf::Meshopt meshopt{0, 0, size - 3, way.stride, count, way.mode, way.filter};
    scene.bufferViews.push_back({0, 0, count * way.stride, 0, meshopt});
    return scene;
}

}  // namespace
}  // namespace cleave::fuzz

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    if (size < 4) return 0;
    const TimeLimit limit;
    cleave::Scene scene = sceneOf(data, size);
    try {
        cleave::decompress(scene, cleave::allParts(scene), kMostTriangles);
        const cleave::gltf::BufferView& view = scene.bufferViews[0];
        require(!view.meshopt && view.buffer == 1, "it is decompressed");
        require(scene.buffers[1].bytes.size() == view.byteLength, "to the size that was announced");
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    return 0;
}
