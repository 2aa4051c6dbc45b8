#include "scene/check_compression.h"
#include "scene/check_format.h"
#include "scene/gltf_keep.h"
#include "scene/keep_values.h"

namespace cleave {
namespace {

gltf::ComponentType componentTypeOf(const Json& object) {
    return gltf::ComponentType(wholeOf(object, "componentType"));
}

gltf::Sparse sparseOf(const Json& sparse) {
    const Json& indices = sparse["indices"];
    const Json& values = sparse["values"];
    return {wholeOf(sparse, "count"), *indexOf(indices, "bufferView"), wholeOf(indices, "byteOffset"),
            componentTypeOf(indices), *indexOf(values, "bufferView"),  wholeOf(values, "byteOffset")};
}

gltf::Accessor accessorOf(const Json& source) {
    gltf::Accessor accessor;
    accessor.view = indexOf(source, "bufferView");
    accessor.byteOffset = wholeOf(source, "byteOffset");
    accessor.componentType = componentTypeOf(source);
    accessor.elementType = elementTypeOf(source);
    accessor.normalized = boolOf(source, "normalized");
    accessor.count = wholeOf(source, "count");
    if (source.contains("sparse")) accessor.sparse = sparseOf(source["sparse"]);
    return accessor;
}

std::optional<gltf::Meshopt> meshoptOf(const Json& view) {
    const char* name = meshoptNameOf(view);
    if (name == nullptr) return std::nullopt;
    const Json* source = extensionOf(view, name, "");
    gltf::Meshopt meshopt{*indexOf(*source, "buffer"),    wholeOf(*source, "byteOffset"),
                          wholeOf(*source, "byteLength"), wholeOf(*source, "byteStride"),
                          wholeOf(*source, "count"),      meshoptModeOf(textOf(*source, "mode")).value(),
                          gltf::MeshoptFilter::none};
    if (source->contains("filter")) meshopt.filter = meshoptFilterOf(textOf(*source, "filter")).value();
    return meshopt;
}

}  // namespace

Scene keepGltf(const Json& document, Warnings& warnings) {
    Scene scene;
    keepData(document, scene);
    keepMeshes(document, scene);
    keepNodes(document, scene);
    keepMaterials(document, scene, warnings);
    keepAnimations(document, scene, warnings);
    return scene;
}

void keepData(const Json& document, Scene& scene) {
    for (const Json& buffer : objectsOf(document, "buffers"))
        scene.buffers.push_back({{}, wholeOf(buffer, "byteLength")});
    for (const Json& view : objectsOf(document, "bufferViews"))
        scene.bufferViews.push_back({*indexOf(view, "buffer"), wholeOf(view, "byteOffset"), wholeOf(view, "byteLength"),
                                     wholeOf(view, "byteStride"), meshoptOf(view)});
    for (const Json& accessor : objectsOf(document, "accessors")) scene.accessors.push_back(accessorOf(accessor));
}

}  // namespace cleave
