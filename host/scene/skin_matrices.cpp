#include "scene/skin_matrices.h"

#include "scene/accessor_view.h"
#include "scene/triangle_count.h"

namespace cleave {

bool hasMatrices(const Scene& scene, uint32_t skin) {
    const gltf::Index matrices = scene.skins[skin].inverseBindMatrices;
    return !matrices || hasBytes(scene, *matrices);
}

const std::vector<glm::dmat4>& SkinMatrices::of(uint32_t index) {
    const auto [entry, isNew] = known_.try_emplace(index);
    std::vector<glm::dmat4>& matrices = entry->second;
    if (!isNew) return matrices;
    const gltf::Skin& skin = scene_.skins[index];
    for (uint32_t joint : skin.joints) matrices.push_back(toWorld_[joint]);
    if (!skin.inverseBindMatrices) return matrices;
    const AccessorValues inverse(scene_, *skin.inverseBindMatrices);
    for (size_t i = 0; i < matrices.size(); ++i) matrices[i] = matrices[i] * inverse.mat4(i);
    return matrices;
}

}  // namespace cleave
