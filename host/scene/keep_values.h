// Reads values of a checked document. Where a member is missing, a fallback or nothing stands for it.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/check_values.h"
#include "scene/gltf.h"

namespace cleave {

inline std::string textOf(const Json& object, const char* name) {
    const Json* value = member(object, name);
    return value != nullptr && value->is_string() ? value->get<std::string>() : "";
}

inline gltf::Index indexOf(const Json& object, const char* name) {
    const Json* value = member(object, name);
    return value == nullptr ? gltf::Index() : gltf::Index(value->get<uint32_t>());
}

inline double numberOf(const Json& object, const char* name, double fallback) {
    const Json* value = member(object, name);
    return value == nullptr ? fallback : value->get<double>();
}

// Reads a number of a limited range; what lies outside is brought to its end.
inline double clampedOf(const Json& object, const char* name, double fallback, double least, double most) {
    return std::clamp(numberOf(object, name, fallback), least, most);
}

inline bool boolOf(const Json& object, const char* name) {
    const Json* value = member(object, name);
    return value != nullptr && value->get<bool>();
}

template <int N>
glm::vec<N, double> vectorOf(const Json& object, const char* name, const glm::vec<N, double>& fallback) {
    const Json* value = member(object, name);
    glm::vec<N, double> result = fallback;
    for (int i = 0; value != nullptr && i < N; ++i) result[i] = (*value)[size_t(i)].get<double>();
    return result;
}

template <typename Number>
std::vector<Number> listOf(const Json& object, const char* name) {
    const Json* value = member(object, name);
    return value == nullptr ? std::vector<Number>() : value->get<std::vector<Number>>();
}

}  // namespace cleave
