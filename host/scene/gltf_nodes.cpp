#include "scene/gltf_nodes.h"

#include <cmath>

namespace cleave {
namespace {

glm::dmat4 translation(const std::vector<double>& t) {
    glm::dmat4 matrix(1.0);
    if (t.size() == 3) matrix[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
    return matrix;
}

// A quaternion x, y, z, w. Files round it to float, so it is brought to unit length, or it would scale.
glm::dmat4 rotation(const std::vector<double>& q) {
    glm::dmat4 matrix(1.0);
    if (q.size() != 4) return matrix;
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

glm::dmat4 scaling(const std::vector<double>& s) {
    glm::dmat4 matrix(1.0);
    for (int axis = 0; s.size() == 3 && axis < 3; ++axis) matrix[axis][axis] = s[size_t(axis)];
    return matrix;
}

glm::dmat4 localTransform(const tinygltf::Node& node) {
    if (node.matrix.size() != 16) return translation(node.translation) * rotation(node.rotation) * scaling(node.scale);
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[size_t(i)];  // both are column by column
    return matrix;
}

std::vector<int> rootsOf(const tinygltf::Model& model) {
    if (!model.scenes.empty()) return model.scenes[size_t(model.defaultScene < 0 ? 0 : model.defaultScene)].nodes;
    std::vector<bool> hasParent(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (int child : node.children) hasParent[size_t(child)] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (!hasParent[i]) roots.push_back(int(i));
    return roots;
}

}  // namespace

std::vector<PlacedNode> placeNodes(const tinygltf::Model& model) {
    std::vector<PlacedNode> placed;
    std::vector<PlacedNode> waiting;  // a stack of our own: a chain of nodes may be longer than the program's stack
    auto push = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
        for (auto it = nodes.rbegin(); it != nodes.rend(); ++it)
            waiting.push_back({*it, parent * localTransform(model.nodes[size_t(*it)])});
    };
    push(rootsOf(model), glm::dmat4(1.0));
    while (!waiting.empty()) {
        const PlacedNode next = waiting.back();
        waiting.pop_back();
        placed.push_back(next);
        push(model.nodes[size_t(next.node)].children, next.toWorld);
    }
    return placed;
}

}  // namespace cleave
