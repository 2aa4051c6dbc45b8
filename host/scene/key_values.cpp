#include "scene/key_values.h"

#include <algorithm>
#include <cmath>

#include "scene/refuse.h"

namespace cleave {
namespace {

using gltf::Interpolation;

glm::dvec4 normalized(const glm::dvec4& q) {
    const double length = glm::length(q);
    return length > 0.0 ? q / length : q;
}

// glTF 2.0, section C.4. Quaternions that are almost the same are mixed linearly, as the sine of their angle is no
// divisor.
glm::dvec4 slerp(const glm::dvec4& from, const glm::dvec4& to, double share) {
    const glm::dvec4 a = normalized(from);
    glm::dvec4 b = normalized(to);
    double cosine = glm::dot(a, b);
    if (cosine < 0.0) {
        b = -b;
        cosine = -cosine;
    }
    if (cosine > 1.0 - 1e-9) return (1.0 - share) * a + share * b;
    const double angle = std::acos(cosine);
    return (std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

template <typename Value>
Value mixed(const Value& a, const Value& b, double share) {
    return (1.0 - share) * a + share * b;
}

}  // namespace

std::vector<double> keyTimes(const Scene& scene, uint32_t accessor) {
    const AccessorValues input(scene, accessor);
    std::vector<double> times;
    for (size_t i = 0; i < input.count(); ++i) {
        const double time = input.scalar(i);
        if (!std::isfinite(time) || (i > 0 && !(time > times.back())))
            refuseGltf("accessors[" + std::to_string(accessor) + "] holds times of keys, and number " +
                       std::to_string(i) + " is not finite, or not after the one before it");
        times.push_back(time);
    }
    return times;
}

KeyValues::KeyValues(const Scene& scene, const gltf::AnimationSampler& sampler, const std::vector<double>& times)
    : times_(times), values_(scene, sampler.output), interpolation_(sampler.interpolation) {}

KeyValues::Place KeyValues::placeOf(double seconds) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), seconds);
    const size_t next = size_t(after - times_.begin());
    if (next == 0) return {};
    const size_t last = next - 1;
    if (next == times_.size() || times_[last] == seconds) return {last, last, 0.0, 0.0};
    const double step = times_[next] - times_[last];
    return {last, next, (seconds - times_[last]) / step, step};
}

template <typename Value, typename Get>
Value KeyValues::interpolated(const Place& place, size_t each, size_t e, const Get& get) const {
    const bool isCubic = interpolation_ == Interpolation::cubicSpline;
    // A cubic spline's key has `each` tangents in, values, and tangents out.
    const auto element = [&](size_t key, size_t part) {
        return get(isCubic ? (3 * key + part) * each + e : key * each + e);
    };
    const Value from = element(place.from, 1);
    if (place.from == place.to || interpolation_ == Interpolation::step) return from;
    const Value to = element(place.to, 1);
    if (!isCubic && from == to) return from;  // what stays does so to the last bit
    const double s = place.share;
    if (!isCubic) {
        if constexpr (std::is_same_v<Value, glm::dvec4>)
            return slerp(from, to, s);
        else
            return mixed(from, to, s);
    }
    const Value tangentOut = place.step * element(place.from, 2);
    const Value tangentIn = place.step * element(place.to, 0);
    return (2.0 * s * s * s - 3.0 * s * s + 1.0) * from + (s * s * s - 2.0 * s * s + s) * tangentOut +
           (3.0 * s * s - 2.0 * s * s * s) * to + (s * s * s - s * s) * tangentIn;
}

glm::dvec3 KeyValues::vec3At(double seconds) const {
    return interpolated<glm::dvec3>(placeOf(seconds), 1, 0, [&](size_t k) { return values_.vec3(k); });
}

glm::dvec4 KeyValues::rotationAt(double seconds) const {
    return interpolated<glm::dvec4>(placeOf(seconds), 1, 0, [&](size_t k) { return values_.vec4(k); });
}

bool KeyValues::isConstant(size_t width, size_t each) const {
    if (times_.size() <= 1) return true;
    if (interpolation_ == Interpolation::cubicSpline) return false;
    const auto element = [&](size_t k) {
        return width == 4   ? values_.vec4(k)
               : width == 3 ? glm::dvec4(values_.vec3(k), 0.0)
                            : glm::dvec4(values_.scalar(k));
    };
    for (size_t k = each; k < times_.size() * each; ++k)
        if (element(k) != element(k - each)) return false;
    return true;
}

std::vector<double> KeyValues::scalarsAt(double seconds, size_t count) const {
    const Place place = placeOf(seconds);
    std::vector<double> scalars;
    for (size_t e = 0; e < count; ++e)
        scalars.push_back(interpolated<double>(place, count, e, [&](size_t k) { return values_.scalar(k); }));
    return scalars;
}

}  // namespace cleave
