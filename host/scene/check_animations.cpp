// Checks animations: a sampler's values belong to its keys, and channels lead to what can move.
#include <array>

#include "scene/check_format.h"
#include "scene/gltf_check.h"
#include "scene/refuse.h"

namespace cleave {
namespace {

struct PathFormat {
    const char* name;
    const Format* format;
};
constexpr std::array kPaths = {PathFormat{"translation", &kVec3Format}, PathFormat{"rotation", &kRotationFormat},
                               PathFormat{"scale", &kVec3Format}, PathFormat{"weights", &kScalarFormat}};

// Returns how many values a key has: a cubic spline has two tangents beside each value.
uint64_t valuesPerKey(const Json& sampler, const std::string& where) {
    const Json* name = member(sampler, "interpolation");
    if (name == nullptr || *name == "LINEAR" || *name == "STEP") return 1;
    if (*name != "CUBICSPLINE") refuseGltf(where + ".interpolation is " + name->dump() + ", which is not known");
    return 3;
}

void checkSampler(const Json& document, const Json& sampler, const std::string& where) {
    requireIndex(sampler, "input", targetOf(document, "accessors"), where);
    requireIndex(sampler, "output", targetOf(document, "accessors"), where);
    const Json& times = checkAccessorValue(document, sampler["input"], kTimeFormat, where + ".input");
    if (countOf(times) == 0) refuseGltf(where + ".input holds no keys");
    const uint64_t least = countOf(times) * valuesPerKey(sampler, where);
    const uint64_t values = countOf(document["accessors"][sampler["output"].get<size_t>()]);
    if (values % least != 0)
        refuseGltf(where + ".output holds " + std::to_string(values) + " values, and " +
                   std::to_string(countOf(times)) + " keys need a multiple of " + std::to_string(least));
}

void checkOutput(const Json& document, const Json& sampler, const Format& format, uint64_t targets,
                 const std::string& where) {
    const Json& values = checkAccessorValue(document, sampler["output"], format, where + ".output");
    const uint64_t keys = countOf(document["accessors"][sampler["input"].get<size_t>()]);
    const uint64_t each = targets * valuesPerKey(sampler, where);
    if (countOf(values) % each != 0 || countOf(values) / each != keys)
        refuseGltf(where + ".output holds " + std::to_string(countOf(values)) + " values, and " + std::to_string(keys) +
                   " keys need " + std::to_string(each) + " each");
}

void checkChannel(const Json& document, const Json& animation, const Json& channel, const std::string& animationName,
                  const std::string& where) {
    const Json& samplers = arrayOf(animation, "samplers", animationName);
    requireIndex(channel, "sampler", {"samplers", samplers.size()}, where);
    const Json& target = requiredObject(channel, "target", where);
    const bool hasNode = checkIndex(target, "node", targetOf(document, "nodes"), where + ".target");
    if (const Json* pointer = extensionOf(target, "KHR_animation_pointer", where + ".target"))
        return checkText(*pointer, "pointer", where + ".target.extensions.KHR_animation_pointer");
    const Json* path = member(target, "path");
    const PathFormat* known = nullptr;
    for (const PathFormat& each : kPaths)
        if (path != nullptr && *path == each.name) known = &each;
    if (known == nullptr) refuseGltf(where + ".target.path is " + (path ? path->dump() : "missing"));
    if (!hasNode) return;
    const bool morphs = known->format == &kScalarFormat;
    const Json& node = document["nodes"][target["node"].get<size_t>()];
    const Json* mesh = member(node, "mesh");
    const uint64_t targets = !morphs ? 1 : mesh == nullptr ? 0 : morphTargetsOf(document, mesh->get<size_t>());
    if (targets == 0) refuseGltf(where + " moves the weights of a node that has no morph targets");
    const size_t sampler = channel["sampler"].get<size_t>();
    checkOutput(document, samplers[sampler], *known->format, targets, at(animationName + ".samplers", sampler));
}

}  // namespace

void checkAnimations(const Json& document) {
    const Json& animations = objectsOf(document, "animations");
    for (size_t i = 0; i < animations.size(); ++i) {
        const std::string where = at("animations", i);
        const Json& samplers = objectsOf(animations[i], "samplers", where);
        for (size_t s = 0; s < samplers.size(); ++s) checkSampler(document, samplers[s], at(where + ".samplers", s));
        const Json& channels = objectsOf(animations[i], "channels", where);
        for (size_t c = 0; c < channels.size(); ++c)
            checkChannel(document, animations[i], channels[c], where, at(where + ".channels", c));
    }
}

}  // namespace cleave
