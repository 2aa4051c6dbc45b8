#include "stability/placed_case.h"

#include <cstring>

#include "stability/aim.h"

namespace cleave {
namespace {

// A mesh of these triangles, without indices, and a node for each place.
Scene sceneOf(std::span<const Triangle> mesh, std::span<const glm::dmat4> places) {
    Scene scene;
    scene.materials.resize(1);
    scene.scenes.resize(1);
    gltf::Buffer& buffer = scene.buffers.emplace_back();
    buffer.byteLength = mesh.size_bytes();
    buffer.bytes.resize(mesh.size_bytes());
    std::memcpy(buffer.bytes.data(), mesh.data(), mesh.size_bytes());
    scene.bufferViews.emplace_back().byteLength = mesh.size_bytes();
    gltf::Accessor& positions = scene.accessors.emplace_back();
    positions.view = 0;
    positions.elementType = gltf::ElementType::vec3;
    positions.count = 3 * mesh.size();
    gltf::Primitive primitive;
    primitive.attributes["POSITION"] = 0;
    scene.meshes.push_back({"", {primitive}, {}});
    for (const glm::dmat4& place : places) {
        scene.scenes[0].nodes.push_back(static_cast<uint32_t>(scene.nodes.size()));
        gltf::Node& node = scene.nodes.emplace_back();
        node.mesh = 0;
        node.transform.matrix = place;
    }
    return scene;
}

glm::dmat4 about(const dvec3& middle, const glm::dmat3& axes, const dvec3& moved) {
    glm::dmat4 place(axes);
    place[3] = glm::dvec4(middle - axes * middle + moved, 1.0);
    return place;
}

// Of unit length and at right angles to each other.
glm::dmat3 turned(Random& random) {
    const dvec3 x = glm::normalize(random.direction());
    const dvec3 y = glm::normalize(glm::cross(x, random.direction()));
    return {x, y, glm::cross(x, y)};
}

}  // namespace

PlacedCase placedCase(std::span<const Triangle> mesh, Random& random) {
    PlacedCase made;
    if (mesh.empty()) return made;
    const Place place = placeOf(makeTriangleSet(mesh));
    const dvec3 middle = 0.5 * (place.lo + place.hi);
    glm::dmat3 any = turned(random);
    for (int axis = 0; axis < 3; ++axis) any[axis] *= random.between(0.5, 2.0);
    const dvec3 aside = 0.25 * place.diagonal * random.direction();
    const glm::dmat3 swapped(dvec3(0.0, -2.0, 0.0), dvec3(0.0, 0.0, 1.0), dvec3(0.5, 0.0, 0.0));
    const Scene scene =
        sceneOf(mesh, std::vector{glm::dmat4(1.0), about(middle, any, aside), about(middle, swapped, dvec3(0.0))});
    made.world = pose(scene).triangles;
    SharedPose shared = poseShared(scene, {}, sharingOf(scene, 1));
    made.instances = instancesOf(shared);
    return made;
}

}  // namespace cleave
