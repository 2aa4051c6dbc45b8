// Posing: a scene at a time becomes triangles, cameras and lights in the world.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/scene.h"
#include "shared/triangle.h"

namespace cleave {

// A light of the scene, placed by a node.
struct PlacedLight {
    uint32_t light = 0;  // index into Scene::lights
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  // unit length; a directional light or a spot shines that way
};

// What surfaces look like at the corners of triangles, three for each; empty where no triangle of the scene has it.
struct CornerAttributes {
    std::vector<vec3> normals;                        // in the world, of unit length; zero: the triangle's own
    std::array<std::vector<glm::vec2>, 2> texCoords;  // sets 0 and 1; where a triangle has none, zero
    std::vector<glm::vec4> colours;                   // linear RGBA in [0, 1]; where a triangle has none, white
};

// The mesh of a node, as it is shown.
struct ShownMesh {
    uint32_t node = 0;
    size_t triangles = 0;       // of all its primitives and instances; their numbers follow each other
    size_t nonFinite = 0;       // of them, those with a vertex that is not finite; not counted where meshes are shared
    size_t firstNonFinite = 0;  // the first of these, counted from the mesh's first
};

struct PosedScene {
    std::string name;                         // of the scene, for messages
    std::vector<Triangle> triangles;          // world space, in scene order: the index is the number of a triangle
    std::vector<uint32_t> materialOf;         // of each triangle, an index into Scene::materials
    CornerAttributes corners;                 // empty unless asked for
    std::vector<uint32_t> sides;              // of each triangle, see sides.h; empty unless corners are asked for
    std::vector<ShownMesh> meshes;            // in the order of their triangles
    std::vector<Camera> cameras;              // in the order of the scene's nodes
    std::vector<PlacedLight> lights;          // likewise
    std::map<std::string, uint64_t> leftOut;  // what makes no triangle ("points", "lines", ...) -> how many
    std::vector<std::string> warnings;        // a sentence each
};

struct PoseTime {
    std::optional<double> seconds;     // none: the rest pose, as the file has it
    std::vector<uint32_t> animations;  // played together; where two of them move the same thing, the earlier one counts
};

// How much of a scene is posed: triangles alone, or what surfaces look like at their corners too.
enum class Detail { triangles, corners };

// Returns the animation of that name or, failing that, of that number; of an empty text the first, if any. Throws
// NotFound, listing the scene's animations, if there is no such animation.
std::vector<uint32_t> chooseAnimation(const Scene& scene, const std::string& nameOrIndex);
// Returns all of them.
std::vector<uint32_t> allAnimations(const Scene& scene);

// Poses a scene. Triangles are numbered: default scene (or the first), nodes depth-first in listed order, instances in
// order, primitives in order, triangles in index order. Positions are computed in double and rounded to float once.
// Before an animation's first key its first value holds, after the last key the last one. Throws Error if the payload
// cannot be trusted, or if there are more than `mostTriangles`.
PosedScene pose(const Scene& scene, const PoseTime& time = {}, size_t mostTriangles = kMostTriangles,
                Detail detail = Detail::triangles);

// Poses of the meshes those of some nodes alone, their triangles numbered as if there were no others. Cameras and
// lights are the scene's. Of triangles that are not finite it does not warn.
PosedScene posePart(const Scene& scene, const PoseTime& time, const std::vector<bool>& nodes,
                    size_t mostTriangles = kMostTriangles, Detail detail = Detail::triangles);

// The warning of triangles that have a vertex that is not finite; none if there is none.
std::optional<std::string> nonFiniteWarning(const PosedScene& posed);

}  // namespace cleave
