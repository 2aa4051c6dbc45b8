// Triangles that a skin, morph targets or animations move, for tests of poses.
#pragma once

#include "gltf_text.h"

namespace cleave::test {

using Floats = std::vector<float>;

// The triangle (0,0,0), (1,0,0), (0,1,0) with more attributes, on node 0.
inline Document withAttributes(const std::vector<std::pair<const char*, int>>& attributes, Document document) {
    for (const auto& [semantic, accessor] : attributes) document.primitive()["attributes"][semantic] = accessor;
    return document;
}

// Nodes 1 and 2 are joints. Vertex a follows joint 0, vertex b joint 1, vertex c both alike.
inline Document skinDocument(const Floats& weights = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}) {
    Document document = triangleDocument();
    const int joints =
        document.addAccessor(document.addView(bytesOf<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0})), 5121, 3, "VEC4");
    const int weight = document.addAccessor(document.addView(bytesOf(weights)), 5126, 3, "VEC4");
    document.json["skins"] = {{{"joints", {1, 2}}}};
    document.node()["skin"] = 0;
    document.node()["translation"] = {100, 100, 100};  // does not count
    document.json["nodes"].push_back({{"translation", {10, 0, 0}}});
    document.json["nodes"].push_back({{"translation", {0, 20, 0}}});
    document.json["scenes"][0]["nodes"] = {0, 1, 2};
    return withAttributes({{"JOINTS_0", joints}, {"WEIGHTS_0", weight}}, document);
}

// Target 0 moves vertex a by (1, 2, 3), target 1 vertex b by (0, 0, 8).
inline Document morphDocument() {
    Document document = triangleDocument();
    const int first = document.addPositions({1, 2, 3, 0, 0, 0, 0, 0, 0});
    const int second = document.addPositions({0, 0, 0, 0, 0, 8, 0, 0, 0});
    document.primitive()["targets"] = {{{"POSITION", first}}, {{"POSITION", second}}};
    document.json["meshes"][0]["weights"] = {0.5, 0.25};
    return document;
}

// Animation of node 0 by one channel with keys at the given times.
class Animated {
  public:
    explicit Animated(Document document = triangleDocument()) : document_(std::move(document)) {}

    Animated& add(const char* path, const char* interpolation, const Floats& times, const Floats& values,
                  int node = 0) {
        const int width = path[0] == 'r' ? 4 : path[0] == 'w' ? 1 : 3;
        const int input = document_.addAccessor(document_.addView(bytesOf(times)), 5126, times.size(), "SCALAR");
        const int output =
            document_.addAccessor(document_.addView(bytesOf(values)), 5126, values.size() / size_t(width),
                                  width == 4   ? "VEC4"
                                  : width == 1 ? "SCALAR"
                                               : "VEC3");
        Json& animation = document_.json["animations"][animation_];
        animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
        return *this;
    }
    Animated& next() {
        ++animation_;
        return *this;
    }
    Scene scene() const { return sceneOf(document_); }
    PosedScene at(double seconds, const std::vector<uint32_t>& animations = {0}) const {
        return pose(sceneOf(document_), {seconds, animations});
    }
    Document& document() { return document_; }

  private:
    Document document_;
    size_t animation_ = 0;
};

}  // namespace cleave::test
