// How many triangles primitives make, from counts alone.
#pragma once

#include <array>

#include "scene.h"

namespace cleave {

// Indices of a primitive: those of its accessor, or one for each vertex. It has POSITION.
size_t indexCountOf(const Scene& scene, const gltf::Primitive& primitive);

// Triangles of so many indices; 0 for points and lines.
size_t triangleCount(gltf::Mode mode, size_t indexCount);
// Indices at the end that make no triangle.
size_t surplusIndices(gltf::Mode mode, size_t indexCount);
// Which three indices make triangle i.
std::array<size_t, 3> cornersOf(gltf::Mode mode, size_t i);

// True if the bytes of an accessor (and of its sparse part) are there.
bool hasBytes(const Scene& scene, uint32_t accessor);
// True if the primitive has positions, and they and its indices can be read.
bool isReadable(const Scene& scene, const gltf::Primitive& primitive);

// The triangles that the scene shows. Throws Error if they are more than `most`.
size_t countTriangles(const Scene& scene, size_t most);

}  // namespace cleave
