// Scenes whose meshes stand in many places, made in memory.
#pragma once

#include <cstring>
#include <random>

#include "scene/scene.h"
#include "shared/triangle.h"

namespace cleave::test {

class InstancedScene {
  public:
    InstancedScene() {
        scene.name = "instanced";
        scene.materials.resize(1);
        scene.scenes.resize(1);
    }

    // Adds a mesh of these triangles, without indices.
    uint32_t mesh(const std::vector<Triangle>& triangles) {
        gltf::Buffer buffer;
        buffer.byteLength = triangles.size() * sizeof(Triangle);
        buffer.bytes.resize(buffer.byteLength);
        std::memcpy(buffer.bytes.data(), triangles.data(), buffer.byteLength);
        scene.buffers.push_back(buffer);
        gltf::BufferView view;
        view.buffer = uint32_t(scene.buffers.size() - 1);
        view.byteLength = buffer.byteLength;
        scene.bufferViews.push_back(view);
        gltf::Accessor accessor;
        accessor.view = uint32_t(scene.bufferViews.size() - 1);
        accessor.elementType = gltf::ElementType::vec3;
        accessor.count = 3 * triangles.size();
        scene.accessors.push_back(accessor);
        gltf::Primitive primitive;
        primitive.attributes["POSITION"] = uint32_t(scene.accessors.size() - 1);
        scene.meshes.push_back({"", {primitive}, {}});
        return uint32_t(scene.meshes.size() - 1);
    }

    // Adds a node that shows it, below `parent` or at the root.
    uint32_t node(uint32_t meshIndex, const glm::dmat4& matrix, gltf::Index parent = {}) {
        gltf::Node shown;
        shown.mesh = meshIndex;
        shown.transform.matrix = matrix;
        scene.nodes.push_back(shown);
        const auto index = uint32_t(scene.nodes.size() - 1);
        if (parent)
            scene.nodes[*parent].children.push_back(index);
        else
            scene.scenes[0].nodes.push_back(index);
        return index;
    }

    Scene scene;
};

inline glm::dmat4 placeAt(const glm::dvec3& translation, const glm::dmat3& axes) {
    glm::dmat4 matrix(axes);
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

// Turned, mirrored now and then, and scaled by another factor along each axis; around `size`.
inline glm::dmat3 anyAxes(std::mt19937& random, double size) {
    std::normal_distribution<double> gauss;
    std::uniform_real_distribution<double> stretch(0.5, 2.0);
    glm::dvec4 q(gauss(random), gauss(random), gauss(random), gauss(random));
    q /= std::sqrt(glm::dot(q, q));
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    const glm::dmat3 turn(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 2 * (x * y - z * w),
                          1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 2 * (x * z + y * w), 2 * (y * z - x * w),
                          1 - 2 * (x * x + y * y));
    glm::dmat3 scale(0.0);
    for (int axis = 0; axis < 3; ++axis) scale[axis][axis] = size * stretch(random) * (random() % 4 == 0 ? -1.0 : 1.0);
    return turn * scale;
}

inline glm::dvec3 anyPoint(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> unit(-reach, reach);
    const double x = unit(random), y = unit(random), z = unit(random);
    return {x, y, z};
}

}  // namespace cleave::test
