// Interpolates the values of an animation's sampler between its keys.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/accessor_view.h"

namespace cleave {

// Returns the times of keys, in seconds. Throws Error if they are not finite or do not increase.
std::vector<double> keyTimes(const Scene& scene, uint32_t accessor);

// A sampler, asked for its value at a time. The scene and `times`, those of its input, outlive it.
class KeyValues {
  public:
    KeyValues(const Scene& scene, const gltf::AnimationSampler& sampler, const std::vector<double>& times);
    glm::dvec3 vec3At(double seconds) const;
    glm::dvec4 rotationAt(double seconds) const;  // a quaternion of any length; linear: along the shorter arc
    std::vector<double> scalarsAt(double seconds, size_t count) const;  // where each key has `count` of them
    // Returns whether values of `width` numbers, `each` at a key, are known to be the same at all times, to the last
    // bit.
    bool isConstant(size_t width, size_t each) const;

  private:
    // A time between keys: `share` of the way from one key to the next one, which are `step` seconds apart. Outside of
    // the keys, and at one, from == to.
    struct Place {
        size_t from = 0;
        size_t to = 0;
        double share = 0.0;
        double step = 0.0;
    };
    Place placeOf(double seconds) const;
    // Interpolates element e of the `each` that a key has. get(k) is element k of the output.
    template <typename Value, typename Get>
    Value interpolated(const Place& place, size_t each, size_t e, const Get& get) const;

    const std::vector<double>& times_;
    AccessorValues values_;
    gltf::Interpolation interpolation_;
};

}  // namespace cleave
