#include "scene/node_transforms.h"

#include <cmath>

namespace cleave {
namespace {

glm::dmat4 translationMatrix(const glm::dvec3& t) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(t, 1.0);
    return matrix;
}

// Files round quaternions to float, so they are brought to unit length, or they would scale.
glm::dmat4 rotationMatrix(const glm::dvec4& q) {
    glm::dmat4 matrix(1.0);
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (length == 0.0) return matrix;
    const double x = q[0] / length;
    const double y = q[1] / length;
    const double z = q[2] / length;
    const double w = q[3] / length;
    matrix[0] = {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w), 0.0};
    matrix[1] = {2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w), 0.0};
    matrix[2] = {2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y), 0.0};
    return matrix;
}

glm::dmat4 scaleMatrix(const glm::dvec3& s) {
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = s[axis];
    return matrix;
}

std::vector<uint32_t> rootsOf(const Scene& scene) {
    std::vector<bool> hasParent(scene.nodes.size(), false);
    for (const gltf::Node& node : scene.nodes)
        for (uint32_t child : node.children) hasParent[child] = true;
    std::vector<uint32_t> roots;
    for (size_t i = 0; i < scene.nodes.size(); ++i)
        if (!hasParent[i]) roots.push_back(uint32_t(i));
    return roots;
}

// Returns the nodes below `roots`, depth-first, in listed order: parents come before their children.
std::vector<uint32_t> depthFirst(const Scene& scene, const std::vector<uint32_t>& roots) {
    std::vector<uint32_t> order;
    std::vector<uint32_t> waiting(roots.rbegin(), roots.rend());  // a chain may be longer than the program's stack
    while (!waiting.empty()) {
        const uint32_t next = waiting.back();
        waiting.pop_back();
        order.push_back(next);
        const std::vector<uint32_t>& children = scene.nodes[next].children;
        waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
    return order;
}

}  // namespace

std::vector<uint32_t> shownNodes(const Scene& scene) {
    if (scene.scenes.empty()) return depthFirst(scene, rootsOf(scene));
    return depthFirst(scene, scene.scenes[scene.defaultScene.value_or(0)].nodes);
}

glm::dmat4 matrixOf(const gltf::Transform& transform) {
    if (transform.matrix) return *transform.matrix;
    return translationMatrix(transform.translation) * rotationMatrix(transform.rotation) * scaleMatrix(transform.scale);
}

std::vector<glm::dmat4> worldTransforms(const Scene& scene, const std::vector<glm::dmat4>& local) {
    std::vector<glm::dmat4> toWorld(local.size(), glm::dmat4(1.0));
    const std::vector<uint32_t> roots = rootsOf(scene);
    for (uint32_t root : roots) toWorld[root] = glm::dmat4(1.0) * local[root];
    for (uint32_t node : depthFirst(scene, roots))
        for (uint32_t child : scene.nodes[node].children) toWorld[child] = toWorld[node] * local[child];
    return toWorld;
}

}  // namespace cleave
