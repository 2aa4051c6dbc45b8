// What of a mesh decides where it can stand.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "shared/placed_mesh.h"

namespace cleave {

struct MeshShape {
    std::vector<vec3> vertices;  // each position of its triangles that have an area, once
    std::vector<vec3> others;    // of those that have none
    int exponent = 0;            // of its tree: mesh = tree 2^exponent
    // Finite, and none too small for a float in the scale of the tree, beside the largest: bits would be lost.
    bool isKept = true;
    // Triangles whose vertices differ and lie on a line. The mesh's tree is without them, but once they are placed and
    // rounded they may have an area.
    std::vector<uint32_t> slivers;
    size_t noArea = 0;  // triangles that have none wherever they are placed: two vertices are one
};
MeshShape shapeOf(std::span<const Triangle> triangles);

// The triangle in a place, as pose() makes it.
Triangle inPlace(const glm::dmat4& toWorld, const Triangle& t);

// Where the vertices of a mesh are in a place.
struct PlacedExtent {
    Box box = emptyBox();  // of those of triangles that have an area
    Box all = emptyBox();
    uint32_t reach = 0;  // the largest reachOf()
    // Finite, and none is below twice the smallest normal number but 0, where devices round in their own ways.
    bool isPlain = true;
};
PlacedExtent extentOf(const MeshShape& shape, const glm::dmat4& toWorld);

}  // namespace cleave
