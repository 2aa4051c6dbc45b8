// The record of a mesh in a place.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "shared/placed_mesh.h"

namespace cleave {

// Places a mesh whose tree has the scale 2^meshExponent. `box`: of its vertices in the scaled world, which is the world
// times 2^-sceneExponent. The tree's address and the number of the first triangle are left to the caller.
//
// Returns nothing where rays would find too little of the tree's order: where the error is more than a thousandth of
// the mesh. So it is with a transform that is flat or nearly so, and with a mesh so small and so far from the origin
// that its vertices are rounded to a coarse grid. Nor does it where the numbers of the transform are not finite, or so
// large or small that double might overflow.
std::optional<PlacedMesh> placeMesh(const glm::dmat4& toWorld, int meshExponent, int sceneExponent, const Box& box);

// Places a tree over triangles of the world, with the scale 2^treeExponent.
PlacedMesh placeWorld(int treeExponent, int sceneExponent);

}  // namespace cleave
