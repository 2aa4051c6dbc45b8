#include "scene/pose_primitive.h"

#include <algorithm>

#include "scene/sides.h"
#include "scene/triangle_count.h"

namespace cleave {
namespace {

const glm::vec4 kWhite(1.0f);

template <typename Value>
void complete(std::vector<Value>& values, size_t size, const Value& without) {
    if (!values.empty()) values.resize(size, without);
}

}  // namespace

void PosablePrimitive::appendTo(PosedScene& posed, const glm::dmat4& toWorld) const {
    const size_t first = posed.triangles.size();
    if (surface_) appendCorners(posed.corners, 3 * first, toWorld);
    const auto appendTriangles = [&](const auto& vertex) {
        for (size_t i = 0; i < count_; ++i) {
            const std::array<size_t, 3> corner = cornersOf(mode_, i);
            posed.triangles.push_back(
                {vertex(indices_[corner[0]]), vertex(indices_[corner[1]]), vertex(indices_[corner[2]])});
        }
    };
    // Vertices that triangles share are placed once, unless there are more of them than corners: they are not in memory
    // then, and a file may announce any number. One that no triangle uses may have a joint that is not there.
    if (vertices_.count() > 3 * count_) {
        appendTriangles([&](size_t i) { return vertices_.at(i, toWorld); });
    } else if (vertices_.hasJoints()) {
        std::vector<std::optional<vec3>> placed(vertices_.count());
        appendTriangles([&](size_t i) {
            if (!placed[i]) placed[i] = vertices_.at(i, toWorld);
            return *placed[i];
        });
    } else {
        std::vector<vec3> placed(vertices_.count());
        for (size_t i = 0; i < placed.size(); ++i) placed[i] = vertices_.at(i, toWorld);
        appendTriangles([&](size_t i) { return placed[i]; });
    }
    posed.materialOf.insert(posed.materialOf.end(), count_, material_);
    if (!surface_) return;
    const bool mirrored = !vertices_.hasJoints() && glm::determinant(glm::dmat3(toWorld)) < 0.0;  // joints place alone
    posed.sides.resize(first + count_, sidesOf(std::span(posed.triangles).subspan(first), mirrored));
}

// Triangles before corner `first` that have nothing are given what they are without.
void PosablePrimitive::appendCorners(CornerAttributes& corners, size_t first, const glm::dmat4& toWorld) const {
    const auto forCorners = [&](const auto& append) {
        for (size_t i = 0; i < count_; ++i)
            for (const size_t corner : cornersOf(mode_, i)) append(indices_[corner]);
    };
    if (surface_->hasNormals()) {
        corners.normals.resize(first, vec3(0.0f));
        const glm::dmat3 ofNode = normalMatrix(toWorld);
        forCorners([&](size_t vertex) {
            const glm::dmat3& matrix = vertices_.hasJoints() ? normalMatrix(vertices_.skinMatrix(vertex)) : ofNode;
            corners.normals.push_back(unitOrZero(matrix * surface_->normal(vertex)));
        });
    }
    for (size_t set = 0; set < 2; ++set)
        if (surface_->hasTexCoords(set)) {
            corners.texCoords[set].resize(first, glm::vec2(0.0f));
            forCorners([&](size_t vertex) { corners.texCoords[set].push_back(surface_->texCoord(set, vertex)); });
        }
    if (surface_->hasColours()) {
        corners.colours.resize(first, kWhite);
        forCorners([&](size_t vertex) { corners.colours.push_back(surface_->colour(vertex)); });
    }
}

void completeCorners(PosedScene& posed) {
    const size_t size = 3 * posed.triangles.size();
    complete(posed.corners.normals, size, vec3(0.0f));
    for (std::vector<glm::vec2>& set : posed.corners.texCoords) complete(set, size, glm::vec2(0.0f));
    complete(posed.corners.colours, size, kWhite);
}

std::optional<PosablePrimitive> MeshPosing::prepare(const gltf::Primitive& primitive, const std::string& where) {
    if (!isPosable(primitive, where)) return std::nullopt;
    const size_t indexCount = indexCountOf(scene, primitive);
    if (primitive.mode < gltf::Mode::triangles) {
        leaveOutLines(primitive.mode, indexCount);
        return std::nullopt;
    }
    if (const size_t surplus = surplusIndices(primitive.mode, indexCount); surplus > 0) {
        leaveOut("surplusIndices", surplus);
        warnings.add(where + " has " + std::to_string(indexCount) + " indices: the last " + std::to_string(surplus) +
                     " make no triangle and are left out");
    }
    PosedVertices vertices(scene, primitive, deformation, where);
    if (deformation.joints != nullptr && vertices.terms() == 1)
        warnings.add(where + " is skinned, and has no JOINTS_0 or no WEIGHTS_0: it is placed by its node");
    const size_t count = triangleCount(primitive.mode, indexCount);
    std::optional<SurfaceVertices> surface;
    if (detail == Detail::corners) surface.emplace(scene, primitive, deformation, where, warnings);
    spend(count, vertices.terms() + (surface ? surface->terms() : 0));
    VertexIndices indices(scene, primitive.indices, vertices.count());
    if (count == 0) return std::nullopt;
    const uint32_t material = primitive.material.value_or(uint32_t(scene.materials.size() - 1));
    return PosablePrimitive(std::move(vertices), std::move(surface), std::move(indices), primitive.mode, count,
                            material);
}

// Returns whether the primitive can be read. If not, it is counted, and a warning says why.
bool MeshPosing::isPosable(const gltf::Primitive& primitive, const std::string& where) {
    const bool hasPositions = primitive.attributes.contains("POSITION");
    if (hasPositions && isReadable(scene, primitive)) {
        const std::vector<uint32_t> accessors = accessorsOf(primitive, deformation);
        if (std::all_of(accessors.begin(), accessors.end(), [&](uint32_t a) { return hasBytes(scene, a); }))
            return true;
    }
    warnings.add(where + (hasPositions ? " is left out: its data is in a buffer that has no URI"
                                       : " is left out: it has no POSITION"));
    leaveOut(hasPositions ? "primitivesWithoutData" : "primitivesWithoutPosition", 1);
    return false;
}

// Counts what each instance leaves out. Counts of files are at most kMaxCount; their product may be more.
void MeshPosing::leaveOut(const char* what, size_t count) {
    constexpr uint64_t kMost = uint64_t(1) << 62;
    uint64_t& sum = leftOut[what];
    sum = count > 0 && instances > kMost / count ? kMost : std::min(kMost, sum + instances * count);
}

void MeshPosing::leaveOutLines(gltf::Mode mode, size_t n) {
    if (mode == gltf::Mode::points) leaveOut("points", n);
    if (mode == gltf::Mode::lines) leaveOut("lines", n / 2);
    if (mode == gltf::Mode::lineStrip) leaveOut("lines", n < 2 ? 0 : n - 1);
    if (mode == gltf::Mode::lineLoop) leaveOut("lines", n < 2 ? 0 : n);
}

void MeshPosing::spend(size_t triangles, size_t terms) {
    if (triangles == 0 || instances == 0) return;
    if (instances > budget.triangles / triangles) refuseGltf("the scene has too many triangles", "split it");
    triangles *= instances;
    budget.triangles -= triangles;
    if (3 * triangles > budget.terms / terms)
        refuseGltf("the morph targets and joints of the scene take too much work", "split it");
    budget.terms -= 3 * triangles * terms;
}

}  // namespace cleave
