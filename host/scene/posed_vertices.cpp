#include "scene/posed_vertices.h"

#include <cmath>

#include "scene/refuse.h"
#include "shared/geometry.h"

namespace cleave {
namespace {

// Transforms a point in double; this is the only place where positions are rounded to float.
vec3 transformed(const glm::dmat4& m, const glm::dvec3& p) {
    const auto row = [&](int i) { return float(transformedBy(m[0][i], m[1][i], m[2][i], m[3][i], p)); };
    return {row(0), row(1), row(2)};
}

}  // namespace

std::vector<JointAccessors> jointSets(const gltf::Primitive& primitive) {
    std::vector<JointAccessors> sets;
    while (true) {
        const std::string set = std::to_string(sets.size());
        const gltf::Index joints = attributeOf(primitive.attributes, "JOINTS_" + set);
        const gltf::Index weights = attributeOf(primitive.attributes, "WEIGHTS_" + set);
        if (!joints || !weights) return sets;
        sets.push_back({*joints, *weights});
    }
}

std::vector<uint32_t> accessorsOf(const gltf::Primitive& primitive, const Deformation& deformation) {
    std::vector<uint32_t> accessors{primitive.attributes.at("POSITION")};
    for (const MorphTarget& target : movingTargets(primitive, deformation, "POSITION"))
        accessors.push_back(target.deltas);
    if (deformation.joints == nullptr) return accessors;
    for (const JointAccessors& set : jointSets(primitive)) {
        accessors.push_back(set.joints);
        accessors.push_back(set.weights);
    }
    return accessors;
}

PosedVertices::PosedVertices(const Scene& scene, const gltf::Primitive& primitive, const Deformation& deformation,
                             const std::string& where)
    : matrices_(deformation.joints), where_(where), positions_(scene, primitive.attributes.at("POSITION")) {
    for (const MorphTarget& target : movingTargets(primitive, deformation, "POSITION"))
        targets_.push_back({AccessorValues(scene, target.deltas), target.weight});
    if (matrices_ == nullptr) return;
    for (const JointAccessors& set : jointSets(primitive))
        joints_.push_back({AccessorIntegers(scene, set.joints), AccessorValues(scene, set.weights)});
}

vec3 PosedVertices::at(size_t vertex, const glm::dmat4& toWorld) const {
    glm::dvec3 position = positions_.vec3(vertex);
    for (const Target& target : targets_) position += target.weight * target.deltas.vec3(vertex);
    return transformed(hasJoints() ? skinMatrix(vertex) : toWorld, position);
}

// Sums joint matrices by weight. Files round weights, so they are divided by their sum; a vertex without any
// follows its first joint. Viewers of the field do both.
glm::dmat4 PosedVertices::skinMatrix(size_t vertex) const {
    const std::vector<glm::dmat4>& matrices = *matrices_;
    glm::dmat4 sum(0.0);
    double weightSum = 0.0;
    for (size_t set = 0; set < joints_.size(); ++set) {
        const glm::uvec4 joint = joints_[set].joints[vertex];
        const glm::dvec4 weight = joints_[set].weights.vec4(vertex);
        for (int i = 0; i < 4; ++i) {
            if (joint[i] >= matrices.size())
                refuseGltf(where_ + ": JOINTS_" + std::to_string(set) + " of vertex " + std::to_string(vertex) +
                           " holds " + std::to_string(joint[i]) + ", and there are " + std::to_string(matrices.size()) +
                           " joints");
            if (weight[i] == 0.0) continue;
            sum += weight[i] * matrices[joint[i]];
            weightSum += std::abs(weight[i]);
        }
    }
    return weightSum == 0.0 ? matrices[joints_[0].joints[vertex][0]] : sum / weightSum;
}

}  // namespace cleave
