#include "scene/instances.h"

#include <algorithm>

#include "scene/node_transforms.h"
#include "scene/triangle_count.h"

namespace cleave {

std::array<gltf::Index, 3> accessorsOf(const gltf::Instancing& instancing) {
    return {instancing.translations, instancing.rotations, instancing.scales};
}

bool hasInstances(const Scene& scene, const gltf::Node& node) {
    if (!node.instancing || node.skin) return false;
    const std::array<gltf::Index, 3> accessors = accessorsOf(*node.instancing);
    return std::all_of(accessors.begin(), accessors.end(),
                       [&](gltf::Index accessor) { return !accessor || hasBytes(scene, *accessor); });
}

size_t instanceCount(const Scene& scene, const gltf::Node& node) {
    return hasInstances(scene, node) ? node.instancing->count : 1;
}

InstanceTransforms::InstanceTransforms(const Scene& scene, const gltf::Node& node)
    : count_(instanceCount(scene, node)) {
    if (!hasInstances(scene, node)) return;
    const gltf::Instancing& instancing = *node.instancing;
    if (instancing.translations) translations_.emplace(scene, *instancing.translations);
    if (instancing.rotations) rotations_.emplace(scene, *instancing.rotations);
    if (instancing.scales) scales_.emplace(scene, *instancing.scales);
}

// EXT_mesh_gpu_instancing, Transformation Order: translation * rotation * scale, as for nodes.
glm::dmat4 InstanceTransforms::operator[](size_t instance) const {
    gltf::Transform transform;
    if (translations_) transform.translation = translations_->vec3(instance);
    if (rotations_) transform.rotation = rotations_->vec4(instance);
    if (scales_) transform.scale = scales_->vec3(instance);
    return matrixOf(transform);
}

}  // namespace cleave
