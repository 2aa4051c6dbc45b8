#include "scene/shown_parts.h"

#include <algorithm>

#include "scene/instances.h"
#include "scene/node_transforms.h"

namespace cleave {
namespace {

class Finding {
  public:
    explicit Finding(const Scene& scene)
        : scene_(scene), found_{std::vector<bool>(scene.meshes.size()), std::vector<bool>(scene.bufferViews.size())} {}

    ShownParts run() {
        for (const uint32_t node : shownNodes(scene_))
            if (const gltf::Index mesh = scene_.nodes[node].mesh) found_.meshes[*mesh] = true;
        for (size_t i = 0; i < scene_.meshes.size(); ++i) {
            if (!found_.meshes[i]) continue;
            for (const gltf::Primitive& primitive : scene_.meshes[i].primitives) add(primitive);
        }
        for (const gltf::Image& image : scene_.images) addView(image.view);
        for (const gltf::Animation& animation : scene_.animations)
            for (const gltf::AnimationSampler& sampler : animation.samplers) {
                addAccessor(sampler.input);
                addAccessor(sampler.output);
            }
        for (const gltf::Skin& skin : scene_.skins) addAccessor(skin.inverseBindMatrices);
        for (const gltf::Node& node : scene_.nodes) {
            if (!node.instancing) continue;
            for (const gltf::Index accessor : accessorsOf(*node.instancing)) addAccessor(accessor);
        }
        return std::move(found_);
    }

  private:
    void addView(gltf::Index view) {
        if (view) found_.views[*view] = true;
    }
    void addAccessor(gltf::Index index) {
        if (!index) return;
        const gltf::Accessor& accessor = scene_.accessors[*index];
        addView(accessor.view);
        if (!accessor.sparse) return;
        addView(accessor.sparse->indicesView);
        addView(accessor.sparse->valuesView);
    }
    void add(const gltf::Primitive& primitive) {
        for (const auto& [semantic, accessor] : primitive.attributes) addAccessor(accessor);
        for (const gltf::Attributes& target : primitive.targets)
            for (const auto& [semantic, accessor] : target) addAccessor(accessor);
        addAccessor(primitive.indices);
        if (primitive.draco) addView(primitive.draco->view);
    }

    const Scene& scene_;
    ShownParts found_;
};

}  // namespace

ShownParts shownParts(const Scene& scene) { return Finding(scene).run(); }

ShownParts allParts(const Scene& scene) {
    return {std::vector<bool>(scene.meshes.size(), true), std::vector<bool>(scene.bufferViews.size(), true)};
}

size_t unusedMeshes(const ShownParts& shown) {
    return static_cast<size_t>(std::count(shown.meshes.begin(), shown.meshes.end(), false));
}

size_t unusedBuffers(const Scene& scene, const ShownParts& shown) {
    std::vector<bool> used(scene.buffers.size());
    for (size_t i = 0; i < scene.bufferViews.size(); ++i)
        if (shown.views[i]) used[payloadBuffer(scene.bufferViews[i])] = true;
    return static_cast<size_t>(std::count(used.begin(), used.end(), false));
}

}  // namespace cleave
