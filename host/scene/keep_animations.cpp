#include "scene/gltf_keep.h"
#include "scene/keep_values.h"

namespace cleave {
namespace {

gltf::AnimationSampler samplerOf(const Json& source) {
    const std::string interpolation = textOf(source, "interpolation");
    return {*indexOf(source, "input"), *indexOf(source, "output"),
            interpolation == "STEP"          ? gltf::Interpolation::step
            : interpolation == "CUBICSPLINE" ? gltf::Interpolation::cubicSpline
                                             : gltf::Interpolation::linear};
}

gltf::Path pathOf(const std::string& name) {
    return name == "translation" ? gltf::Path::translation
           : name == "rotation"  ? gltf::Path::rotation
           : name == "scale"     ? gltf::Path::scale
                                 : gltf::Path::weights;
}

// Channels whose target is not a node's are left out.
void keepChannel(const Json& source, const std::string& where, gltf::Animation& animation, Warnings& warnings) {
    const Json& target = source["target"];
    if (extensionOf(target, "KHR_animation_pointer", "") != nullptr)
        warnings.add(where + " uses KHR_animation_pointer, which is not supported: it is ignored");
    else if (!target.contains("node"))
        warnings.add(where + " has no target node: it is ignored");
    else
        animation.channels.push_back(
            {*indexOf(source, "sampler"), *indexOf(target, "node"), pathOf(textOf(target, "path"))});
}

}  // namespace

void keepAnimations(const Json& document, Scene& scene, Warnings& warnings) {
    const Json& animations = objectsOf(document, "animations");
    for (size_t i = 0; i < animations.size(); ++i) {
        gltf::Animation animation;
        animation.name = textOf(animations[i], "name");
        for (const Json& sampler : objectsOf(animations[i], "samplers"))
            animation.samplers.push_back(samplerOf(sampler));
        const Json& channels = objectsOf(animations[i], "channels");
        for (size_t c = 0; c < channels.size(); ++c)
            keepChannel(channels[c], at(at("animations", i) + ".channels", c), animation, warnings);
        scene.animations.push_back(std::move(animation));
    }
}

}  // namespace cleave
