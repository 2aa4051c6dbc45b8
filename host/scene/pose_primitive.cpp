#include "scene/pose_primitive.h"

#include <algorithm>

#include "scene/triangle_count.h"

namespace cleave {
namespace {

void countLines(gltf::Mode mode, size_t n, PosedScene& posed) {
    if (mode == gltf::Mode::points) posed.leftOut["points"] += n;
    if (mode == gltf::Mode::lines) posed.leftOut["lines"] += n / 2;
    if (mode == gltf::Mode::lineStrip) posed.leftOut["lines"] += n < 2 ? 0 : n - 1;
    if (mode == gltf::Mode::lineLoop) posed.leftOut["lines"] += n < 2 ? 0 : n;
}

// Returns whether the primitive can be read. If not, it is counted, and a warning says why.
bool isPosable(const Scene& scene, const gltf::Primitive& primitive, const Placement& placement,
               const std::string& where, PosedScene& posed, Warnings& warnings) {
    const bool hasPositions = primitive.attributes.contains("POSITION");
    if (hasPositions && isReadable(scene, primitive)) {
        const std::vector<uint32_t> accessors = accessorsOf(primitive, placement);
        if (std::all_of(accessors.begin(), accessors.end(), [&](uint32_t a) { return hasBytes(scene, a); }))
            return true;
    }
    warnings.add(where + (hasPositions ? " is left out: its data is in a buffer that has no URI"
                                       : " is left out: it has no POSITION"));
    ++posed.leftOut[hasPositions ? "primitivesWithoutData" : "primitivesWithoutPosition"];
    return false;
}

void spend(Budget& budget, size_t triangles, size_t terms) {
    if (triangles > budget.triangles) refuseGltf("the scene has too many triangles", "split it");
    budget.triangles -= triangles;
    if (3 * triangles > budget.terms / terms)
        refuseGltf("the morph targets and joints of the scene take too much work", "split it");
    budget.terms -= 3 * triangles * terms;
}

}  // namespace

void posePrimitive(const Scene& scene, const gltf::Primitive& primitive, const Placement& placement,
                   const std::string& where, Budget& budget, PosedScene& posed, Warnings& warnings) {
    if (!isPosable(scene, primitive, placement, where, posed, warnings)) return;
    const size_t indexCount = indexCountOf(scene, primitive);
    if (primitive.mode < gltf::Mode::triangles) return countLines(primitive.mode, indexCount, posed);
    if (const size_t surplus = surplusIndices(primitive.mode, indexCount); surplus > 0) {
        posed.leftOut["surplusIndices"] += surplus;
        warnings.add(where + " has " + std::to_string(indexCount) + " indices: the last " + std::to_string(surplus) +
                     " make no triangle and are left out");
    }
    const PosedVertices vertices(scene, primitive, placement, where);
    if (placement.joints != nullptr && vertices.terms() == 1)
        warnings.add(where + " is skinned, and has no JOINTS_0 or no WEIGHTS_0: it is placed by its node");
    const size_t count = triangleCount(primitive.mode, indexCount);
    spend(budget, count, vertices.terms());
    const VertexIndices indices(scene, primitive.indices, vertices.count());
    const uint32_t material = primitive.material.value_or(uint32_t(scene.materials.size() - 1));
    for (size_t i = 0; i < count; ++i) {
        const std::array<size_t, 3> corner = cornersOf(primitive.mode, i);
        auto vertex = [&](size_t k) { return vertices[indices[corner[k]]]; };
        posed.triangles.push_back({vertex(0), vertex(1), vertex(2)});
        posed.materialOf.push_back(material);
    }
}

}  // namespace cleave
