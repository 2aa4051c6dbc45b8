// Keeps meshes, nodes, skins, cameras and lights.
#include <numbers>

#include "scene/gltf_keep.h"
#include "scene/keep_values.h"

namespace cleave {
namespace {

gltf::Attributes attributesOf(const Json& object) {
    gltf::Attributes attributes;
    for (const auto& [semantic, accessor] : object.items()) attributes[semantic] = accessor.get<uint32_t>();
    return attributes;
}

gltf::Primitive primitiveOf(const Json& source) {
    gltf::Primitive primitive;
    primitive.attributes = attributesOf(source["attributes"]);
    primitive.indices = indexOf(source, "indices");
    primitive.material = indexOf(source, "material");
    primitive.mode = gltf::Mode(wholeOf(source, "mode", 4));
    for (const Json& target : objectsOf(source, "targets")) primitive.targets.push_back(attributesOf(target));
    if (const Json* draco = extensionOf(source, "KHR_draco_mesh_compression", ""))
        primitive.draco = gltf::Draco{*indexOf(*draco, "bufferView"), attributesOf((*draco)["attributes"])};
    return primitive;
}

gltf::Transform transformOf(const Json& node) {
    gltf::Transform transform;
    transform.translation = vectorOf<3>(node, "translation", transform.translation);
    transform.rotation = vectorOf<4>(node, "rotation", transform.rotation);
    transform.scale = vectorOf<3>(node, "scale", transform.scale);
    if (const Json* values = member(node, "matrix")) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = (*values)[size_t(i)];  // both are column by column
        transform.matrix = matrix;
    }
    return transform;
}

// A node without attributes of instances, of which nothing says how many there are, is an ordinary one.
std::optional<gltf::Instancing> instancingOf(const Json& document, const Json& node) {
    const Json* extension = extensionOf(node, "EXT_mesh_gpu_instancing", "");
    const Json* attributes = extension == nullptr ? nullptr : member(*extension, "attributes");
    if (attributes == nullptr || attributes->empty()) return std::nullopt;
    const Json& any = document["accessors"][attributes->begin()->get<size_t>()];
    return gltf::Instancing{wholeOf(any, "count"), indexOf(*attributes, "TRANSLATION"),
                            indexOf(*attributes, "ROTATION"), indexOf(*attributes, "SCALE")};
}

gltf::Node nodeOf(const Json& document, const Json& source) {
    gltf::Node node;
    node.name = textOf(source, "name");
    node.children = listOf<uint32_t>(source, "children");
    node.transform = transformOf(source);
    node.mesh = indexOf(source, "mesh");
    node.skin = indexOf(source, "skin");
    node.camera = indexOf(source, "camera");
    if (const Json* light = extensionOf(source, "KHR_lights_punctual", "")) node.light = indexOf(*light, "light");
    node.weights = listOf<double>(source, "weights");
    node.instancing = instancingOf(document, source);
    return node;
}

gltf::Camera cameraOf(const Json& source) {
    gltf::Camera camera;
    camera.name = textOf(source, "name");
    camera.orthographic = source["type"] == "orthographic";
    const Json& shape = source[camera.orthographic ? "orthographic" : "perspective"];
    camera.verticalFov = numberOf(shape, "yfov", 0.0);
    camera.aspectRatio = numberOf(shape, "aspectRatio", 0.0);
    camera.xMagnification = numberOf(shape, "xmag", 0.0);
    camera.yMagnification = numberOf(shape, "ymag", 0.0);
    camera.zNear = numberOf(shape, "znear", 0.0);
    camera.zFar = numberOf(shape, "zfar", camera.zFar);
    return camera;
}

gltf::Light lightOf(const Json& source) {
    gltf::Light light;
    light.name = textOf(source, "name");
    const std::string type = textOf(source, "type");
    light.type = type == "directional" ? gltf::LightType::directional
                 : type == "spot"      ? gltf::LightType::spot
                                       : gltf::LightType::point;
    light.colour = glm::max(vectorOf<3>(source, "color", light.colour), 0.0);
    light.intensity = std::max(numberOf(source, "intensity", light.intensity), 0.0);
    if (const double range = numberOf(source, "range", light.range); range > 0.0) light.range = range;
    if (const Json* spot = member(source, "spot")) {
        light.outerConeAngle = clampedOf(*spot, "outerConeAngle", light.outerConeAngle, 0.0, std::numbers::pi / 2.0);
        light.innerConeAngle = clampedOf(*spot, "innerConeAngle", 0.0, 0.0, light.outerConeAngle);
    }
    return light;
}

}  // namespace

void keepMeshes(const Json& document, Scene& scene) {
    for (const Json& source : objectsOf(document, "meshes")) {
        gltf::Mesh mesh{textOf(source, "name"), {}, listOf<double>(source, "weights")};
        for (const Json& primitive : objectsOf(source, "primitives")) mesh.primitives.push_back(primitiveOf(primitive));
        scene.meshes.push_back(std::move(mesh));
    }
}

void keepNodes(const Json& document, Scene& scene) {
    for (const Json& node : objectsOf(document, "nodes")) scene.nodes.push_back(nodeOf(document, node));
    for (const Json& source : objectsOf(document, "scenes"))
        scene.scenes.push_back({textOf(source, "name"), listOf<uint32_t>(source, "nodes")});
    scene.defaultScene = indexOf(document, "scene");
    for (const Json& skin : objectsOf(document, "skins"))
        scene.skins.push_back({textOf(skin, "name"), listOf<uint32_t>(skin, "joints"),
                               indexOf(skin, "inverseBindMatrices"), indexOf(skin, "skeleton")});
    for (const Json& camera : objectsOf(document, "cameras")) scene.cameras.push_back(cameraOf(camera));
    if (const Json* lights = extensionOf(document, "KHR_lights_punctual", ""))
        for (const Json& light : objectsOf(*lights, "lights")) scene.lights.push_back(lightOf(light));
}

}  // namespace cleave
