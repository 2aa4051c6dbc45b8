#include "scene/morph_targets.h"

namespace cleave {

std::vector<MorphTarget> movingTargets(const gltf::Primitive& primitive, const Deformation& deformation,
                                       const std::string& semantic) {
    std::vector<MorphTarget> moving;
    for (size_t i = 0; i < primitive.targets.size(); ++i) {
        const double weight =
            deformation.weights != nullptr && i < deformation.weights->size() ? (*deformation.weights)[i] : 0.0;
        const gltf::Index deltas = attributeOf(primitive.targets[i], semantic);
        if (deltas && weight != 0.0) moving.push_back({*deltas, weight});
    }
    return moving;
}

gltf::Index attributeOf(const gltf::Attributes& attributes, const std::string& semantic) {
    const auto it = attributes.find(semantic);
    return it == attributes.end() ? gltf::Index() : gltf::Index(it->second);
}

size_t morphTargetsOf(const Scene& scene, uint32_t node) {
    const gltf::Index mesh = scene.nodes[node].mesh;
    if (!mesh || scene.meshes[*mesh].primitives.empty()) return 0;
    return scene.meshes[*mesh].primitives.front().targets.size();
}

}  // namespace cleave
