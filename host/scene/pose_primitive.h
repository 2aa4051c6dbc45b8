// Poses a primitive: placed by a node or a skin, it becomes triangles.
#pragma once

#include <string>

#include "scene/pose.h"
#include "scene/posed_vertices.h"
#include "scene/refuse.h"

namespace cleave {

// The work that is left to a pose. A small file can ask for any amount of either kind.
struct Budget {
    size_t triangles = 0;
    size_t terms = 0;  // accessors read, vertex by vertex
};

// Appends the triangles of a primitive in scene order, or counts it in posed.leftOut; `where` names it in messages.
// Throws Error if it takes more than is left of the budget.
void posePrimitive(const Scene& scene, const gltf::Primitive& primitive, const Placement& placement,
                   const std::string& where, Budget& budget, PosedScene& posed, Warnings& warnings);

}  // namespace cleave
